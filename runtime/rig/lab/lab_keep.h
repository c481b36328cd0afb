#pragma once
#include <filesystem>
#include <memory>

#include "base/result.h"
#include "model/robot_config.h"
#include "rig/lab/lab_distances.h"

namespace mirada::rig {

/// Writes a laboratory's pictures into a folder with the truth.json that `mirada lab pictures` reads (and the
/// robot.json it names); beside each, NAME-said.png: the true boundary in green, what was said in red. One
/// thread.
class LabKeeper {
 public:
  LabKeeper(std::filesystem::path folder, const RobotConfig& robot);
  ~LabKeeper();
  LabKeeper(const LabKeeper&) = delete;
  LabKeeper& operator=(const LabKeeper&) = delete;

  void add(const LabShot& shot);
  /// Writes the two files; the first fault of all that was to be written.
  Status finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mirada::rig
