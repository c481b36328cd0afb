#pragma once
#include <deque>
#include <string>
#include <string_view>

#include "base/units.h"

namespace mirada::server {

/// Six symbols that nobody mistakes for one another, from the system's random source.
std::string make_join_code();

/// Equal without telling by its time how much of it is. Case, spaces and dashes do not matter.
bool same_code(std::string_view typed, std::string_view code);

/// At most `most` tries in any `window`. Not thread-safe.
class TryLimit {
 public:
  TryLimit(std::size_t most, Micros window) : most_(most), window_(window) {}
  bool allows(Micros now);
  void count(Micros now) { tries_.push_back(now); }

 private:
  std::size_t most_;
  Micros window_;
  std::deque<Micros> tries_;
};

}  // namespace mirada::server
