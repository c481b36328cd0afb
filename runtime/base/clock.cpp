#include "base/clock.h"

#include <chrono>

namespace mirada {
namespace {

Micros monotonic_now() {
  using std::chrono::duration_cast;
  return duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

SteadyClock::SteadyClock() : start_(monotonic_now()) {}

Micros SteadyClock::now() const { return monotonic_now() - start_; }

}  // namespace mirada
