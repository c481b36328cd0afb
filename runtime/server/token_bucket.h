#pragma once
#include <algorithm>

#include "base/units.h"

namespace mirada::server {

/// Lets `per_second` things through on average and `burst` at once. Not thread-safe.
class TokenBucket {
 public:
  TokenBucket(double per_second, double burst) : per_second_(per_second), burst_(burst), tokens_(burst) {}

  /// Takes one token; false when there is none. `now` never goes back.
  bool take(Micros now) {
    tokens_ = std::min(burst_, tokens_ + seconds(now - last_) * per_second_);
    last_ = now;
    if (tokens_ < 1) return false;
    tokens_ -= 1;
    return true;
  }

 private:
  double per_second_;
  double burst_;
  double tokens_;
  Micros last_ = 0;
};

}  // namespace mirada::server
