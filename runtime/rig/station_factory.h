#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "base/message.h"
#include "base/result.h"
#include "packs/packs.h"
#include "session/station.h"

namespace mirada::rig {

/// The block packs that ship (data folder "blocks") with the meaning of their native blocks. Packs that could
/// not be loaded are in its `faults`. The set must outlive every program compiled with it.
std::shared_ptr<const packs::PackSet> load_shipped_packs();

/// What `mirada serve` was told.
struct StationOptions {
  std::string world;  ///< id or file of a room; "" = the first that ships
  std::string robot;  ///< id or file of a robot; "" = the first that ships
  std::uint64_t seed = 1;
  std::string camera;      ///< "" = the simulated one; "v4l2:0", or a picture or video file
  std::string face_model;  ///< a network's file; "" = the one that was fetched, or none
  Lang lang = Lang::en;
  std::shared_ptr<const packs::PackSet> packs;  ///< never null
  std::string place{};                          ///< id or file of a place; "" = the robot has no map
  std::string faces{};                          ///< file of the known faces; "" = known_faces_file()
};

/// Builds the robot, its room when it is simulated, and a live session on it (its own threads, motors at
/// zero). A missing room, robot or camera: every fault at once.
Result<std::unique_ptr<session::Station>> make_station(const StationOptions& options);

}  // namespace mirada::rig
