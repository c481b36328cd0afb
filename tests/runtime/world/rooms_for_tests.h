#pragma once
#include "world/world_config.h"

namespace mirada::world {

/// An empty 6 x 4 m room of one colour with nothing left to chance.
inline WorldConfig quiet_room() {
  WorldConfig out;
  out.id = "quiet";
  out.bounds = {-3, -2, 3, 2};
  out.floor = {FloorKind::plain, {90, 90, 90}, 1, 0};
  out.walls.push_back(
      {{{-3, -2}, {3, -2}, {3, 2}, {-3, 2}, {-3, -2}}, 2.4, WallLook::paint, {230, 230, 230}});
  out.noise = {0, 0, 0, 0};
  out.jitter = {0, 0, 0, 0, 0};
  out.light.shadow = 0;
  out.light.gradient = 0;
  return out;
}

}  // namespace mirada::world
