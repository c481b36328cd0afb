#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "rig/lab/lab_sample.h"
#include "vision/visual_sonar.h"

namespace mirada::rig {

/// One bearing whose truth is known.
struct KnownBearing {
  double bearing_rad = 0;
  double distance_m = 0;  ///< to the first obstacle; infinity when there is none within `free_m`
  double free_m = 0;      ///< how far the way is surely free
};

/// One picture of truth.json (docs/calibration.md).
struct KnownPicture {
  std::filesystem::path image;
  std::string robot;  ///< id or file, "" = the folder's
  NeckAngles neck;
  std::string sequence;  ///< pictures of one sequence follow each other: the learnt floor is kept
  std::string floor;
  std::string light;
  std::vector<KnownBearing> bearings;
};

/// Reads FOLDER/truth.json with every fault at once. Paths in it are relative to the folder.
Result<std::vector<KnownPicture>> read_truth(const std::filesystem::path& folder, Faults* warnings = nullptr);

/// Looks at every picture and scores each known bearing with the reading nearest to it. `robot` is used for
/// pictures that name none. Faults: pictures that cannot be read, robots that do not exist.
Result<std::vector<LabSample>> look_at_pictures(const std::vector<KnownPicture>& pictures,
                                                const std::string& robot, const std::filesystem::path& folder,
                                                const vision::SonarSettings& settings);

}  // namespace mirada::rig
