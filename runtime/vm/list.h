#pragma once
#include <cstddef>
#include <vector>

#include "vm/value.h"

namespace mirada::vm {

/// A Scratch list. One that only ever gets numbers keeps them bare (decided when the program is compiled).
struct List {
  static constexpr std::size_t kMaxItems = 200'000;  ///< Scratch's; items beyond are not added

  bool bare = false;
  bool digits = false;  ///< bare numbers that are texts to whoever looks
  bool mixed = false;   ///< bare, and some of them texts: vm/digits.h
  std::vector<double> numbers;
  std::vector<Value> values;

  std::size_t size() const { return bare ? numbers.size() : values.size(); }
  Value at(Heap& heap, std::size_t i) const;
  void add(const Value& value);
  void set(std::size_t i, const Value& value);
  void insert(std::size_t i, const Value& value);
  void erase(std::size_t i);
  void clear();

 private:
  double bare_number(const Value& value) const;
};

/// Where an index block points: 1-based, 0 = nowhere. `extra` 1 allows the place behind the end (insert).
struct ListIndex {
  std::size_t place = 0;
  bool all = false;
};
/// `draw(n)` gives a whole number from 1 to n, for "random" and "any".
template <class Draw>
ListIndex list_index(const Value& index, std::size_t length, bool accept_all, Draw&& draw) {
  if (index.is_text() && !index.text()->wide) {
    const std::string_view word = index.text()->ascii_view();
    if (accept_all && word == "all") return {0, true};
    if (word == "last") return {length, false};
    if (word == "random" || word == "any") return {length > 0 ? draw(length) : 0, false};
  }
  const double place = std::floor(to_number(index));
  if (!(place >= 1 && place <= static_cast<double>(length))) return {};
  return {static_cast<std::size_t>(place), false};
}

}  // namespace mirada::vm
