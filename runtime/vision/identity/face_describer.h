#pragma once
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn/dnn.hpp>

#include "base/fault.h"

namespace mirada::vision {

/// What tells one face from another: a vector of length 1. Two are compared by their scalar product.
using FaceFeature = std::vector<float>;
double likeness(const FaceFeature& a, const FaceFeature& b);

/// Turns the picture of a face into a feature: with two networks (landmarks, to put the face upright, and the
/// feature), or where they are missing with histograms of local binary patterns. One thread, deterministic.
class FaceDescriber {
 public:
  /// The networks that scripts/run fetches; without them, or when they do not run, the plain way.
  static FaceDescriber open();
  static FaceDescriber plain() { return FaceDescriber(); }

  /// Features of different kinds cannot be compared: "network-1" or "patterns-1".
  const std::string& kind() const { return kind_; }
  /// From this likeness on two features are of the same person.
  double same_from() const;
  /// Nothing when the face is too small, cut off by the picture's edge or turned away.
  std::optional<FaceFeature> describe(const cv::Mat& bgr, const cv::Rect2d& face_px);

 private:
  FaceDescriber() = default;
  std::optional<cv::Mat> upright(const cv::Mat& bgr, const cv::Rect2d& face_px);
  std::optional<FaceFeature> feature_of(const cv::Mat& upright_bgr);

  std::string kind_ = "patterns-1";
  cv::dnn::Net landmarks_;
  cv::dnn::Net feature_;
};

/// Said where faces are told apart in the plain way; nothing when the networks are there.
std::optional<Fault> face_identity_fallback();

}  // namespace mirada::vision
