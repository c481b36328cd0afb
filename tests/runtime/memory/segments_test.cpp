#include "memory/segments.h"

#include <gtest/gtest.h>

#include "flat_room.h"

namespace mirada::memory {
namespace {

/// Walls made of small pillars.
FlatRoom corner() {
  FlatRoom room;
  for (double s = -0.8; s <= 0.8; s += 0.01) room.pillars.push_back({1.2, s, 0.012});
  for (double s = 0; s <= 1.2; s += 0.01) room.pillars.push_back({1.2 - s, 0.8, 0.012});
  return room;
}

VisualMemory seen(const FlatRoom& room) {
  VisualMemory memory(sim_robot());
  Micros t = 0;
  for (const double pan : {0.0, 30.0, 60.0}) {
    for (int i = 0; i < 3; ++i) {
      t += 50 * kMillisecond;
      memory.moved(t, {});
      memory.observe(room.look({}, pan, t));
    }
  }
  return memory;
}

std::vector<Segment> long_ones(const VisualMemory& memory) {
  auto all = segments_of(memory.points(), memory.drift(), memory.X_OR());
  std::erase_if(all, [](const Segment& segment) { return segment.length_m() < 0.3; });
  return all;
}

TEST(Segments, ACornerIsTwoWalls) {
  const auto walls = long_ones(seen(corner()));
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_NEAR(walls[0].from_O_m.x(), 1.19, 0.05);
  EXPECT_NEAR(walls[0].to_O_m.x(), 1.19, 0.05);
  EXPECT_GT(walls[0].length_m(), 1.1);
  EXPECT_NEAR(walls[1].from_O_m.y(), 0.79, 0.06);
  EXPECT_NEAR(walls[1].to_O_m.y(), 0.79, 0.05);
}

TEST(Segments, AWallSeenPieceByPieceIsOne) {
  FlatRoom room;
  for (double s = -1.5; s <= 1.5; s += 0.01) room.pillars.push_back({1.0, s, 0.012});
  VisualMemory memory(sim_robot());
  Micros t = 0;
  for (const double y : {-0.6, 0.0, 0.6}) {
    t += kSecond;
    roll(memory, {0, y, 0}, t);
    memory.observe(room.look({0, y, 0}, 0, t));
  }
  const auto walls = long_ones(memory);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_GT(walls[0].length_m(), 2.0);
}

TEST(Segments, ClearedInItsMiddleAWallIsTwo) {
  FlatRoom room;
  for (double s = -0.5; s <= 0.5; s += 0.01) room.pillars.push_back({1.0, s, 0.012});
  VisualMemory memory(sim_robot());
  memory.moved(kSecond, {});
  memory.observe(room.look({}, 0, kSecond));
  ASSERT_EQ(long_ones(memory).size(), 1u);
  std::erase_if(room.pillars, [](const FlatRoom::Pillar& pillar) { return std::abs(pillar.y_m) < 0.17; });
  for (int i = 1; i <= 2; ++i) memory.observe(room.look({}, 0, kSecond + i));
  EXPECT_EQ(long_ones(memory).size(), 2u);
}

}  // namespace
}  // namespace mirada::memory
