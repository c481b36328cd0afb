// How long finding AprilTags takes, with and without tags in the picture, on one thread. JSON out.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/tags/tag_spotter.h"

namespace mirada {
namespace {

cv::Mat printed_tag(int id) {
  apriltag_family_t* family = tag36h11_create();
  image_u8_t* drawn = apriltag_to_image(family, static_cast<std::uint32_t>(id));
  cv::Mat out;
  cv::resize(
      cv::Mat(drawn->height, drawn->width, CV_8UC1, drawn->buf, static_cast<std::size_t>(drawn->stride)), out,
      {}, 20, 20, cv::INTER_NEAREST);
  std::free(drawn->buf);
  std::free(drawn);
  tag36h11_destroy(family);
  return out;
}

/// A noisy picture with so many tags in a row, each a sixth of it wide.
cv::Mat picture(cv::Size size, int tags) {
  cv::Mat gray(size, CV_8UC1, cv::Scalar(140));
  for (int i = 0; i < tags; ++i) {
    cv::Mat tag;
    cv::resize(printed_tag(i), tag, {size.width / 6, size.width / 6}, 0, 0, cv::INTER_AREA);
    tag.copyTo(gray(cv::Rect({size.width * i / 5 + 4, size.height / 3}, tag.size())));
  }
  cv::GaussianBlur(gray, gray, {}, 0.8);
  cv::Mat noise(size, CV_8UC1);
  cv::RNG random(5);
  random.fill(noise, cv::RNG::NORMAL, 10, 3);
  gray += noise;
  cv::Mat bgr;
  cv::cvtColor(gray, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

void measure(cv::Size size, int tags, bool last) {
  RobotConfig robot;
  robot.camera = robot.camera.scaled_to(size.width, size.height);
  vision::TagSpotter spotter(robot, 0.08);
  Frame frame;
  frame.bgr = picture(size, tags);
  std::vector<double> times_ms;
  std::size_t found = 0;
  for (int i = 0; i < 120; ++i) {
    const auto start = std::chrono::steady_clock::now();
    found = spotter.look(frame, {}).size();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    if (i >= 20) times_ms.push_back(taken.count());
  }
  std::sort(times_ms.begin(), times_ms.end());
  std::printf(R"(  {"picture": "%dx%d", "tags": %d, "found": %zu, "median_ms": %.2f, "p90_ms": %.2f})"
              "%s\n",
              size.width, size.height, tags, found, times_ms[times_ms.size() / 2],
              times_ms[times_ms.size() * 9 / 10], last ? "" : ",");
}

}  // namespace
}  // namespace mirada

int main() {
  cv::setNumThreads(1);
  std::puts("[");
  for (const cv::Size size : {cv::Size(320, 240), cv::Size(640, 480), cv::Size(1280, 720)}) {
    for (const int tags : {0, 1, 4}) mirada::measure(size, tags, size.width == 1280 && tags == 4);
  }
  std::puts("]");
}
