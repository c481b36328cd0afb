#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "model/geometry.h"
#include "world/render/texture.h"
#include "world/world_config.h"

namespace mirada::world {

/// A flat textured rectangle, seen from the side that its normal points to. W frame, m.
struct Quad {
  Eigen::Vector3f corner_m;  ///< where the texture's first texel lies
  Eigen::Vector3f right;     ///< unit vectors along the texture's columns and rows
  Eigen::Vector3f down;
  Eigen::Vector3f normal;
  float width_m, height_m;
  std::size_t texture;
};

/// A surface of revolution about an upright axis, rho^2 = a + b z + c z^2 for z from low to high; or, when
/// `cap`, the flat disc of radius sqrt(a) at z = high.
struct Round {
  float x_m, y_m;
  float a, b, c;
  float low_m, high_m;
  float reach_m;  ///< the largest rho
  bool cap = false;
  bool head = false;             ///< textured from the front and the back, not round about
  std::size_t texture;           ///< round about from behind, or the face
  std::size_t back_texture = 0;  ///< of a head
  int person = -1;               ///< moves with this one
  float heading_rad = 0;
  float ahead_x = 1, ahead_y = 0;  ///< unit vector along the heading
};

/// How strongly a surface is lit, with its colour.
struct Lamp {
  Eigen::Vector3f towards;  ///< unit vector to the light
  float ambient, level;
  Eigen::Vector3f tint_bgr;
  /// 1 for the floor in a normally lit room.
  float on(const Eigen::Vector3f& normal) const { return facing(std::max(0.0F, normal.dot(towards))); }
  /// The same from the cosine between normal and light, not negative; of one number or of many.
  template <typename T>
  [[gnu::always_inline]] T facing(T cosine) const {
    return (ambient + (1 - ambient) * cosine) * (level / (ambient + (1 - ambient) * towards.z()));
  }
};
Lamp lamp_of(const LightConfig& light);

/// All that can be seen, with its textures painted and lit. Made once a room and seed.
struct Stage {
  Stage(const WorldConfig& placed, std::uint64_t seed);

  std::vector<Texture> textures;
  std::vector<Quad> quads;
  std::vector<Round> rounds;
  std::size_t floor_texture = 0;
  float floor_min_x_m, floor_max_y_m;
  float floor_texels_per_m;
  Lamp lamp;
  std::vector<std::uint32_t> sky;  ///< by slope above the horizon, kSkySteps a unit
  static constexpr float kSkySteps = 64;

 private:
  std::size_t keep(const cv::Mat& bgr);
  void add_floor(const WorldConfig& world, std::uint64_t seed);
  void add_walls(const WorldConfig& world, std::uint64_t seed);
  void add_boxes(const WorldConfig& world, std::uint64_t seed);
  void add_cylinders(const WorldConfig& world, std::uint64_t seed);
  void add_tags(const WorldConfig& world);
  void add_people(const WorldConfig& world, std::uint64_t seed);
  void add_sky(const WorldConfig& world);
  /// An upright rectangle over a floor edge, seen from the right of a to b.
  void upright(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double height_m, const cv::Mat& bgr);
  void tube(const Eigen::Vector2d& at, double radius_m, double low_m, double high_m, const cv::Mat& bgr);
};

}  // namespace mirada::world
