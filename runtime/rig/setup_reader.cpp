#include "rig/setup_reader.h"

#include <algorithm>

#include "base/files.h"
#include "model/camera_preset.h"
#include "rig/calibration/kept_camera.h"
#include "rig/messages.h"
#include "rig/place_choice.h"

namespace mirada::rig {
namespace {

/// The id asked for, or the first that ships.
Result<std::string> chosen(const std::string& asked, const std::vector<std::string>& shipped,
                           const char* what, const char* folder) {
  if (!asked.empty()) return asked;
  if (!shipped.empty()) return shipped.front();
  return make_fault("", messages::nothing_ships, {{"what", what}, {"folder", data_folder(folder).string()}});
}

template <class T>
void keep_faults(const Result<T>& result, Faults& faults) {
  if (!result) faults.insert(faults.end(), result.faults().begin(), result.faults().end());
}

Result<world::WorldConfig> read_world(const std::string& asked) {
  const auto id = chosen(asked, world::shipped_worlds(), "room", "runtime/world/rooms");
  if (!id) return id.faults();
  return world::world_by_name(*id);
}

Result<RobotConfig> read_robot(const std::string& asked) {
  const auto id = chosen(asked, shipped_robots(), "robot", "runtime/model/robots");
  if (!id) return id.faults();
  return robot_by_name(*id);
}

}  // namespace

Status only_offered(const session::Setup& asked, const session::Setup& now) {
  Faults faults;
  const auto check = [&](const char* place, const std::string& name, const std::string& has,
                         const std::vector<std::string>& shipped) {
    if (name.empty() || name == has || std::find(shipped.begin(), shipped.end(), name) != shipped.end())
      return;
    std::string known;
    for (const std::string& id : shipped) known += (known.empty() ? "" : ", ") + id;
    faults.push_back(make_fault(place, messages::not_offered, {{"name", name}, {"known", known}}));
  };
  check("/world", asked.world, now.world, world::shipped_worlds());
  check("/robot", asked.robot, now.robot, shipped_robots());
  check("/place", asked.place, now.place, shipped_places());
  return faults.empty() ? Status(Ok{}) : Status(std::move(faults));
}

Result<LiveParts> read_setup(const session::Setup& setup, const std::string& camera) {
  auto world = read_world(setup.world);
  auto robot = read_robot(setup.robot);
  Faults faults;
  keep_faults(world, faults);
  keep_faults(robot, faults);
  auto place = choose_place(setup.place);
  keep_faults(place, faults);
  if (!faults.empty()) return faults;
  LiveParts parts;
  parts.setup = setup;
  if (setup.world.empty()) parts.setup.world = world->id;
  if (setup.robot.empty()) parts.setup.robot = robot->id;
  parts.setup.simulated = camera.empty();
  parts.world = std::move(*world);
  parts.body = *robot;
  parts.robot = std::move(*robot);
  parts.robot.place = std::move(*place);
  parts.camera = camera;
  const Status kept = use_kept_camera(kept_camera_file(parts.setup.robot, camera.empty()), parts.robot);
  if (!kept) parts.notes = kept.faults();
  return parts;
}

std::vector<session::Option> world_options() {
  std::vector<session::Option> options;
  for (const std::string& id : world::shipped_worlds()) {
    if (const auto world = world::world_by_name(id)) options.push_back({id, world->name_en, world->name_es});
  }
  return options;
}

std::vector<session::Option> camera_options() {
  std::vector<session::Option> options;
  for (const std::string& id : shipped_cameras()) {
    if (const auto camera = camera_preset(id)) options.push_back({id, camera->name_en, camera->name_es});
  }
  return options;
}

std::vector<session::Option> robot_options() {
  std::vector<session::Option> options;
  for (const std::string& id : shipped_robots()) {
    if (const auto robot = robot_by_name(id)) options.push_back({id, robot->name_en, robot->name_es});
  }
  return options;
}

}  // namespace mirada::rig
