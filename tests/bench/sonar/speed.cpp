// Time a picture takes: our sonar (floor model updated), the paper's method and cv::Canny, on the same
// pictures in the same run: sonar_speed [ROUNDS] [PICTURES...]. Rendered rooms and photographs are reported
// apart, and how the sonar grows with the picture's size. JSON out, microseconds.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "../../runtime/vision/scene.h"
#include "vision/visual_sonar.h"

namespace mirada::bench {
namespace {

double median_us(int rounds, std::size_t pictures, const std::function<void(std::size_t)>& work) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < pictures; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      work(i);
      const auto end = std::chrono::steady_clock::now();
      times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return std::round(10 * times[times.size() / 2]) / 10;
}

/// The paper's idea, written anew: HSV range, every fifth column, bottom to top, the first masked pixel.
int paper_sonar(const cv::Mat& bgr, cv::Mat& hsv, cv::Mat& mask) {
  cv::cvtColor(bgr, hsv, cv::COLOR_BGR2HSV);
  cv::inRange(hsv, cv::Scalar(20, 50, 100), cv::Scalar(90, 235, 210), mask);
  int sum = 0;
  for (int u = 0; u < mask.cols; u += 5) {
    int v = mask.rows - 1;
    while (v >= 0 && mask.at<std::uint8_t>(v, u) == 0) --v;
    sum += v;
  }
  return sum;
}

nlohmann::json measure(const std::vector<cv::Mat>& pictures, const RobotConfig& robot, int rounds) {
  cv::Mat hsv, mask, gray, edges;
  // One sonar a picture: each goes on with the floor that it knows, as on a robot.
  std::vector<std::unique_ptr<vision::VisualSonar>> sonars;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    sonars.push_back(std::make_unique<vision::VisualSonar>(robot));
  std::uint64_t number = 0;
  volatile int sink = 0;
  const double sonar = median_us(rounds, pictures.size(), [&](std::size_t i) {
    ++number;
    sink = sink + static_cast<int>(sonars[i]->look(Frame{pictures[i], 0, number}, {}, {}).readings.size());
  });
  const double paper = median_us(rounds, pictures.size(),
                                 [&](std::size_t i) { sink = sink + paper_sonar(pictures[i], hsv, mask); });
  const double canny_gray = median_us(rounds, pictures.size(), [&](std::size_t i) {
    cv::cvtColor(pictures[i], gray, cv::COLOR_BGR2GRAY);
    cv::Canny(gray, edges, 50, 150);
  });
  std::vector<cv::Mat> grays(pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) cv::cvtColor(pictures[i], grays[i], cv::COLOR_BGR2GRAY);
  const double canny =
      median_us(rounds, pictures.size(), [&](std::size_t i) { cv::Canny(grays[i], edges, 50, 150); });
  return {{"pictures", pictures.size()},
          {"sonar_us", sonar},
          {"paper_us", paper},
          {"canny_us", canny},
          {"canny_with_gray_us", canny_gray}};
}

}  // namespace
}  // namespace mirada::bench

int main(int argc, char** argv) {
  using namespace mirada;
  cv::setNumThreads(1);
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 1;
  std::vector<cv::Mat> rendered;
  for (int floor = 0; floor < 7; ++floor) {
    for (int light = 0; light < 2; ++light) {
      const auto scene =
          testing::draw_scene(static_cast<testing::Floor>(floor), static_cast<testing::Light>(light), 7);
      rendered.push_back(testing::render(scene, *robot, {}, {}));
    }
  }
  std::vector<cv::Mat> photographs;
  for (int i = 2; i < argc; ++i) {
    const cv::Mat picture = cv::imread(argv[i]);
    if (picture.empty()) continue;
    cv::Mat scaled;
    cv::resize(picture, scaled, {320, 240}, 0, 0, cv::INTER_AREA);
    photographs.push_back(scaled);
  }
  nlohmann::json out{{"rendered_320x240", bench::measure(rendered, *robot, rounds)}};
  if (!photographs.empty()) out["photographs_320x240"] = bench::measure(photographs, *robot, rounds);
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(1280, 960)}) {
    std::vector<cv::Mat> large;
    for (const cv::Mat& picture : rendered) {
      cv::resize(picture, large.emplace_back(), size, 0, 0, cv::INTER_LINEAR);
    }
    out["rendered_" + std::to_string(size.width) + "x" + std::to_string(size.height)] =
        bench::measure(large, *robot, std::max(1, rounds / 4));
  }
  std::puts(out.dump(1).c_str());
  return 0;
}
