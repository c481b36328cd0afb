#include "session/telemetry_board.h"

#include <algorithm>

namespace mirada::session {
namespace {

constexpr Micros kPeriod = 50 * kMillisecond;

bool same(const vm::MonitorValue& a, const vm::MonitorValue& b) {
  return a.is_number == b.is_number && a.is_truth == b.is_truth && a.text == b.text;
}

bool same_values(const Telemetry& a, const Telemetry& b) {
  const auto same_variable = [](const auto& x, const auto& y) {
    return x.first == y.first && same(x.second, y.second);
  };
  const auto same_list = [](const auto& x, const auto& y) {
    return x.first == y.first && std::ranges::equal(x.second, y.second, same);
  };
  return std::ranges::equal(a.variables, b.variables, same_variable) &&
         std::ranges::equal(a.lists, b.lists, same_list) && a.list_lengths == b.list_lengths;
}

bool same_talk(const Telemetry& a, const Telemetry& b) {
  const auto same_line = [](const SaidText& x, const SaidText& y) { return x.t == y.t && x.text == y.text; };
  const auto same_fault = [](const vm::BlockFault& x, const vm::BlockFault& y) {
    return x.block == y.block && x.fault.message == y.fault.message && x.fault.args == y.fault.args;
  };
  return a.say == b.say && std::ranges::equal(a.say_log, b.say_log, same_line) &&
         std::ranges::equal(a.faults, b.faults, same_fault);
}

bool same_memory(const Telemetry& a, const Telemetry& b) {
  if (!a.memory || !b.memory) return a.memory == b.memory;
  return a.memory->version == b.memory->version && a.memory->next.pan_rad == b.memory->next.pan_rad &&
         a.memory->next.watching == b.memory->next.watching;
}

bool same_body(const Telemetry& a, const Telemetry& b) {
  return a.percepts == b.percepts && a.X_OR.x_m == b.X_OR.x_m && a.X_OR.y_m == b.X_OR.y_m &&
         a.X_OR.heading_rad == b.X_OR.heading_rad && a.neck.pan_rad == b.neck.pan_rad &&
         a.neck.tilt_rad == b.neck.tilt_rad && a.left_mps == b.left_mps && a.right_mps == b.right_mps &&
         a.camera_trouble_code == b.camera_trouble_code && a.follow_state == b.follow_state &&
         a.follow_id == b.follow_id && a.scene_json == b.scene_json && same_memory(a, b);
}

bool same_blocks(const Telemetry& a, const Telemetry& b) {
  if (!a.running_blocks || !b.running_blocks) return a.running_blocks == b.running_blocks;
  return a.running_blocks == b.running_blocks || *a.running_blocks == *b.running_blocks;
}

bool same_run(const Telemetry& a, const Telemetry& b) {
  return a.run == b.run && a.state == b.state && a.stop_reason == b.stop_reason && same_blocks(a, b) &&
         a.block_executions == b.block_executions;
}

bool same_but_time(const Telemetry& a, const Telemetry& b) {
  return same_run(a, b) && same_body(a, b) && same_talk(a, b) && same_values(a, b);
}

}  // namespace

bool TelemetryBoard::due(Micros now, std::uint64_t run, RunState state) const {
  const std::lock_guard lock(mutex_);
  return now - last_look_ >= kPeriod || latest_->run != run || latest_->state != state;
}

void TelemetryBoard::publish(Telemetry telemetry) {
  last_look_ = telemetry.t;
  if (same_but_time(*latest(), telemetry)) return;
  auto next = std::make_shared<const Telemetry>(std::move(telemetry));
  const std::lock_guard lock(mutex_);
  latest_.swap(next);
}

std::shared_ptr<const Telemetry> TelemetryBoard::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

}  // namespace mirada::session
