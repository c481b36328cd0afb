#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/fault.h"
#include "memory/snapshot.h"
#include "model/geometry.h"
#include "model/percepts.h"
#include "vm/machine.h"

namespace mirada::session {

enum class RunState { idle, running, paused };

/// Why nothing runs any more; the editor says it in words.
enum class StopReason {
  none,
  stop_button,
  program_ended,
  owner_lost,
  camera_lost,
  stuck,
  put_back,
  replaced,
  faulted
};
const char* to_string(RunState state);
const char* to_string(StopReason reason);

struct SaidText {
  Micros t = 0;
  std::string text;
};

/// All that a viewer may see of a session at one moment. Immutable once published.
struct Telemetry {
  Micros t = 0;           ///< the robot's clock
  std::uint64_t run = 0;  ///< counts the starts
  RunState state = RunState::idle;
  StopReason stop_reason = StopReason::none;
  std::shared_ptr<const std::vector<std::string>> running_blocks;  ///< null: none
  std::map<std::string, vm::MonitorValue> variables;
  std::map<std::string, std::vector<vm::MonitorValue>> lists;  ///< their first items
  std::map<std::string, std::size_t> list_lengths;
  std::string say;                     ///< the bubble now; "" = none
  std::vector<SaidText> say_log;       ///< the newest 100 of this run
  std::vector<vm::BlockFault> faults;  ///< of this run, the newest 100
  std::shared_ptr<const Percepts> percepts;
  std::string follow_state;  ///< following, predicted, searching, gone; "" when nobody is followed
  int follow_id = 0;         ///< the number of the face that is followed
  Pose2 X_OR;                ///< odometry
  NeckAngles neck;
  double left_mps = 0, right_mps = 0;              ///< commanded
  std::string camera_trouble_code;                 ///< "" when pictures come
  std::string scene_json;                          ///< room from above, filled by rig; "" on a real robot
  std::shared_ptr<const memory::Snapshot> memory;  ///< null while its panel is closed
  std::uint64_t block_executions = 0;
};

/// The newest picture, ready to send.
struct Picture {
  std::uint64_t frame = 0;
  Micros t_exposure = 0;
  int width_px = 0;
  int height_px = 0;
  std::string jpeg;
};

}  // namespace mirada::session
