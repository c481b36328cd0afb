#include "vm/list.h"

#include "vm/digits.h"
#include "vm/numbers.h"

namespace mirada::vm {

Value List::at(Heap& heap, std::size_t i) const {
  if (!bare) return values[i];
  const bool text = digits || is_digits(numbers[i]);
  return text ? make_text(heap, number_to_string(behind_digits(numbers[i]))) : Value(numbers[i]);
}

/// A bare list only ever gets numbers, or texts that print as one.
double List::bare_number(const Value& value) const {
  if (value.is_number()) return value.number();
  return mixed ? digits_of(to_number(value)) : to_number(value);
}

void List::add(const Value& value) {
  if (size() >= kMaxItems) return;
  if (bare) {
    numbers.push_back(bare_number(value));
  } else {
    values.push_back(value);
  }
}

void List::set(std::size_t i, const Value& value) {
  if (bare) {
    numbers[i] = bare_number(value);
  } else {
    values[i] = value;
  }
}

void List::insert(std::size_t i, const Value& value) {
  const auto at = static_cast<std::ptrdiff_t>(i);
  if (bare) {
    numbers.insert(numbers.begin() + at, bare_number(value));
    if (numbers.size() > kMaxItems) numbers.pop_back();
  } else {
    values.insert(values.begin() + at, value);
    if (values.size() > kMaxItems) values.pop_back();
  }
}

void List::erase(std::size_t i) {
  const auto at = static_cast<std::ptrdiff_t>(i);
  if (bare) {
    numbers.erase(numbers.begin() + at);
  } else {
    values.erase(values.begin() + at);
  }
}

void List::clear() {
  numbers.clear();
  values.clear();
}

}  // namespace mirada::vm
