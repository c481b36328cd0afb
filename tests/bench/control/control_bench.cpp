// Two latencies of the live robot, in this process, on the wall clock; prints JSON.
//  stop: from the call of Station::stop() until it returns (the wheels are at zero then), while pictures are
//  encoded for
//        ten readers and the program never waits.
//  frame_to_command: from the moment when a picture can be read until the wheels get the command that a block
//  program
//        made of it.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "program_text.h"
#include "rig/shipped_packs.h"
#include "rig/station_factory.h"
#include "session/session.h"

namespace {

using namespace mirada;
using Wall = std::chrono::steady_clock;

double ms_since(Wall::time_point start) {
  return std::chrono::duration<double, std::milli>(Wall::now() - start).count();
}

nlohmann::json summary(std::vector<double> values_ms) {
  std::ranges::sort(values_ms);
  const auto part = [&](double p) {
    return values_ms[static_cast<std::size_t>(p * static_cast<double>(values_ms.size() - 1))];
  };
  return {{"count", values_ms.size()},
          {"p50_ms", part(0.5)},
          {"p99_ms", part(0.99)},
          {"max_ms", values_ms.back()}};
}

nlohmann::json measure_stop(int times) {
  rig::StationOptions options;
  options.world = "sala-1";
  auto station = std::move(rig::make_station(options).value());
  station->want({true, true, true, true});
  std::atomic<bool> reading{true};
  std::vector<std::thread> readers;
  for (int i = 0; i < 10; ++i) {
    readers.emplace_back([&] {
      while (reading) {
        (void)station->telemetry();
        (void)station->picture();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  const std::string busy =
      rig::program(rig::flag(rig::set_speeds("60", "60", rig::forever(rig::say("busy")))));
  std::vector<double> values_ms;
  for (int i = 0; i < times; ++i) {
    (void)station->start(busy);
    std::this_thread::sleep_for(std::chrono::milliseconds(60 + i % 17));
    const auto called = Wall::now();
    station->stop(session::StopReason::stop_button);
    values_ms.push_back(ms_since(called));
    (void)station->put_back();
  }
  reading = false;
  for (std::thread& reader : readers) reader.join();
  return summary(values_ms);
}

/// Offers a picture every 50 ms; every other one shows a free way.
class BlinkingCamera final : public hal::Camera {
 public:
  explicit BlinkingCamera(const Clock& clock) : clock_(&clock) {}
  std::optional<Frame> poll() override {
    if (clock_->now() < next_) return std::nullopt;
    offered = next_;
    next_ += 50 * kMillisecond;
    return Frame{cv::Mat(), clock_->now(), ++number_};
  }
  Status health() const override { return Ok{}; }
  void enable(bool) override {}

  Micros offered = 0;  ///< when the newest picture could be read first

 private:
  const Clock* clock_;
  Micros next_ = 0;
  std::uint64_t number_ = 0;
};

/// Remembers when its command last changed its sign.
class WatchedDrive final : public hal::Drive {
 public:
  explicit WatchedDrive(const Clock& clock) : clock_(&clock) {}
  void set(const WheelSpeeds& speeds) override {
    if (speeds.left_mps > last_.left_mps && !rising_) changed = clock_->now();
    if (speeds.left_mps < last_.left_mps && rising_) changed = clock_->now();
    if (speeds.left_mps != last_.left_mps) rising_ = speeds.left_mps > last_.left_mps;
    last_ = speeds;
  }
  void stop() override { last_ = {}; }
  hal::Odometry odometry() const override { return {}; }

  Micros changed = 0;

 private:
  const Clock* clock_;
  WheelSpeeds last_;
  bool rising_ = false;
};

robot::Detectors blinking() {
  robot::Detectors out;
  out.sonar = [](const Frame& frame, const NeckAngles&, const Pose2&) {
    SonarPercept percept;
    percept.frame = frame.number;
    percept.t_exposure = frame.t_exposure;
    const bool clear = frame.number % 2 == 0;
    for (int degree = -31; degree <= 31; ++degree) {
      percept.readings.push_back(
          {rad(degree), clear ? Answer::clear : Answer::blocked, clear ? 2.0 : 0.2, 0.01});
    }
    return percept;
  };
  return out;
}

std::string blink_program() {
  const std::string clear =
      rig::block({"vision_way_clear", "clear", rig::number_input("DISTANCE", "40"), ""});
  const std::string choose =
      rig::block({"control_if_else", "if",
                  rig::block_input("CONDITION", clear) + ", " +
                      rig::block_input("SUBSTACK", rig::set_speeds("100", "100")) + ", " +
                      rig::block_input("SUBSTACK2", rig::set_speeds("-100", "-100")),
                  ""});
  return rig::program(rig::flag(rig::forever(choose)));
}

nlohmann::json measure_frame_to_command(double seconds_long) {
  const SteadyClock clock;
  const RobotConfig config = robot_by_name("mirada-sim").value();
  BlinkingCamera camera(clock);
  WatchedDrive drive(clock);
  robot::Robot robot(config, {&camera, &drive, nullptr}, blinking(), robot::Timing::live, clock, clock);
  auto link = std::make_shared<blocks::Link>();
  const packs::PackSet packs = rig::shipped_packs(link);
  session::Session session(robot, packs.catalog, {});
  link->robot = &robot;
  link->host = &session.host();
  const auto program = vm::load_program(blink_program(), packs.catalog);
  session.start(program.value(), "", robot.safety().stop_and_permit());
  std::vector<double> values_ms;
  Micros last_change = 0;
  for (Micros next = 0; seconds(clock.now()) < seconds_long; next += 10 * kMillisecond) {
    std::this_thread::sleep_for(std::chrono::microseconds(std::max<Micros>(0, next - clock.now())));
    robot.observe();
    if ((next / (10 * kMillisecond)) % 2 == 0) session.tick();
    if (drive.changed != last_change && clock.now() > kSecond) {
      values_ms.push_back(static_cast<double>(drive.changed - camera.offered) / 1000.0);
    }
    last_change = drive.changed;
  }
  return summary(values_ms);
}

}  // namespace

int main() {
  const nlohmann::json out = {
      {"bench", "control"}, {"stop", measure_stop(200)}, {"frame_to_command", measure_frame_to_command(20)}};
  std::cout << out.dump(1) << "\n";
  return 0;
}
