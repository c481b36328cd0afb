#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "base/random.h"
#include "model/robot_config.h"

namespace mirada::testing {

// A small ray caster, made apart from runtime/world, so that vision is not tested with the renderer it lives
// with. World = floor at z = 0, a rectangular room, boxes and round posts; every colour is linear 0..1, BGR.

enum class Floor { plain, carpet, planks, tiles, checker, field, terrazzo };
enum class Light { even, dim, lamp, shadow };
inline constexpr std::array<const char*, 7> kFloorNames{"plain",   "carpet", "planks",  "tiles",
                                                        "checker", "field",  "terrazzo"};
inline constexpr std::array<const char*, 4> kLightNames{"even", "dim", "lamp", "shadow"};

struct Box {
  double x_m, y_m, heading_rad, length_m, width_m, height_m;
  Eigen::Vector3d colour;
  double from_z_m = 0;  ///< hangs as high as this
};
struct Post {
  double x_m, y_m, radius_m, height_m;
  Eigen::Vector3d colour;
};

struct Scene {
  Floor floor = Floor::plain;
  Light light = Light::even;
  Eigen::Vector3d floor_colour{0.3, 0.3, 0.3};
  Eigen::Vector3d second_colour{0.2, 0.2, 0.2};
  Eigen::Vector3d wall_colour{0.6, 0.6, 0.65};
  double room_x_m = 2;  ///< half sizes
  double room_y_m = 2;
  std::vector<Box> boxes;
  std::vector<Post> posts;
  double noise = 2;  ///< of 255, 1 sigma
  std::uint64_t seed = 1;
};

namespace detail {

inline double hash01(std::int64_t a, std::int64_t b, std::uint64_t seed) {
  std::uint64_t h = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ull ^
                    static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4Full ^
                    (seed + 1) * 0x165667B19E3779F9ull;
  h ^= h >> 31;
  h *= 0xBF58476D1CE4E5B9ull;
  h ^= h >> 29;
  h *= 0x94D049BB133111EBull;
  h ^= h >> 32;
  return static_cast<double>(h >> 11) * 0x1.0p-53;
}

inline std::int64_t cell(double x, double size) { return static_cast<std::int64_t>(std::floor(x / size)); }

inline double smooth_noise(double x, double y, double size, std::uint64_t seed) {
  const std::int64_t i = cell(x, size), j = cell(y, size);
  double a = x / size - static_cast<double>(i), b = y / size - static_cast<double>(j);
  a = a * a * (3 - 2 * a);
  b = b * b * (3 - 2 * b);
  return (1 - b) * ((1 - a) * hash01(i, j, seed) + a * hash01(i + 1, j, seed)) +
         b * ((1 - a) * hash01(i, j + 1, seed) + a * hash01(i + 1, j + 1, seed)) - 0.5;
}

inline double part(double x, double size) { return x / size - std::floor(x / size); }

inline Eigen::Vector3d floor_look(const Scene& s, double x, double y) {
  using Eigen::Vector3d;
  switch (s.floor) {
    case Floor::plain:
      return s.floor_colour * (1 + 0.06 * smooth_noise(x, y, 0.3, s.seed));
    case Floor::carpet:
      return s.floor_colour *
             (1 + 0.5 * smooth_noise(x, y, 0.006, s.seed) + 0.3 * smooth_noise(x, y, 0.02, s.seed + 1) +
              0.1 * smooth_noise(x, y, 0.2, s.seed + 2));
    case Floor::planks: {
      const std::int64_t row = cell(y, 0.11);
      const double shifted = x + 0.9 * hash01(row, 5, s.seed);
      const double tone = 1 + 0.35 * (hash01(row, cell(shifted, 0.9), s.seed) - 0.5);
      const double grain = 1 + 0.12 * smooth_noise(x, 8 * y, 0.08, s.seed + 3);
      const bool joint = part(y, 0.11) < 0.02 || part(shifted, 0.9) < 0.003;
      return s.floor_colour * (joint ? 0.45 : tone * grain);
    }
    case Floor::tiles: {
      const bool joint = part(x, 0.33) < 0.018 || part(y, 0.33) < 0.018;
      const double tone = 1 + 0.1 * (hash01(cell(x, 0.33), cell(y, 0.33), s.seed) - 0.5) +
                          0.1 * smooth_noise(x, y, 0.05, s.seed);
      return joint ? s.second_colour : Vector3d(s.floor_colour * tone);
    }
    case Floor::checker:
      return ((cell(x, 0.25) + cell(y, 0.25)) & 1 ? s.second_colour : s.floor_colour) *
             (1 + 0.06 * smooth_noise(x, y, 0.03, s.seed));
    case Floor::field: {
      const double r = std::hypot(x, y);
      const bool line =
          std::abs(x) < 0.025 || std::abs(r - 0.6) < 0.025 || std::abs(std::abs(y) - 1.4) < 0.025;
      if (line) return {0.75, 0.75, 0.75};
      return s.floor_colour * (1 + 0.4 * smooth_noise(x, y, 0.008, s.seed));
    }
    case Floor::terrazzo: {
      const double chip = hash01(cell(x, 0.012), cell(y, 0.012), s.seed);
      return s.floor_colour * (chip > 0.85 ? 0.5 : chip > 0.7 ? 1.35 : 1.0);
    }
  }
  return s.floor_colour;
}

inline double brightness(const Scene& s, double x, double y) {
  switch (s.light) {
    case Light::even:
      return 1;
    case Light::dim:
      return 0.22;
    case Light::lamp:
      return 1.4 / (1 + 0.5 * (std::pow(x - 0.7, 2) + std::pow(y + 0.5, 2)));
    case Light::shadow: {
      // A band of shade across the room with a soft rim of 4 cm.
      const double d = std::abs(0.8 * x + 0.6 * y - 0.35 - 0.4 * hash01(1, 1, s.seed)) - 0.25;
      return 0.4 + 0.6 * std::clamp(d / 0.04 + 0.5, 0.0, 1.0);
    }
  }
  return 1;
}

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  Eigen::Vector3d colour{0.5, 0.5, 0.5};
};

inline void hit_box(const Box& b, const Eigen::Vector3d& o, const Eigen::Vector3d& d, Hit& hit) {
  const double c = std::cos(b.heading_rad), s = std::sin(b.heading_rad);
  const auto local = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(c * v.x() + s * v.y(), -s * v.x() + c * v.y(), v.z());
  };
  const Eigen::Vector3d from = local(o - Eigen::Vector3d(b.x_m, b.y_m, 0)), way = local(d);
  const Eigen::Vector3d low(-b.length_m / 2, -b.width_m / 2, b.from_z_m),
      high(b.length_m / 2, b.width_m / 2, b.height_m);
  double in = 0, out = 1e9;
  int face = 0;
  for (int i = 0; i < 3; ++i) {
    double a = (low[i] - from[i]) / way[i], e = (high[i] - from[i]) / way[i];
    if (a > e) std::swap(a, e);
    if (a > in) in = a, face = i;
    out = std::min(out, e);
  }
  if (in <= 0 || in >= out || in >= hit.t) return;
  constexpr double kFacing[] = {0.85, 0.65, 1.1};
  hit = {in, b.colour * kFacing[face]};
}

inline void hit_post(const Post& p, const Eigen::Vector3d& o, const Eigen::Vector3d& d, Hit& hit) {
  const Eigen::Vector2d from = o.head<2>() - Eigen::Vector2d(p.x_m, p.y_m), way = d.head<2>();
  const double a = way.squaredNorm(), b = from.dot(way), c = from.squaredNorm() - p.radius_m * p.radius_m;
  const double disc = b * b - a * c;
  if (disc <= 0 || a < 1e-12) return;
  const double t = (-b - std::sqrt(disc)) / a;
  const double z = o.z() + t * d.z();
  if (t <= 0 || t >= hit.t || z < 0) return;
  if (z > p.height_m) {
    const double top = (p.height_m - o.z()) / d.z();
    if (d.z() < 0 && top < hit.t && (from + top * way).norm() < p.radius_m) hit = {top, p.colour * 1.1};
    return;
  }
  const Eigen::Vector2d normal = (from + t * way).normalized();
  hit = {t, p.colour * (0.75 + 0.25 * normal.y())};
}

inline void hit_room(const Scene& s, const Eigen::Vector3d& o, const Eigen::Vector3d& d, Hit& hit) {
  const double half[] = {s.room_x_m, s.room_y_m};
  for (int i = 0; i < 2; ++i) {
    if (std::abs(d[i]) < 1e-12) continue;
    const double t = ((d[i] > 0 ? half[i] : -half[i]) - o[i]) / d[i];
    if (t <= 0 || t >= hit.t) continue;
    hit = {t, s.wall_colour * (i == 0 ? 1.0 : 0.85)};
  }
}

inline Eigen::Vector3d cast(const Scene& s, const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
  Hit hit;
  hit_room(s, o, d, hit);
  for (const Box& b : s.boxes) hit_box(b, o, d, hit);
  for (const Post& p : s.posts) hit_post(p, o, d, hit);
  const double t_floor = d.z() < 0 ? -o.z() / d.z() : std::numeric_limits<double>::infinity();
  if (t_floor < hit.t) {
    const Eigen::Vector3d p = o + t_floor * d;
    return floor_look(s, p.x(), p.y()) * brightness(s, p.x(), p.y());
  }
  const Eigen::Vector3d p = o + hit.t * d;
  return hit.colour * brightness(s, p.x(), p.y());
}

inline double encoded(double linear) { return 255 * std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2); }

}  // namespace detail

/// The picture that the robot's camera takes, standing at X_WR.
inline cv::Mat render(const Scene& scene, const RobotConfig& robot, const Pose2& X_WR,
                      const NeckAngles& neck) {
  const CameraModel& camera = robot.camera;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.translate(Eigen::Vector3d(X_WR.x_m, X_WR.y_m, 0))
      .rotate(Eigen::AngleAxisd(X_WR.heading_rad, Eigen::Vector3d::UnitZ()));
  X_WC = X_WC * robot.X_RC(neck);
  Random random(scene.seed, "noise");
  cv::Mat out(camera.height_px, camera.width_px, CV_8UC3);
  constexpr double kTaps[][2] = {{-0.375, -0.125}, {0.125, -0.375}, {0.375, 0.125}, {-0.125, 0.375}};
  for (int v = 0; v < out.rows; ++v) {
    for (int u = 0; u < out.cols; ++u) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const auto& tap : kTaps) {
        const auto ray = camera.unproject({u + tap[0], v + tap[1]});
        if (ray) sum += detail::cast(scene, X_WC.translation(), X_WC.linear() * *ray) / 4;
      }
      cv::Vec3b& pixel = out.at<cv::Vec3b>(v, u);
      for (int i = 0; i < 3; ++i) {
        pixel[i] = cv::saturate_cast<std::uint8_t>(detail::encoded(sum[i]) + scene.noise * random.gaussian());
      }
    }
  }
  return out;
}

/// How far the floor is free along a bearing from the robot's origin.
inline double true_distance_m(const Scene& scene, const Pose2& X_WR, double bearing_rad) {
  const double angle = X_WR.heading_rad + bearing_rad;
  const Eigen::Vector3d from(X_WR.x_m, X_WR.y_m, 1e-4);
  const Eigen::Vector3d way(std::cos(angle), std::sin(angle), 1e-12);
  detail::Hit hit;
  detail::hit_room(scene, from, way, hit);
  for (const Box& b : scene.boxes) detail::hit_box(b, from, way, hit);
  for (const Post& p : scene.posts) detail::hit_post(p, from, way, hit);
  return hit.t;
}

/// A room drawn by lot, with obstacles that do not touch the robot at the origin of X_WR.
inline Scene draw_scene(Floor floor, Light light, std::uint64_t seed) {
  Random random(seed, "scene");
  const auto colour = [&](double low, double high) {
    return Eigen::Vector3d(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
  };
  Scene s;
  s.floor = floor;
  s.light = light;
  s.seed = seed;
  s.noise = light == Light::dim ? 4 : 2;
  const double gray = random.uniform(0.12, 0.5);
  s.floor_colour =
      Eigen::Vector3d::Constant(gray) + 0.25 * gray * (colour(0, 1) - Eigen::Vector3d::Constant(0.5));
  if (floor == Floor::planks) s.floor_colour = Eigen::Vector3d(0.08, 0.17, 0.3) * random.uniform(0.7, 1.4);
  if (floor == Floor::field) s.floor_colour = Eigen::Vector3d(0.06, 0.22, 0.05) * random.uniform(0.8, 1.3);
  s.second_colour =
      s.floor_colour * (floor == Floor::checker ? random.uniform(0.3, 0.6) : random.uniform(0.5, 1.5));
  s.wall_colour = random.uniform() < 0.5
                      ? Eigen::Vector3d(Eigen::Vector3d::Constant(random.uniform(0.45, 0.8)))
                      : colour(0.1, 0.8);
  s.room_x_m = random.uniform(1.2, 2.6);
  s.room_y_m = random.uniform(1.2, 2.6);
  const auto place = [&](double clearance) {
    for (;;) {
      const Eigen::Vector2d p(random.uniform(-s.room_x_m, s.room_x_m),
                              random.uniform(-s.room_y_m, s.room_y_m));
      if (p.norm() > clearance) return p;
    }
  };
  const auto n_boxes = random.integer(2, 6);
  for (int i = 0; i < n_boxes; ++i) {
    const double length = random.uniform(0.08, 0.4), width = random.uniform(0.08, 0.4);
    const Eigen::Vector2d p = place(0.28 + std::hypot(length, width) / 2);
    s.boxes.push_back(
        {p.x(), p.y(), random.uniform(-3, 3), length, width, random.uniform(0.08, 0.5), colour(0.02, 0.85)});
  }
  const auto n_posts = random.integer(0, 3);
  for (int i = 0; i < n_posts; ++i) {
    const double radius = random.uniform(0.02, 0.15);
    const Eigen::Vector2d p = place(0.28 + radius);
    s.posts.push_back({p.x(), p.y(), radius, random.uniform(0.12, 0.8), colour(0.02, 0.85)});
  }
  return s;
}

}  // namespace mirada::testing
