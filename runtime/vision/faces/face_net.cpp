#include "vision/faces/face_net.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

// What the network was trained on: RGB, (value - 127) / 128.
constexpr double kMean = 127;
constexpr double kSpread = 128;
const cv::Size kSizes[] = {{320, 240}, {640, 480}};  // of its family; a file knows only one
// Frontal faces of 24 px and more score above 0.9, false ones spread evenly from 0.5 to 1. Below 18 px a
// patch of texture passes more easily for a face.
constexpr double kDim = 70;  // mean grey level
constexpr double kLit = 105;
constexpr double kMostGain = 4;
constexpr float kLeastScore = 0.85F;
constexpr float kLeastSmallScore = 0.9F;
constexpr double kSmall_px = 18;
constexpr double kSameFace = 0.35;  // overlap of two boxes, of their union
constexpr double kInside = 0.75;    // overlap of the smaller box

struct Answer2 {
  cv::Mat corners;  // n x 4: left, top, right, bottom, as shares of the picture
  cv::Mat scores;   // n x 2: background, face
};

/// By the shapes, whatever the outputs' names.
std::optional<Answer2> told_apart(const std::vector<cv::Mat>& outputs) {
  Answer2 out;
  for (const cv::Mat& blob : outputs) {
    if (blob.dims != 3 || blob.size[0] != 1 || blob.type() != CV_32F) continue;
    const cv::Mat flat(blob.size[1], blob.size[2], CV_32F, const_cast<float*>(blob.ptr<float>()));
    if (blob.size[2] == 4) out.corners = flat.clone();
    if (blob.size[2] == 2) out.scores = flat.clone();
  }
  const bool fits = !out.corners.empty() && out.corners.rows == out.scores.rows;
  return fits ? std::optional(out) : std::nullopt;
}

std::optional<Answer2> answer_of(cv::dnn::Net& net, const cv::Mat& blob) {
  std::vector<cv::Mat> outputs;
  net.setInput(blob);
  net.forward(outputs, net.getUnconnectedOutLayersNames());
  return told_apart(outputs);
}

bool runs_at(cv::dnn::Net& net, cv::Size size) {
  try {
    const cv::Mat blank(size, CV_8UC3, cv::Scalar::all(kMean));
    return answer_of(net, cv::dnn::blobFromImage(blank)).has_value();
  } catch (const cv::Exception&) {
    return false;
  }
}

bool same_face(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double both = (a & b).area();
  return both > kSameFace * (a.area() + b.area() - both) || both > kInside * std::min(a.area(), b.area());
}

/// Of boxes about one face the surest stays.
std::vector<FaceBox> one_a_face(std::vector<FaceBox> boxes) {
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const FaceBox& a, const FaceBox& b) { return a.score > b.score; });
  std::vector<FaceBox> out;
  for (const FaceBox& box : boxes) {
    const auto known = [&](const FaceBox& other) { return same_face(box.box_px, other.box_px); };
    if (std::none_of(out.begin(), out.end(), known)) out.push_back(box);
  }
  return out;
}

}  // namespace

std::string FaceNet::default_file() { return (data_folder("build/models") / "faces.onnx").string(); }

Result<FaceNet> FaceNet::open(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return make_fault("faces", messages::face_net_missing, {{"file", file}});
  // A file that is no such network is said in our words, not in OpenCV's.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(file);
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    for (const cv::Size size : kSizes)
      if (runs_at(net, size)) return FaceNet(net, size);
  } catch (const cv::Exception&) {
  }
  return make_fault("faces", messages::face_net_broken, {{"file", file}});
}

std::vector<FaceBox> FaceNet::find(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3) return {};
  const double scale =
      std::min(static_cast<double>(size_.width) / bgr.cols, static_cast<double>(size_.height) / bgr.rows);
  const cv::Size inner(std::clamp(cvRound(bgr.cols * scale), 1, size_.width),
                       std::clamp(cvRound(bgr.rows * scale), 1, size_.height));
  fitted_.create(size_, CV_8UC3);
  fitted_.setTo(cv::Scalar::all(kMean));
  cv::Mat part = fitted_(cv::Rect({}, inner));
  if (inner == bgr.size()) {
    bgr.copyTo(part);
  } else {
    cv::resize(bgr, part, inner, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  }
  // In dim light the network sees less than there is.
  const cv::Scalar mean = cv::mean(part);
  const double level = (mean[0] + mean[1] + mean[2]) / 3;
  if (level < kDim) part.convertTo(part, -1, std::min(kLit / std::max(level, 1.0), kMostGain));
  cv::dnn::blobFromImage(fitted_, blob_, 1 / kSpread, {}, cv::Scalar::all(kMean), true);
  const std::optional<Answer2> answer = answer_of(net_, blob_);
  if (!answer) return {};
  std::vector<FaceBox> boxes;
  const cv::Rect2d picture(0, 0, bgr.cols, bgr.rows);
  for (int i = 0; i < answer->scores.rows; ++i) {
    const float score = answer->scores.at<float>(i, 1);
    if (score < kLeastScore) continue;
    const float* corner = answer->corners.ptr<float>(i);
    const cv::Point2d from(corner[0] * size_.width, corner[1] * size_.height);
    const cv::Point2d to(corner[2] * size_.width, corner[3] * size_.height);
    if (score < kLeastSmallScore && to.x - from.x < kSmall_px) continue;
    const cv::Rect2d box = cv::Rect2d(from / scale, to / scale) & picture;
    if (box.area() > 0) boxes.push_back({box, score});
  }
  return one_a_face(std::move(boxes));
}

}  // namespace mirada::vision
