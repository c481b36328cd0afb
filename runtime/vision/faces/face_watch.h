#pragma once
#include <memory>
#include <string>
#include <vector>

#include "vision/face_finder.h"
#include "vision/faces/body_tracker.h"
#include "vision/faces/face_tracker.h"
#include "vision/identity/face_namer.h"

namespace mirada::vision {

/// Faces through time: looks for them now and then with a FaceFinder, follows
/// their patches from picture to picture in between (which costs next to
/// nothing), numbers them, and names those who were learnt. One thread.
class FaceWatch {
 public:
  /// `book`: who is known.
  FaceWatch(const RobotConfig& robot, std::unique_ptr<FaceFinder> finder,
            std::shared_ptr<FaceBook> book = std::make_shared<FaceBook>())
      : finder_(std::move(finder)), tracker_(robot), namer_(std::move(book)) {}

  /// Odometry at the exposure. Pictures in their order.
  FacesPercept look(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR);
  void forget();

  const FaceFinder& finder() const { return *finder_; }

  /// The whole picture is searched this often; sooner when a face has got lost.
  static constexpr Micros kSearchEvery = 190 * kMillisecond;
  static constexpr Micros kSearchSoon = 90 * kMillisecond;

 private:
  /// What a face looked like when it was last found.
  struct Patch {
    int id = 0;
    double scale = 1;  ///< of the patch, to the picture
    double w_px = 0, h_px = 0;
    double score = 0;
    cv::Mat gray;
  };

  void keep_patches(const FacesPercept& seen);
  void follow_bodies(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR, FacesPercept& seen);
  FacesPercept follow_patches(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR);

  std::unique_ptr<FaceFinder> finder_;
  FaceTracker tracker_;
  BodyTracker bodies_;
  FaceNamer namer_;
  std::vector<Patch> patches_;
  cv::Mat gray_;
  Micros searched_at_ = 0;
  bool searched_ = false;
};

}  // namespace mirada::vision
