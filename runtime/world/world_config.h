#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "base/result.h"
#include "model/geometry.h"

namespace mirada::world {

/// As written in files: "#rrggbb".
struct Colour {
  std::uint8_t r = 128;
  std::uint8_t g = 128;
  std::uint8_t b = 128;
};
std::string to_hex(Colour colour);

/// The floor's outermost rectangle in the world frame W. Floor is painted this far.
struct Bounds {
  double min_x_m = -2;
  double min_y_m = -2;
  double max_x_m = 2;
  double max_y_m = 2;
};

enum class FloorKind { plain, carpet, wood, tiles, concrete, grass };
struct FloorConfig {
  FloorKind kind = FloorKind::carpet;
  Colour colour{150, 140, 125};
  double scale = 1;     ///< size of the pattern (planks, tiles, blades); 1 = natural
  double contrast = 1;  ///< strength of the pattern; 0 = one colour
};

/// Paint on the floor, W frame, no height.
struct LineConfig {
  std::vector<Eigen::Vector2d> points_m;
  double width_m = 0.05;
  Colour colour{240, 240, 240};
};

enum class WallLook { paint, wallpaper, brick, board };
/// Upright faces along a polyline, seen from both sides.
struct WallConfig {
  std::vector<Eigen::Vector2d> points_m;
  double height_m = 2.4;
  WallLook look = WallLook::paint;
  Colour colour{225, 218, 205};
  double skirting_m = 0;  ///< height of the skirting board; 0 = none
  Colour skirting{245, 243, 238};
  bool pictures = false;  ///< hang pictures along it
};

/// poster: a printed face as large as life on its long sides, near the top.
enum class BoxLook { plain, wood, cardboard, books, drawers, crate, poster };
struct BoxConfig {
  Pose2 X_WB;
  double length_m = 0.3;  ///< along its x
  double width_m = 0.3;
  double height_m = 0.3;
  BoxLook look = BoxLook::plain;
  Colour colour{170, 120, 80};
};

enum class CylinderLook { plain, stripes, wood, plant };
struct CylinderConfig {
  Eigen::Vector2d p_W_m = Eigen::Vector2d::Zero();
  double radius_m = 0.1;
  double height_m = 0.4;
  CylinderLook look = CylinderLook::plain;
  Colour colour{190, 80, 60};
};

/// Somebody with a face, who stands (or walks a path there and back).
struct PersonConfig {
  Pose2 X_WP;  ///< the face looks along x
  double height_m = 1.2;
  double radius_m = 0.15;  ///< what the robot can touch
  Colour shirt{70, 110, 180};
  Colour hair{70, 48, 32};
  Colour skin{224, 180, 150};
  int face = 0;                         ///< whose face it is: another number, another face
  std::vector<Eigen::Vector2d> path_m;  ///< corners to walk to, in turn, for ever
  double speed_mps = 0.3;
  bool watches_robot = false;  ///< looks at the robot wherever they walk, backwards too
};

/// Gives somebody the skin and hair that go with their face; the first face has those of PersonConfig.
void wear_own_colours(PersonConfig& person);

/// An AprilTag 36h11 printed on white and put up: its middle in W, looking along its heading.
struct TagConfig {
  int id = 0;
  Pose2 X_WT;
  double z_m = 0.25;
  double size_m = 0.1;  ///< side of its black square
};

struct LightConfig {
  double level = 1;              ///< 1 = well lit
  Colour colour{255, 250, 240};  ///< white is neutral
  double from_rad = 0.8;         ///< heading that the light comes from
  double elevation_rad = 1.0;
  double ambient = 0.65;   ///< 0..1: what a face turned away still gets
  double gradient = 0.15;  ///< relative change of the light across the room
  double shadow = 0.35;    ///< 0 = no shadows, 1 = black
};

struct NoiseConfig {
  double sensor = 2.5;         ///< standard deviation of a pixel's channel, in grey levels
  double vignette = 0.2;       ///< darkening in the picture's corners
  double wheel_scale = 0.003;  ///< standard deviation of each wheel's size, relative
  double wheel_slip = 0.002;   ///< standard deviation of a wheel's slip after one metre, in m
};

/// What the seed changes, uniformly within plus or minus these.
struct JitterConfig {
  double start_m = 0.03;
  double start_rad = 0.0873;
  double obstacles_m = 0;
  double obstacles_rad = 0;
  double light = 0;  ///< relative
};

/// Behind and above everything.
struct BackgroundConfig {
  Colour horizon{205, 212, 222};
  Colour zenith{238, 240, 244};
};

/// world.json as read (docs/world-json.md). Frame W: x east, y north, floor at z = 0.
struct WorldConfig {
  std::string id;
  std::string name_en;
  std::string name_es;
  Pose2 X_WR_start;
  Bounds bounds;
  FloorConfig floor;
  std::vector<LineConfig> lines;
  std::vector<WallConfig> walls;
  std::vector<BoxConfig> boxes;
  std::vector<CylinderConfig> cylinders;
  std::vector<PersonConfig> people;
  std::vector<TagConfig> tags;
  LightConfig light;
  NoiseConfig noise;
  JitterConfig jitter;
  BackgroundConfig background;
};

/// Reads world.json. On success `warnings` holds what was odd but harmless (unknown fields).
Result<WorldConfig> read_world(std::string_view json_text, const std::string& file_name,
                               Faults* warnings = nullptr);
/// The ids of the rooms that ship (runtime/world/rooms/<id>.json), sorted; one of them, or a file by path.
std::vector<std::string> shipped_worlds();
Result<WorldConfig> world_by_name(const std::string& id_or_path, Faults* warnings = nullptr);

}  // namespace mirada::world
