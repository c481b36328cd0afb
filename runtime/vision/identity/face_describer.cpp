#include "vision/identity/face_describer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numeric>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "vision/identity/local_patterns.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

constexpr double kSmallestFace_px = 20;
constexpr double kDimFace = 60;  // mean grey level
constexpr double kLitFace = 110;
constexpr double kMostTurned = 0.5;  // the nose off the eyes' middle, in distances between the eyes
constexpr int kLandmarkSide_px = 64;
constexpr int kLandmarks = 68;
constexpr int kFaceSide_px = 112;
// Where the feature network wants eyes, nose and the mouth's corners.
using Point = std::complex<double>;  // x + iy: a turn with a scale is one factor
using FivePoints = std::array<Point, 5>;
const FivePoints kWanted{Point{38.2946, 51.6963}, Point{73.5318, 51.5014}, Point{56.0252, 71.7366},
                         Point{41.5493, 92.3655}, Point{70.7299, 92.2041}};

std::string network_file(const char* name) { return (data_folder("build/models") / name).string(); }

bool networks_there() {
  std::error_code error;
  return std::filesystem::is_regular_file(network_file("face-landmarks.onnx"), error) &&
         std::filesystem::is_regular_file(network_file("face-feature.onnx"), error);
}

std::optional<FaceFeature> normalised(FaceFeature feature) {
  double sum = 0;
  for (const float value : feature) sum += static_cast<double>(value) * value;
  if (!(sum > 0) || !std::isfinite(sum)) return std::nullopt;
  for (float& value : feature) value /= static_cast<float>(std::sqrt(sum));
  return feature;
}

/// The square about a face's box that the landmark network was trained on.
cv::Rect2d square_about(const cv::Rect2d& face) {
  const double side = face.height;
  return {face.x + face.width / 2 - side / 2, face.y, side, side};
}

cv::Mat cut(const cv::Mat& bgr, const cv::Rect2d& area, int side_px) {
  const double scale = side_px / area.width;
  const cv::Matx23d to(scale, 0, -area.x * scale, 0, scale, -area.y * scale);
  cv::Mat out;
  if (scale < 0.6) {
    // Far smaller than it was: with an average of the pixels, not one of them.
    const cv::Rect whole =
        cv::Rect(cvFloor(area.x), cvFloor(area.y), cvCeil(area.width), cvCeil(area.height));
    const cv::Rect in = whole & cv::Rect({}, bgr.size());
    cv::Mat padded;
    cv::copyMakeBorder(bgr(in), padded, in.y - whole.y, whole.br().y - in.br().y, in.x - whole.x,
                       whole.br().x - in.br().x, cv::BORDER_REPLICATE);
    cv::resize(padded, out, {side_px, side_px}, 0, 0, cv::INTER_AREA);
    return out;
  }
  cv::warpAffine(bgr, out, to, {side_px, side_px}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

/// Faces in dim light become as light as others.
void lighten(cv::Mat& bgr) {
  const cv::Scalar mean = cv::mean(bgr);
  const double level = (mean[0] + mean[1] + mean[2]) / 3;
  if (level < kDimFace) bgr.convertTo(bgr, -1, kLitFace / std::max(level, 8.0));
}

/// Eyes, nose and the mouth's corners out of 68 landmarks.
FivePoints five_points(const float* at, const cv::Rect2d& square) {
  const auto mean = [&](std::initializer_list<int> points) {
    Point sum;
    for (const int i : points) sum += Point(at[2 * i], at[2 * i + 1]);
    return Point(square.x, square.y) + square.width * sum / static_cast<double>(points.size());
  };
  return {mean({37, 38, 40, 41}), mean({43, 44, 46, 47}), mean({30}), mean({48, 60}), mean({54, 64})};
}

Point middle_of(const FivePoints& points) {
  return std::accumulate(points.begin(), points.end(), Point()) / static_cast<double>(points.size());
}

/// The turn, scale and shift that bring these points nearest to the wanted ones.
cv::Matx23d to_wanted(const FivePoints& points) {
  const Point from = middle_of(points);
  const Point to = middle_of(kWanted);
  Point both;
  double own = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    both += std::conj(points[i] - from) * (kWanted[i] - to);
    own += std::norm(points[i] - from);
  }
  const Point turn = both / own;
  const Point shift = to - turn * from;
  return {turn.real(), -turn.imag(), shift.real(), turn.imag(), turn.real(), shift.imag()};
}

}  // namespace

double likeness(const FaceFeature& a, const FaceFeature& b) {
  if (a.size() != b.size()) return 0;
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

FaceDescriber FaceDescriber::open() {
  FaceDescriber out;
  if (!networks_there()) return out;
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    out.landmarks_ = cv::dnn::readNetFromONNX(network_file("face-landmarks.onnx"));
    out.feature_ = cv::dnn::readNetFromONNX(network_file("face-feature.onnx"));
    out.landmarks_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    out.feature_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    // They are used only if they run here.
    const cv::Mat grey(kFaceSide_px, kFaceSide_px, CV_8UC3, cv::Scalar::all(100));
    (void)out.upright(grey, cv::Rect2d(10, 10, 80, 90));
    (void)out.feature_of(grey);
    out.kind_ = "network-1";
  } catch (const cv::Exception&) {
    out = FaceDescriber();
  }
  return out;
}

/// Strangers come near 0 by the networks (at most 0.1 among the photographs that may be used here), the same
/// person months apart between 0.5 and 0.8; by patterns strangers come near 0.5, the same person to 0.7 to
/// 0.95.
double FaceDescriber::same_from() const { return kind_ == "network-1" ? 0.46 : 0.69; }

std::optional<cv::Mat> FaceDescriber::upright(const cv::Mat& bgr, const cv::Rect2d& face_px) {
  const cv::Rect2d square = square_about(face_px);
  cv::Mat small = cut(bgr, square, kLandmarkSide_px);
  lighten(small);
  cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  landmarks_.setInput(cv::dnn::blobFromImage(small, 1 / 256.0));
  const cv::Mat answer = landmarks_.forward();
  if (answer.total() != 2 * kLandmarks || answer.type() != CV_32F) return std::nullopt;
  const FivePoints points = five_points(answer.ptr<float>(), square);
  const Point eyes = points[1] - points[0];
  if (!(std::abs(eyes) > 0.1 * square.width)) return std::nullopt;
  // The nose, seen from between the eyes, in distances between the eyes.
  const Point nose = (points[2] - (points[0] + points[1]) / 2.0) / eyes;
  if (std::abs(nose.real()) > kMostTurned) return std::nullopt;
  const cv::Matx23d warp = to_wanted(points);
  cv::Mat source = bgr;
  // Averaged before it is made much smaller.
  if (const double scale = std::hypot(warp(0, 0), warp(1, 0)); scale < 0.5)
    cv::GaussianBlur(bgr, source, {0, 0}, 0.4 / scale);
  cv::Mat out;
  cv::warpAffine(source, out, warp, {kFaceSide_px, kFaceSide_px}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return out;
}

std::optional<FaceFeature> FaceDescriber::feature_of(const cv::Mat& upright_bgr) {
  feature_.setInput(cv::dnn::blobFromImage(upright_bgr, 1 / 128.0, {}, cv::Scalar::all(127), true));
  const cv::Mat answer = feature_.forward();
  if (answer.type() != CV_32F) return std::nullopt;
  return normalised(FaceFeature(answer.ptr<float>(), answer.ptr<float>() + answer.total()));
}

std::optional<FaceFeature> FaceDescriber::describe(const cv::Mat& bgr, const cv::Rect2d& face_px) {
  if (bgr.empty() || bgr.type() != CV_8UC3 || std::min(face_px.width, face_px.height) < kSmallestFace_px)
    return std::nullopt;
  const cv::Rect2d seen = face_px & cv::Rect2d(0, 0, bgr.cols, bgr.rows);
  if (seen.area() < 0.85 * face_px.area()) return std::nullopt;
  if (kind_ == "network-1") {
    auto face = upright(bgr, face_px);
    if (!face) return std::nullopt;
    lighten(*face);
    return feature_of(*face);
  }
  cv::Mat face = cut(bgr, square_about(face_px), kPatternSide_px);
  cv::cvtColor(face, face, cv::COLOR_BGR2GRAY);
  return normalised(local_patterns(face));
}

std::optional<Fault> face_identity_fallback() {
  if (networks_there()) return std::nullopt;
  return make_fault("faces", messages::face_identity_plain, {}, Severity::warning);
}

}  // namespace mirada::vision
