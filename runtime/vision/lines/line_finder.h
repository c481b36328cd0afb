#pragma once
#include <vector>

#include "model/frame.h"
#include "model/percepts.h"
#include "model/robot_config.h"
#include "vision/lines/line_scan.h"

namespace mirada::vision {

/// Finds white lines on the floor: bands that scan after scan crosses in one straight row, as wide on the
/// floor as the lines that are looked for. A painted line often gives more than one piece. One thread.
class LineFinder {
 public:
  /// The lines that are looked for are from `narrowest_m` to `widest_m` wide.
  LineFinder(const RobotConfig& robot, double narrowest_m, double widest_m);

  /// `neck` at the frame's exposure. Straight pieces in the robot's frame, with what pixels, tilt, height and
  /// pan leave uncertain (mount). A frame of another shape than the calibrated, or an empty one, shows none.
  std::vector<LineSeen> find(const Frame& frame, const NeckAngles& neck);

 private:
  using Crossings = std::vector<BandCrossing>;
  void add_chains(const Crossings& crossings, const GroundProjection& ground, std::vector<LineSeen>& out);
  void add_pieces(const Crossings& chain, std::size_t first, std::size_t last, const GroundProjection& ground,
                  std::vector<LineSeen>& out) const;
  void add_line(const Crossings& chain, std::size_t first, std::size_t last, const GroundProjection& ground,
                std::vector<LineSeen>& out) const;

  RobotConfig robot_;
  double narrowest_m_, widest_m_;
  cv::Size prepared_;
  CameraModel camera_;
  LineScans scans_;
  std::vector<Crossings> chains_;
};

}  // namespace mirada::vision
