#pragma once
#include <vector>

#include <opencv2/core.hpp>

#include "base/random.h"
#include "world/world_config.h"

namespace mirada::world::paint {

/// Soft noise: `octaves` layers, each twice as fine and half as strong, the first with cells of cell_px.
/// CV_32F, roughly -1..1, mean 0. Fine noise may come smaller than asked for: modulate() repeats it mirrored.
cv::Mat soft_noise(cv::Size size, double cell_px, int octaves, Random& random);
/// The same stretched along x by `stretch`.
cv::Mat grain_noise(cv::Size size, double cell_px, double stretch, int octaves, Random& random);

cv::Scalar bgr(Colour colour);
/// One colour; the size is rounded up to multiples of 16.
cv::Mat plain(cv::Size size, Colour colour);
/// A colour made lighter (share > 1) or darker.
Colour shade(Colour colour, double share);
/// Part way from a to b.
Colour mix(Colour a, Colour b, double share);

/// Multiplies a picture by 1 + amount * noise; noise that is smaller goes on mirrored.
void modulate(cv::Mat& bgr8, const cv::Mat& noise, double amount);
/// Multiplies row y by a share a pixel, rounded.
void scale_row(cv::Mat& bgr8, int y, const std::vector<float>& share);
/// Multiplies the channels.
void light(cv::Mat& bgr8, double share, const cv::Vec3f& tint_bgr);

/// A floor pattern of this size, rounded up to multiples of 64. px_per_m: its scale.
cv::Mat floor_pattern(const FloorConfig& floor, cv::Size size, double px_per_m, Random& random);
/// Lines, the light's gradient and shadows are put on it; W frame given by the upper left corner (min_x,
/// max_y).
struct FloorFrame {
  double min_x_m, max_y_m, px_per_m;
  cv::Point2d at(const Eigen::Vector2d& p_W_m) const {
    return {(p_W_m.x() - min_x_m) * px_per_m, (max_y_m - p_W_m.y()) * px_per_m};
  }
};
void paint_lines(cv::Mat& floor, const FloorFrame& frame, const std::vector<LineConfig>& lines,
                 Random& random);
void cast_shadows(cv::Mat& floor, const FloorFrame& frame, const WorldConfig& world);
void light_gradient(cv::Mat& floor, const LightConfig& light);

cv::Mat wall(const WallConfig& wall, double length_m, double px_per_m, Random& random);
cv::Mat box_side(const BoxConfig& box, double length_m, double px_per_m, Random& random);
/// A printed face, as large as life, with a white border; `out` is an upright side.
void poster(cv::Mat& out, double px_per_m, Random& random);
cv::Mat box_top(const BoxConfig& box, double px_per_m, Random& random);
/// Unrolled about the axis, from behind, to the left seen from above.
cv::Mat cylinder(const CylinderConfig& cylinder, double px_per_m, Random& random);
/// An AprilTag 36h11 with the white edge that it is printed on: kTagCells cells a side, of which the black
/// square has two fewer.
cv::Mat tag(int id);
inline constexpr int kTagCells = 10;
cv::Mat leaves(cv::Size size, Colour colour, Random& random);

/// What a person's head shows from the front (a face) and from behind; seen from far away along the heading.
cv::Mat face(const PersonConfig& person, Random& random);
cv::Mat head_back(const PersonConfig& person, Random& random);
cv::Mat clothes(const PersonConfig& person, double low, double high, Random& random);

}  // namespace mirada::world::paint
