#pragma once
#include <atomic>

#include "base/units.h"

namespace mirada {

/// Where time comes from. Injected into whatever needs it; now() never goes back and may be called from any
/// thread.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual Micros now() const = 0;
};

/// Monotonic wall time since this object was made (live).
class SteadyClock final : public Clock {
 public:
  SteadyClock();
  Micros now() const override;

 private:
  Micros start_;
};

/// Time that moves only when it is told to (lockstep and tests).
class ManualClock final : public Clock {
 public:
  Micros now() const override { return now_.load(); }
  void set(Micros t) { now_.store(t); }
  void advance(Micros dt) { now_.fetch_add(dt); }

 private:
  std::atomic<Micros> now_{0};
};

}  // namespace mirada
