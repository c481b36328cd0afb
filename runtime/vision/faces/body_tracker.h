#pragma once
#include <map>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "model/percepts.h"

namespace mirada::vision {

/// Follows people by the colours of what they wear, learnt while their face was
/// seen: for when they turn away. Less sure than a face, and only where the
/// clothes differ from what is around them. One thread.
class BodyTracker {
 public:
  struct Body {
    cv::Rect2d box_px;               ///< of the trunk, in the picture's pixels
    double width_px = 0;             ///< of what is like the clothes; 0 = it tells nothing of the distance
    bool cut_off = false;            ///< by the picture's side: it is wider than that
    double likeness = 0;             ///< 0..1
    std::optional<double> top_px{};  ///< the clothes' upper edge, when it is in the picture
    bool goes_above = false;         ///< they go on above the picture
  };

  /// A new picture, BGR.
  void look(const cv::Mat& bgr);
  /// Somebody whose face is here in this picture; their trunk, as find() sees it.
  std::optional<Body> learn(const FacePercept& face);
  /// The trunk of somebody learnt, near where it should be; `face`: where their
  /// face should be, in or out of the picture.
  std::optional<Body> find(const FacePercept& face) const;
  /// The same after a loss, anywhere in the picture, where it is more certainly they; `face`: of somebody as
  /// far away as they should be, unseen for face.age.
  std::optional<Body> find_again(const FacePercept& face) const;
  /// How far away a body of this width is, by what was learnt, when it was expected that far; 0 = unknown.
  double distance_m(int id, const Body& body, double expected_m) const;
  /// The same of somebody who may be anywhere by now.
  double distance_m(int id, const Body& body) const;

  void keep_only(const std::vector<int>& ids);
  void forget() { people_.clear(); }

 private:
  static constexpr int kBins = 8 * 16 * 16;
  struct Clothes {
    std::vector<float> mine = std::vector<float>(kBins, 0.F);
    std::vector<float> around = std::vector<float>(kBins, 0.F);
    std::vector<float> likely = std::vector<float>(kBins, 0.F);
    double width_px_m = 0;
    double top_share =
        0;  ///< from above the face down to where they end, in the face's heights; 0 = not known
    int looks = 0;
    bool tellable = false;
  };

  const Clothes* tellable(int id) const;
  void learn_colours(Clothes& clothes, const cv::Rect2d& whole);
  std::optional<cv::Rect> largest_like(const Clothes& clothes, int from_x, int to_x, int lowest_top) const;
  std::optional<Body> measure(const Clothes& clothes, const cv::Rect2d& trunk_px) const;
  std::optional<Body> measure_over(const Clothes& clothes, const cv::Rect& like,
                                   const FacePercept& face) const;
  std::optional<double> top_px(const Clothes& clothes, const cv::Rect& trunk) const;
  cv::Rect in_small(const cv::Rect2d& box_px) const;
  cv::Mat likelihood(const Clothes& clothes, const cv::Rect& area) const;
  static void count(const cv::Mat& bins, std::vector<float>& into);
  static void spread(std::vector<float>& of, int step, int count);
  static void settle(Clothes& clothes);

  cv::Mat small_, lab_, bins_;
  double scale_ = 1;  ///< small to picture
  cv::Size picture_;
  std::map<int, Clothes> people_;
};

}  // namespace mirada::vision
