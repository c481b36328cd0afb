// How long finding the lines of the simulated green field takes, on one thread. JSON out.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/lines/line_finder.h"
#include "world/simulation.h"

namespace mirada {
namespace {

constexpr int kRounds = 20;

std::vector<Frame> pictures() {
  const RobotConfig robot = *robot_by_name("mirada-sim");
  world::Simulation room(*world::world_by_name("green-field"), robot, 1);
  room.camera().enable(true);
  std::vector<Frame> out;
  for (int i = 0; i < 24; ++i) {
    room.carry_to({-1.5 + 0.13 * i, i % 2 == 0 ? -0.3 : 0.4, 0.5 * i});
    std::optional<Frame> newest;
    for (int steps = 0; steps < 20; ++steps) {
      room.step(10 * kMillisecond);
      if (auto frame = room.camera().poll()) newest = std::move(frame);
    }
    if (newest) out.push_back(std::move(*newest));
  }
  return out;
}

void measure(const std::vector<Frame>& frames, cv::Size size, bool last) {
  RobotConfig robot = *robot_by_name("mirada-sim");
  vision::LineFinder finder(robot, 0.05, 0.05);
  std::vector<double> times_ms;
  std::size_t found = 0;
  for (int round = 0; round < kRounds; ++round) {
    for (Frame frame : frames) {
      if (frame.bgr.size() != size) {
        cv::Mat scaled;
        cv::resize(frame.bgr, scaled, size);
        frame.bgr = scaled;
      }
      const auto start = std::chrono::steady_clock::now();
      found += finder.find(frame, {}).size();
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      if (round > 0) times_ms.push_back(taken.count());
    }
  }
  std::sort(times_ms.begin(), times_ms.end());
  std::printf(
      R"(  {"picture": "%dx%d", "pictures": %zu, "pieces_a_picture": %.1f, "median_ms": %.3f, "p99_ms": %.3f})"
      "%s\n",
      size.width, size.height, frames.size(),
      static_cast<double>(found) / kRounds / static_cast<double>(frames.size()),
      times_ms[times_ms.size() / 2], times_ms[times_ms.size() * 99 / 100], last ? "" : ",");
}

}  // namespace
}  // namespace mirada

int main() {
  cv::setNumThreads(1);
  const auto frames = mirada::pictures();
  std::puts("[");
  mirada::measure(frames, {320, 240}, false);
  mirada::measure(frames, {640, 480}, true);
  std::puts("]");
}
