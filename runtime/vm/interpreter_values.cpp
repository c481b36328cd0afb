// Instructions over values: boxing, casts, comparison, texts.
#include "vm/digits.h"
#include "vm/handlers.h"
#include "vm/messages.h"
#include "vm/numbers.h"
#include "vm/text.h"

namespace mirada::vm {
#define HANDLER(name)                                                                           \
  const Instr* slow_##name(const Instr* at, [[maybe_unused]] Slot* f, [[maybe_unused]] Slot* g, \
                           [[maybe_unused]] Turn& t)
#define A (any_reg(f, g, at->a))
#define B (any_reg(f, g, at->b))
#define C (any_reg(f, g, at->c))

double slow_mod(double a, double b) {
  const double r = modulo(a, b);
  return r == r ? r : modulo(plain(a), plain(b));
}

HANDLER(math) {
  A.n = apply_math(static_cast<MathFn>(at->c), plain(B.n));
  return at + 1;
}

HANDLER(random) {
  double low = to_number(B.v);
  double high = to_number(C.v);
  if (low > high) std::swap(low, high);
  Random& random = t.machine->host.random();
  if (low == high) {
    A.n = low;
  } else if (is_whole(B.v) && is_whole(C.v)) {
    const double span = high - low + 1;
    const bool exact = std::fabs(low) < 9e15 && std::fabs(high) < 9e15 && std::trunc(low) == low;
    A.n = exact ? static_cast<double>(
                      random.integer(static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)))
                : low + std::floor(random.uniform() * span);
  } else {
    A.n = low + random.uniform() * (high - low);
  }
  return at + 1;
}

HANDLER(less) {
  A.n = less_numbers(behind_digits(B.n), behind_digits(C.n)) ? 1 : 0;
  return at + 1;
}
HANDLER(equal) {
  A.n = equal_numbers(behind_digits(B.n), behind_digits(C.n)) ? 1 : 0;
  return at + 1;
}
HANDLER(both) {
  A.n = B.n != 0 && C.n != 0 ? 1 : 0;
  return at + 1;
}
HANDLER(either) {
  A.n = B.n != 0 || C.n != 0 ? 1 : 0;
  return at + 1;
}
HANDLER(negate) {
  A.n = B.n == 0 ? 1 : 0;
  return at + 1;
}
HANDLER(truth_n) {
  A.n = plain(B.n) != 0 ? 1 : 0;
  return at + 1;
}

HANDLER(box_n) {
  A.v = Value(B.n);
  return at + 1;
}
HANDLER(box_t) {
  A.v = Value(B.n != 0);
  return at + 1;
}
HANDLER(box_digits) {
  A.v = make_text(t.machine->heap, number_to_string(B.n));
  return at + 1;
}
HANDLER(box_mixed) {
  const double x = B.n;
  A.v = is_digits(x) ? make_text(t.machine->heap, number_to_string(behind_digits(x))) : Value(x);
  return at + 1;
}
HANDLER(digits) {
  A.n = digits_of(B.n);
  return at + 1;
}
HANDLER(copy) {
  A.v = B.v;
  return at + 1;
}
/// The register of an argument holds nothing yet that must be given back.
HANDLER(pass) {
  new (&f[at->a]) Value(B.v);
  return at + 1;
}
HANDLER(truth) {
  A.n = to_truth(B.v) ? 1 : 0;
  return at + 1;
}

namespace {

std::size_t text_work(const Value& value) { return value.is_text() ? value.text()->length / 16 : 0; }

}  // namespace

HANDLER(number) {
  A.n = to_number(B.v);
  return charge(at + 1, t, text_work(B.v));
}
HANDLER(less_v) {
  A.n = compare(B.v, C.v) < 0 ? 1 : 0;
  return charge(at + 1, t, std::min(text_work(B.v), text_work(C.v)));
}
HANDLER(equal_v) {
  A.n = compare(B.v, C.v) == 0 ? 1 : 0;
  return charge(at + 1, t, std::min(text_work(B.v), text_work(C.v)));
}

HANDLER(join) {
  Heap& heap = t.machine->heap;
  const Value left = to_text(heap, B.v);
  const Value right = to_text(heap, C.v);
  const std::size_t bytes = joined_bytes(*left.text(), *right.text());
  if (bytes > t.machine->limits.max_text_bytes) {
    return fail(at, t, messages::text_too_long,
                {{"limit", std::to_string(t.machine->limits.max_text_bytes)}});
  }
  A.v = joined(heap, *left.text(), *right.text());
  if (t.machine->out_of_memory()) return fail_memory(at, t);
  return charge(at + 1, t, bytes / 64);
}

HANDLER(letter) {
  Heap& heap = t.machine->heap;
  const Value text = to_text(heap, C.v);
  const double place = std::floor(plain(B.n)) - 1;
  A.v = letter_of(heap, *text.text(), place);
  return at + 1;
}

HANDLER(length) {
  Heap scratch;
  A.n = B.v.is_text() ? B.v.text()->length : to_text(scratch, B.v).text()->length;
  return at + 1;
}

HANDLER(contains) {
  Heap& heap = t.machine->heap;
  const Value whole = to_text(heap, B.v);
  const Value part = to_text(heap, C.v);
  const auto found = contains_text(*whole.text(), *part.text(), t.machine->interrupted);
  if (!found) return out_of_fuel(at, t);
  A.n = *found ? 1 : 0;
  return charge(at + 1, t, whole.text()->length / 8 + part.text()->length / 8);
}

}  // namespace mirada::vm
