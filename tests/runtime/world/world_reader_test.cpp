#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "model/robot_config.h"
#include "world/shapes.h"
#include "world/world_config.h"

namespace mirada::world {
namespace {

using nlohmann::json;

json good() {
  return json::parse(R"({"format": "mirada-world", "version": 1, "id": "t", "name": {"en": "T", "es": "T"},
    "bounds": {"min_x_m": -2, "min_y_m": -2, "max_x_m": 2, "max_y_m": 2},
    "start": {"x_m": 0, "y_m": 0}, "floor": {"kind": "carpet"}})");
}

std::vector<std::string> places(const json& world) {
  const Result<WorldConfig> result = read_world(world.dump(), "t.json");
  std::vector<std::string> out;
  if (result) return out;
  for (const Fault& fault : result.faults()) {
    if (fault.severity == Severity::error) out.push_back(fault.place);
  }
  return out;
}

TEST(WorldReader, ReadsTheLeastRoom) { EXPECT_THAT(places(good()), testing::IsEmpty()); }

TEST(WorldReader, TellsOfEveryFaultAtOnce) {
  json world = good();
  world["floor"] = {{"kind", "lava"}, {"colour", "red"}};
  world["boxes"] =
      json::array({{{"x_m", 1}, {"y_m", "left"}, {"length_m", -1}, {"width_m", 0.2}, {"height_m", 0.2}}});
  world["walls"] = json::array({{{"points", json::array({json::array({0, 0})})}}});
  world["light"] = {{"level", 99}};
  world.erase("start");
  EXPECT_THAT(places(world), testing::UnorderedElementsAre("/floor/kind", "/floor/colour", "/boxes/0/y_m",
                                                           "/boxes/0/length_m", "/walls/0/points",
                                                           "/light/level", "/start/x_m", "/start/y_m"));
}

TEST(WorldReader, NamesTheAllowedRange) {
  json world = good();
  world["light"] = {{"level", 99}};
  const auto result = read_world(world.dump(), "t.json");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.faults()[0].text(Lang::en),
              testing::AllOf(testing::HasSubstr("99"), testing::HasSubstr("0.1")));
}

TEST(WorldReader, RefusesAStartInsideAnObstacle) {
  json world = good();
  world["cylinders"] = json::array({{{"x_m", 0.2}, {"y_m", 0}, {"radius_m", 0.15}, {"height_m", 0.3}}});
  EXPECT_THAT(places(world), testing::ElementsAre("/start"));
}

TEST(WorldReader, RefusesThingsOutsideTheRoom) {
  json world = good();
  world["people"] = json::array({{{"x_m", 5}, {"y_m", 0}}});
  EXPECT_THAT(places(world), testing::ElementsAre("/people/0"));
}

TEST(WorldReader, WarnsOfUnknownFields) {
  json world = good();
  world["florr"] = 1;
  Faults warnings;
  ASSERT_TRUE(read_world(world.dump(), "t.json", &warnings));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].place, "/florr");
}

TEST(WorldReader, SurvivesAnyCutOffFile) {
  const std::string text =
      read_file(std::string(MIRADA_SOURCE_DIR) + "/runtime/world/rooms/sala-1.json").value();
  for (std::size_t length = 0; length < text.size() - 2; length += 97) {
    EXPECT_FALSE(read_world(text.substr(0, length), "cut.json"));
  }
}

TEST(ShippedRooms, AreReadWithoutAWarningAndStartInTheOpen) {
  EXPECT_THAT(shipped_worlds(), testing::ElementsAre("green-field", "sala-1", "workshop"));
  for (const std::string& id : shipped_worlds()) {
    Faults warnings;
    const auto world = world_by_name(id, &warnings);
    ASSERT_TRUE(world) << id;
    EXPECT_TRUE(warnings.empty()) << id;
    EXPECT_EQ(world->id, id);
    // 70 cm of free floor straight ahead.
    for (double ahead = 0; ahead < 0.7; ahead += 0.1) {
      const Pose2 p = compose(world->X_WR_start, {ahead, 0, 0});
      const auto at = rectangle(p, 0.2, 0.18);
      for (const auto& wall : world->walls) {
        for (const auto& shape : shapes_of(wall)) EXPECT_GT(separation(at, shape).distance_m, 0.05) << id;
      }
      for (const auto& box : world->boxes) EXPECT_GT(separation(at, shape_of(box)).distance_m, 0.05) << id;
      for (const auto& c : world->cylinders) EXPECT_GT(separation(at, shape_of(c)).distance_m, 0.05) << id;
    }
  }
}

TEST(ShippedRooms, AnUnknownNameIsToldWithTheKnownOnes) {
  const auto world = world_by_name("moon");
  ASSERT_FALSE(world);
  EXPECT_THAT(world.faults()[0].text(Lang::en), testing::HasSubstr("sala-1"));
  EXPECT_FALSE(world_by_name("./nothing.json"));
}

}  // namespace
}  // namespace mirada::world
