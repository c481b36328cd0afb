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
constexpr double kSameBox = 0.2;        // OpenCV's own tolerance when it groups
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

Result<HaarFaces> HaarFaces::open(Search search) {
  const std::string file = cascade_file();
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    return make_fault("faces", messages::face_cascade_missing, {{"file", file}});
  cv::CascadeClassifier cascade;
  if (!cascade.load(file)) return make_fault("faces", messages::face_cascade_broken, {{"file", file}});
  return HaarFaces(std::move(cascade), search);
}

void HaarFaces::search_all(int smallest_px) {
  cascade_.detectMultiScale(gray_, boxes_, levels_, weights_, kScaleStep, kNeighbours, 0,
                            {smallest_px, smallest_px}, {}, true);
}

/// Size by size, so that each is looked for only where it may be.
void HaarFaces::search_textured(int smallest_px) {
  boxes_.clear();
  levels_.clear();
  weights_.clear();
  areas_.look(gray_);
  const int window_px = cascade_.getOriginalWindowSize().width;
  for (double scale = 1;; scale *= kScaleStep) {
    const int side = cvRound(window_px * scale);
    if (side > std::min(gray_.cols, gray_.rows)) break;
    if (side < smallest_px) continue;
    // With one size allowed, the step to the next decides only which one that is.
    for (const cv::Rect& area : areas_.of_side(side))
      search_area(area, {std::max(scale, kScaleStep), side, side}, 0, false);
  }
  const std::vector<cv::Rect> all = boxes_;
  cv::groupRectangles(boxes_, levels_, weights_, kNeighbours, kSameBox);
  look_again(all, smallest_px);
}

/// Adds what is found in this area; `apart`: only what lies apart from what was found before.
void HaarFaces::search_area(const cv::Rect& area, const Sizes& sizes, int neighbours, bool apart) {
  cascade_.detectMultiScale(gray_(area), some_boxes_, some_levels_, some_weights_, sizes.step, neighbours, 0,
                            {sizes.from_px, sizes.from_px}, {sizes.to_px, sizes.to_px}, true);
  const std::size_t before = boxes_.size();
  for (std::size_t i = 0; i < some_boxes_.size(); ++i) {
    const cv::Rect box = some_boxes_[i] + area.tl();
    const auto meets = [&](const cv::Rect& other) { return (box & other).area() > 0; };
    if (apart && std::any_of(boxes_.begin(), boxes_.begin() + static_cast<std::ptrdiff_t>(before), meets))
      continue;
    boxes_.push_back(box);
    levels_.push_back(some_levels_[i]);
    weights_.push_back(some_weights_[i]);
  }
}

/// Where some squares were taken for a face but too few, their neighbours may have been left out: there all
/// are asked.
void HaarFaces::look_again(const std::vector<cv::Rect>& all, int smallest_px) {
  std::vector<cv::Rect> doubtful;
  for (const cv::Rect& box : all) {
    const auto meets = [&](const cv::Rect& other) { return (box & other).area() > 0; };
    if (std::any_of(boxes_.begin(), boxes_.end(), meets)) continue;
    const auto beside = std::find_if(doubtful.begin(), doubtful.end(), meets);
    beside == doubtful.end() ? doubtful.push_back(box) : void(*beside |= box);
  }
  for (const cv::Rect& box : doubtful) {
    const int around = std::min(box.width, box.height) / 4;
    const cv::Rect area =
        cv::Rect(box.x - around, box.y - around, box.width + 2 * around, box.height + 2 * around) &
        cv::Rect({}, gray_.size());
    search_area(area, {kScaleStep, smallest_px, std::max(area.width, area.height)}, kNeighbours, true);
  }
}

std::vector<FaceBox> HaarFaces::find(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3 || std::min(bgr.cols, bgr.rows) < 24) return {};
  cv::cvtColor(bgr, gray_, cv::COLOR_BGR2GRAY);
  const double scale = std::max(1.0, static_cast<double>(gray_.cols) / kWorkWidth_px);
  if (scale > 1) cv::resize(gray_, gray_, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
  const int smallest = std::max(20, static_cast<int>(kSmallestShare * gray_.rows));
  search_ == Search::textured ? search_textured(smallest) : search_all(smallest);
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
