#pragma once
#include <memory>
#include <mutex>

#include "session/telemetry.h"

namespace mirada::session {

/// Where the newest telemetry hangs: at most 20 a second, at once when the run's state changes, and nothing
/// new when only time has passed. latest() from any thread; the rest on the control thread.
class TelemetryBoard {
 public:
  /// Whether it is worth making one now.
  bool due(Micros now, std::uint64_t run, RunState state) const;
  void publish(Telemetry telemetry);
  /// Never null.
  std::shared_ptr<const Telemetry> latest() const;

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Telemetry> latest_ = std::make_shared<const Telemetry>();
  Micros last_look_ = -kSecond;
};

}  // namespace mirada::session
