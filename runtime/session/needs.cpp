#include "session/needs.h"

namespace mirada::session {

robot::Needs needs_of(const std::set<std::string>& names) {
  robot::Needs needs;
  needs.sonar = names.contains("sonar");
  needs.faces = names.contains("faces");
  needs.frames = needs.sonar || needs.faces;
  return needs;
}

bool seen_enough(const robot::Robot& robot, const robot::Needs& needs) {
  if (!needs.any() || !robot.perception().has_camera()) return true;
  const bool sonar = !needs.sonar || robot.sonar().fresh();
  const bool faces =
      !needs.faces || robot.faces() != nullptr || robot.perception().faces_trouble().has_value();
  return sonar && faces;
}

}  // namespace mirada::session
