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

bool overlaps_any(const cv::Rect& box, const std::vector<cv::Rect>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const cv::Rect& other) { return (box & other).area() > 0; });
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
    for (const cv::Rect& area : areas_.of_side(side)) add(area, std::max(scale, kScaleStep), 0, side, side);
  }
  const std::vector<cv::Rect> all = boxes_;
  cv::groupRectangles(boxes_, levels_, weights_, kNeighbours, kSameBox);
  look_again(all);
}

void HaarFaces::add(const cv::Rect& area, double scale_step, int neighbours, int from_px, int to_px) {
  cascade_.detectMultiScale(gray_(area), some_boxes_, some_levels_, some_weights_, scale_step, neighbours, 0,
                            {from_px, from_px}, {to_px, to_px}, true);
  for (const cv::Rect& box : some_boxes_) boxes_.push_back(box + area.tl());
  levels_.insert(levels_.end(), some_levels_.begin(), some_levels_.end());
  weights_.insert(weights_.end(), some_weights_.begin(), some_weights_.end());
}

/// Where some squares were taken for a face but too few, their neighbours may have been left out: there all
/// are asked.
void HaarFaces::look_again(const std::vector<cv::Rect>& all) {
  std::vector<cv::Rect> doubtful;
  for (const cv::Rect& box : all) {
    if (overlaps_any(box, boxes_)) continue;
    const auto beside = std::find_if(doubtful.begin(), doubtful.end(),
                                     [&](const cv::Rect& other) { return (box & other).area() > 0; });
    beside == doubtful.end() ? doubtful.push_back(box) : void(*beside |= box);
  }
  for (const cv::Rect& box : doubtful) {
    // Found already round the one before.
    if (overlaps_any(box, boxes_)) continue;
    const int side = std::min(box.width, box.height), around = side / 4;
    const cv::Rect area =
        cv::Rect(box.x - around, box.y - around, box.width + 2 * around, box.height + 2 * around) &
        cv::Rect({}, gray_.size());
    add(area, kScaleStep, kNeighbours, side - around, std::max(area.width, area.height));
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
