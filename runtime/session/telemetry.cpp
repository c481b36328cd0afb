#include "session/telemetry.h"

namespace mirada::session {

const char* to_string(RunState state) {
  switch (state) {
    case RunState::idle:
      return "idle";
    case RunState::running:
      return "running";
    case RunState::paused:
      return "paused";
  }
  return "";
}

const char* to_string(StopReason reason) {
  switch (reason) {
    case StopReason::none:
      return "none";
    case StopReason::stop_button:
      return "stop_button";
    case StopReason::program_ended:
      return "program_ended";
    case StopReason::owner_lost:
      return "owner_lost";
    case StopReason::camera_lost:
      return "camera_lost";
    case StopReason::stuck:
      return "stuck";
    case StopReason::put_back:
      return "put_back";
    case StopReason::replaced:
      return "replaced";
    case StopReason::faulted:
      return "faulted";
  }
  return "";
}

}  // namespace mirada::session
