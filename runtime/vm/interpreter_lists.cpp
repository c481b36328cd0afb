// Instructions over lists, but the hot ones for number lists.
#include <algorithm>
#include <optional>

#include "vm/digits.h"
#include "vm/handlers.h"
#include "vm/messages.h"

namespace mirada::vm {
namespace {

#define HANDLER(name) \
  const Instr* slow_##name(const Instr* at, [[maybe_unused]] Slot* f, [[maybe_unused]] Slot* g, Turn& t)
#define A (any_reg(f, g, at->a))
#define B (any_reg(f, g, at->b))
#define C (any_reg(f, g, at->c))

constexpr std::size_t kItemsUnasked = 4096;  // between two looks whether the tick is wanted to end
constexpr std::size_t kMostListText = 10u << 20;

ListIndex index_in(Turn& t, const Value& index, std::size_t length, bool accept_all = false) {
  return list_index(index, length, accept_all, [&](std::size_t n) {
    return static_cast<std::size_t>(t.machine->host.random().integer(1, static_cast<std::int64_t>(n)));
  });
}

/// Items past the place that is touched are moved.
std::size_t moving_work(const List& list, std::size_t from) {
  return (list.size() - std::min(from, list.size())) / 32;
}

std::size_t bytes_of(const List& list) { return (list.numbers.capacity() + list.values.capacity()) * 8; }

/// Runs a change of a list, keeps the count of bytes, and faults when the memory is spent.
template <class Change>
const Instr* changed(const Instr* at, Turn& t, List& list, std::size_t work, Change&& change) {
  const std::size_t before = bytes_of(list);
  change();
  t.machine->list_bytes += bytes_of(list) - before;
  if (t.machine->out_of_memory()) return fail_memory(at, t);
  return charge(at + 1, t, work);
}

bool equals_item(const List& list, std::size_t i, const Value& wanted) {
  if (!list.bare) return compare(list.values[i], wanted) == 0;
  return compare(Value(behind_digits(list.numbers[i])), wanted) == 0;
}

/// The place of the first item that equals `wanted`, from 0; the length without one. Nothing when somebody
/// wants the tick to end: the search is begun again when the script goes on.
std::optional<std::size_t> find(const Turn& t, const List& list, const Value& wanted) {
  if (list.bare && wanted.is_number()) {
    const double number = wanted.number();
    const auto it = std::find_if(list.numbers.begin(), list.numbers.end(),
                                 [&](double item) { return equal_numbers(behind_digits(item), number); });
    return static_cast<std::size_t>(it - list.numbers.begin());
  }
  std::size_t i = 0;
  while (i < list.size() && !equals_item(list, i, wanted)) {
    if (++i % kItemsUnasked == 0 && hurried(t)) return std::nullopt;
  }
  return i;
}

/// Empties a list. Many texts take long to give back: a Stop in between leaves the rest.
const Instr* cleared(const Instr* at, Turn& t, List& list) {
  const std::size_t work = list.values.size() / 8;
  while (list.values.size() > kItemsUnasked) {
    list.values.resize(list.values.size() - kItemsUnasked);
    if (hurried(t)) return out_of_fuel(at, t);
  }
  list.clear();
  return charge(at + 1, t, work);
}

Value at_place(Turn& t, const List& list, std::size_t place) {
  if (place < 1 || place > list.size()) return make_text(t.machine->heap, std::string_view());
  return list.at(t.machine->heap, place - 1);
}

}  // namespace

const Instr* slow_add_number(const Instr* at, List& list, double number, Turn& turn) {
  return changed(at, turn, list, list.size() / 64, [&] {
    if (list.numbers.size() < List::kMaxItems) list.numbers.push_back(number);
  });
}

HANDLER(list_add) {
  List& list = list_at(t, at->a);
  return changed(at, t, list, 0, [&] { list.add(B.v); });
}

HANDLER(list_get_at) {
  const List& list = list_at(t, at->b);
  const double place = std::floor(plain(C.n));
  const bool there = place >= 1 && place <= static_cast<double>(list.size());
  A.v = at_place(t, list, there ? static_cast<std::size_t>(place) : 0);
  return at + 1;
}

HANDLER(list_get) {
  const List& list = list_at(t, at->b);
  A.v = at_place(t, list, index_in(t, C.v, list.size()).place);
  return at + 1;
}

HANDLER(list_set) {
  List& list = list_at(t, at->a);
  const std::size_t place = index_in(t, B.v, list.size()).place;
  if (place >= 1) list.set(place - 1, C.v);
  return at + 1;
}

HANDLER(list_insert) {
  List& list = list_at(t, at->a);
  const std::size_t place = index_in(t, B.v, list.size() + 1).place;
  if (place < 1) return at + 1;
  return changed(at, t, list, moving_work(list, place), [&] { list.insert(place - 1, C.v); });
}

HANDLER(list_delete) {
  List& list = list_at(t, at->a);
  const ListIndex index = index_in(t, B.v, list.size(), true);
  if (index.all) return cleared(at, t, list);
  if (index.place < 1) return at + 1;
  const std::size_t work = moving_work(list, index.place);
  list.erase(index.place - 1);
  return charge(at + 1, t, work);
}

HANDLER(list_clear) { return cleared(at, t, list_at(t, at->a)); }

HANDLER(list_find) {
  const List& list = list_at(t, at->b);
  const auto i = find(t, list, C.v);
  if (!i) return out_of_fuel(at, t);
  A.n = *i < list.size() ? static_cast<double>(*i + 1) : 0;
  return charge(at + 1, t, *i / 2);
}

HANDLER(list_has) {
  const List& list = list_at(t, at->b);
  const auto i = find(t, list, C.v);
  if (!i) return out_of_fuel(at, t);
  A.n = *i < list.size() ? 1 : 0;
  return charge(at + 1, t, *i / 2);
}

/// Joined without a space when every item is a text of one letter, else with spaces.
HANDLER(list_text) {
  const List& list = list_at(t, at->b);
  Heap& heap = t.machine->heap;
  bool letters = true;
  std::string out;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i % kItemsUnasked == kItemsUnasked - 1 && hurried(t)) return out_of_fuel(at, t);
      const Value item = list.at(heap, i);
      letters = letters && item.is_text() && item.text()->length == 1;
      if (round == 0) {
        if (!letters) break;
        continue;
      }
      if (!letters && i > 0) out += ' ';
      out += to_string(item);
      if (out.size() > kMostListText) {
        return fail(at, t, messages::text_too_long, {{"limit", std::to_string(kMostListText)}});
      }
    }
  }
  A.v = make_text(heap, out);
  return charge(at + 1, t, list.size() + out.size() / 32);
}

}  // namespace mirada::vm
