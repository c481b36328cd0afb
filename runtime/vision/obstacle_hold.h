#pragma once
#include <vector>

#include "model/geometry.h"
#include "vision/column_scan.h"
#include "vision/ground_projection.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// Keeps near obstacles from vanishing while they are still in the picture: what was seen to end the floor in
/// several pictures goes on ending it, at the same place on the floor, for as long as it looks the same
/// there. It goes as soon as something else is seen in its place. (A box in the floor's own colour that fills
/// the picture may pass for floor when it is judged alone.)
class ObstacleHold {
 public:
  ObstacleHold();
  void forget();

  /// Follows what it holds to this picture and puts it back into `results` where the floor was said to go on
  /// through it. X_OR is the odometry at the exposure.
  void apply(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const GroundProjection& ground,
             const Pose2& X_OR, std::vector<ColumnResult>& results);

 private:
  struct Held {
    Eigen::Vector2d p_O_m;
    Look look;       ///< just above its foot
    int seen = 0;    ///< pictures that showed it
    int unseen = 0;  ///< pictures since it was last in view
    int column = -1;
    double row = 0;
    bool put_back = false;
  };
  struct View;

  void follow(const View& view, std::vector<ColumnResult>& results, Held& held) const;
  void put_back_between(const View& view, std::vector<ColumnResult>& results);
  void take_new(const View& view, const std::vector<ColumnResult>& results);

  std::vector<Held> held_;
  std::vector<char> taken_;  ///< columns where something is held already
};

}  // namespace mirada::vision
