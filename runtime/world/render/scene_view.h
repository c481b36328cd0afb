#pragma once
#include <vector>

#include <Eigen/Geometry>

#include "world/render/ray_table.h"
#include "world/render/stage.h"

namespace mirada::world {

/// A quad as one picture's camera sees it: dot products with a ray (x, y, 1) give the hit.
struct QuadView {
  Eigen::Vector3f normal_C, right_C, down_C;
  float plane;          ///< normal . (corner - camera): negative where the face is seen
  float right0, down0;  ///< the camera's place along the quad's axes
};

/// The part of the directions that a thing can be seen in: q is the tangent of the azimuth against the
/// camera's heading, s the slope (rise over horizontal distance).
struct Directions {
  float q_low, q_high, s_low, s_high;
  float nearest_m;  ///< horizontal distance
};

/// A stage seen from one pose: what faces the camera and where. Items are quads first, then rounds.
class SceneView {
 public:
  static constexpr int kSky = 0;
  static constexpr int kFloor = 1;
  static constexpr int kFirstItem = 2;
  static constexpr float kNearest = 0.005F;  ///< what is nearer to the lens is not seen

  explicit SceneView(const Stage& stage);

  /// Throws nothing away between pictures: no allocation after the first.
  void look(const RayTable& rays, const Eigen::Isometry3d& X_WC, const std::vector<Pose2>& people);

  struct Hit {
    int id = kSky;
    float t = 0;  ///< along the ray (x, y, 1)
    float u = 0;  ///< quads: m along the texture's columns and rows
    float v = 0;
  };
  /// The nearest of some items on a ray, else floor or sky. Not called for rays behind the camera.
  Hit hit(float x, float y, const std::uint16_t* items, std::size_t count) const;
  /// What is seen there, filtered over a pixel; `dither` as Texture::level.
  std::uint32_t colour(const Hit& hit, float x, float y, std::uint32_t dither) const;
  std::uint32_t sky(float x, float y) const;

  /// How many places along the view make a pixel of floor whose footprint is so many times longer than wide.
  /// Few: what they leave out the texture's coarser level blurs, as a cheap lens does.
  static int floor_taps(float longer) {
    const int taps = static_cast<int>(longer * 0.36F + 0.5F);
    return taps < 1 ? 1 : taps > 3 ? 3 : taps;
  }

  Eigen::Vector3f ray_W(float x, float y) const { return rotation * Eigen::Vector3f(x, y, 1); }

  Eigen::Matrix3f rotation;  ///< R_WC
  Eigen::Vector3f at_m;      ///< the lens in W
  float ahead_x = 1, ahead_y = 0;
  float pixel_x = 0, pixel_y = 0;  ///< 1 / f
  const Stage* stage;
  std::vector<QuadView> quads;       ///< of all the stage's, in its order
  std::vector<Round> rounds;         ///< moved to where people are now
  std::vector<std::uint16_t> items;  ///< those that face the camera
  std::vector<Directions> seen;      ///< of `items`

 private:
  void view_quads();
  void view_rounds(const std::vector<Pose2>& people);
  void add_item(std::size_t item, const Eigen::Vector2f* foot_m, std::size_t count, float reach_m,
                float low_m, float high_m);
  bool hit_quad(std::size_t index, float x, float y, Hit& best) const;
  bool hit_round(std::size_t index, const Eigen::Vector3f& ray, Hit& best) const;
  std::uint32_t floor_colour(float x, float y, float t, std::uint32_t dither) const;
  std::uint32_t quad_colour(const Hit& hit, float x, float y, std::uint32_t dither) const;
  std::uint32_t round_colour(const Hit& hit, const Eigen::Vector3f& ray, std::uint32_t dither) const;
};

}  // namespace mirada::world
