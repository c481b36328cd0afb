#include "model/place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirada {
namespace {

using testing::HasSubstr;

TEST(Place, tells_where_its_tags_hang) {
  const auto place =
      read_place(R"({"format": "mirada-place", "version": 1, "id": "hall", "name": {"en": "Hall"},
    "start": {"x_m": 1, "y_m": 2, "heading_deg": 90},
    "tags": [{"id": 7, "x_m": -1.5, "y_m": 0.25, "heading_deg": 180, "size_m": 0.15}]})",
                 "hall.json");
  ASSERT_TRUE(place.ok());
  EXPECT_EQ(place->name_es, "Hall");
  ASSERT_NE(place->tag(7), nullptr);
  EXPECT_EQ(place->tag(8), nullptr);
  EXPECT_DOUBLE_EQ(place->tag(7)->X_PT.x_m, -1.5);
  EXPECT_DOUBLE_EQ(place->tag(7)->size_m, 0.15);
  EXPECT_DOUBLE_EQ(place->X_PR_start->heading_rad, rad(90));
}

TEST(Place, gives_all_its_faults_at_once) {
  const auto place = read_place(R"({"format": "mirada-world", "version": 1, "id": "hall",
    "tags": [{"id": 7, "x_m": 99, "y_m": 0, "heading_deg": 0}, {"id": 7, "x_m": 0, "y_m": 0, "heading_deg": 0, "size_m": 3},
             {"id": 1.5, "x_m": 0, "y_m": 0}]})",
                                "hall.json");
  ASSERT_FALSE(place.ok());
  const std::string words = to_text(place.faults(), Lang::en);
  for (const char* part : {"mirada-world", "x_m", "twice", "size_m", "1.5", "heading_deg", "hall.json"})
    EXPECT_THAT(words, HasSubstr(part));
}

TEST(Place, tells_where_its_lines_are_painted) {
  const auto place = read_place(R"({"format": "mirada-place", "version": 1, "id": "field", "lines": [
    {"points": [[0, 0], [2, 0], [2, 1.5]]}, {"circle": {"x_m": 1, "y_m": -1, "radius_m": 0.5}, "width_m": 0.03}]})",
                                "field.json");
  ASSERT_TRUE(place.ok());
  ASSERT_EQ(place->lines.size(), 2u);
  EXPECT_EQ(place->lines[1].p_PA_m, Eigen::Vector2d(2, 0));
  EXPECT_EQ(place->lines[1].p_PB_m, Eigen::Vector2d(2, 1.5));
  EXPECT_DOUBLE_EQ(place->lines[1].width_m, 0.05);
  ASSERT_EQ(place->circles.size(), 1u);
  EXPECT_EQ(place->circles[0].p_PC_m, Eigen::Vector2d(1, -1));
  EXPECT_DOUBLE_EQ(place->circles[0].radius_m, 0.5);
  EXPECT_DOUBLE_EQ(place->circles[0].width_m, 0.03);
}

TEST(Place, gives_all_faults_of_its_lines_at_once) {
  const auto place = read_place(R"({"format": "mirada-place", "version": 1, "id": "field", "lines": [
    {"points": [[0, 0]]}, {"points": [[0, 0], [77, 0], [0, 1]]}, {"width_m": 0.5},
    {"circle": {"x_m": 1, "radius_m": 0.1}}, {"points": [[0, 0], [0, 1], [0, 1.01]]}]})",
                                "field.json");
  ASSERT_FALSE(place.ok());
  EXPECT_EQ(place.faults().size(), 7u);
  for (const Lang lang : {Lang::en, Lang::es}) {
    const std::string words = to_text(place.faults(), lang);
    for (const char* part : {"/lines/0/points", "2 ", " 50 ", "/lines/1/points/1", "[77,0]",
                             "/lines/2/width_m", "0.5", "0.3", "/lines/2/points", "/lines/3/circle/y_m",
                             "/lines/3/circle/radius_m", "0.1", "/lines/4/points/2", "0.01 m", "0.05 m"})
      EXPECT_THAT(words, HasSubstr(part));
  }
}

TEST(Place, the_green_field_has_the_lines_of_its_markings) {
  const auto place = place_by_name("green-field");
  ASSERT_TRUE(place.ok());
  EXPECT_EQ(place->lines.size(), 11u);
  EXPECT_EQ(place->circles.size(), 1u);
  EXPECT_TRUE(place->has_lines());
  EXPECT_FALSE(place_by_name("workshop")->has_lines());
}

TEST(Place, the_places_that_ship_are_sound) {
  EXPECT_THAT(shipped_places(), testing::ElementsAre("green-field", "sala-1", "workshop"));
  for (const std::string& id : shipped_places()) EXPECT_TRUE(place_by_name(id).ok()) << id;
  EXPECT_THAT(to_text(place_by_name("moon").faults(), Lang::es), HasSubstr("sala-1"));
}

}  // namespace
}  // namespace mirada
