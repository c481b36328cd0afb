#include "vision/faces/haar_faces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <opencv2/imgproc.hpp>

#include "vision/messages.h"

namespace mirada::vision {
namespace {

constexpr const char* kFolders[] = {"/usr/share/opencv4/haarcascades", "/usr/share/opencv/haarcascades",
                                    "/usr/local/share/opencv4/haarcascades"};
constexpr const char* kFile = "haarcascade_frontalface_alt2.xml";
constexpr double kScaleStep = 1.15;
constexpr int kNeighbours = 3;
constexpr double kSmallestShare = 0.1;  // of the picture's height
constexpr double kBeside = 0.08;        // of the square, at each side of the face
constexpr int kWorkWidth_px = 320;      // larger pictures are looked at in this size

std::string cascade_file() {
  std::error_code error;
  for (const char* folder : kFolders) {
    const std::filesystem::path file = std::filesystem::path(folder) / kFile;
    if (std::filesystem::exists(file, error)) return file.string();
  }
  return std::string(kFolders[0]) + "/" + kFile;
}

}  // namespace

Result<HaarFaces> HaarFaces::open() {
  const std::string file = cascade_file();
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    return make_fault("faces", messages::face_cascade_missing, {{"file", file}});
  cv::CascadeClassifier cascade;
  if (!cascade.load(file)) return make_fault("faces", messages::face_cascade_broken, {{"file", file}});
  return HaarFaces(std::move(cascade));
}

std::vector<FaceBox> HaarFaces::find(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3 || std::min(bgr.cols, bgr.rows) < 24) return {};
  cv::cvtColor(bgr, gray_, cv::COLOR_BGR2GRAY);
  const double scale = std::max(1.0, static_cast<double>(gray_.cols) / kWorkWidth_px);
  if (scale > 1) cv::resize(gray_, gray_, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
  const int smallest = std::max(20, static_cast<int>(kSmallestShare * gray_.rows));
  cascade_.detectMultiScale(gray_, boxes_, levels_, weights_, kScaleStep, kNeighbours, 0,
                            {smallest, smallest}, {}, true);
  std::vector<FaceBox> out;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const cv::Rect& box = boxes_[i];
    // The last stage's margin has no fixed scale; squashed so that more is surer and 1 is never reached.
    const double score = 1 / (1 + std::exp(-std::max(0.0, weights_[i]) / 2));
    // The cascade's square is wider than the face.
    const double side = box.width * scale;
    out.push_back({{box.x * scale + kBeside * side, box.y * scale, (1 - 2 * kBeside) * side, side}, score});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const FaceBox& a, const FaceBox& b) { return a.score > b.score; });
  return out;
}

}  // namespace mirada::vision
