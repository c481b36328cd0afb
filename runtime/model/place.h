#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "model/geometry.h"

namespace mirada {

/// An AprilTag 36h11 whose place is known: its middle in the place's frame P, looking along its heading.
struct PlaceTag {
  int id = 0;
  Pose2 X_PT;
  double size_m = 0.1;  ///< side of its black square
};

/// A straight white line painted on the floor, from A to B, in the place's frame P.
struct PlaceLine {
  Eigen::Vector2d p_PA_m, p_PB_m;  ///< ends of its middle
  double width_m = 0.05;
};

/// A white circle painted on the floor, about C.
struct PlaceCircle {
  Eigen::Vector2d p_PC_m;
  double radius_m = 0;  ///< of the line's middle
  double width_m = 0.05;
};

/// What a robot may know of a place before it has looked: place.json (docs/place-json.md). Frame P: the
/// place's own axes, m; heading 0 along x, positive to the left.
struct Place {
  std::string id;
  std::string name_en;
  std::string name_es;
  std::vector<PlaceTag> tags;  ///< each id once
  std::vector<PlaceLine> lines;
  std::vector<PlaceCircle> circles;
  std::optional<Pose2> X_PR_start;  ///< about where the robot is put down

  const PlaceTag* tag(int tag_id) const;
  bool has_lines() const { return !lines.empty() || !circles.empty(); }
};

/// Reads place.json: all faults at once, each with its path. On success `warnings` holds what was odd.
Result<Place> read_place(std::string_view json_text, const std::string& file_name,
                         Faults* warnings = nullptr);
/// A shipped place's id or a file.
Result<Place> place_by_name(const std::string& name);
/// Ids of the places that ship, sorted.
std::vector<std::string> shipped_places();

}  // namespace mirada
