// Runs every program in robot_cases/ on the simulated robot: {claim, world?, seconds?, program, expect:
// {status?, faults?, variables?, robot?, say?}}. What is expected is a value or {"from", "to"}.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "rig/lockstep.h"
#include "rig/station_factory.h"

namespace mirada::rig {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(std::string(MIRADA_SOURCE_DIR) + "/tests/programs/" + folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Json read_json(const fs::path& file) { return Json::parse(*read_file(file)); }

void expect_value(const Json& got, const Json& want, const std::string& what) {
  if (!want.is_object()) {
    EXPECT_EQ(got, want) << what;
    return;
  }
  ASSERT_TRUE(got.is_number()) << what << " is " << got.dump();
  EXPECT_GE(got.get<double>(), want["from"].get<double>()) << what;
  EXPECT_LE(got.get<double>(), want["to"].get<double>()) << what;
}

void expect_values(const Json& got, const Json& want) {
  for (const auto& [name, value] : want.items()) {
    ASSERT_TRUE(got.contains(name)) << name;
    expect_value(got[name], value, name);
  }
}

class RobotCase : public testing::TestWithParam<fs::path> {};

TEST_P(RobotCase, DoesWhatItClaims) {
  const Json json = read_json(GetParam());
  SCOPED_TRACE(json["claim"].get<std::string>());
  LockstepOptions options;
  options.robot = robot_by_name("mirada-sim").value();
  if (json.contains("world")) options.world = world::world_by_name(json["world"]).value();
  options.seconds = json.value("seconds", 20.0);
  const Json report = to_json(run_lockstep(json["program"].dump(), options), Lang::en);
  const Json& expect = json["expect"];
  EXPECT_EQ(report["faults"], expect.value("faults", Json::array()));
  if (expect.contains("status")) {
    EXPECT_EQ(report["status"], expect["status"]);
  }
  expect_values(report["variables"], expect.value("variables", Json::object()));
  if (expect.contains("robot")) expect_values(report["robot"], expect["robot"]);
  Json said = Json::array();
  for (const Json& one : report["say"]) said.push_back(one["text"]);
  if (expect.contains("say")) {
    EXPECT_EQ(said, expect["say"]);
  }
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, RobotCase, testing::ValuesIn(files_in("robot_cases")), name_of);

void collect_opcodes(const Json& json, std::set<std::string>& opcodes) {
  if (json.is_object() && json.contains("type") && json["type"].is_string()) opcodes.insert(json["type"]);
  for (const auto& item : json.items()) {
    if (item.value().is_structured()) collect_opcodes(item.value(), opcodes);
  }
}

TEST(RobotCases, EveryOpcodeOfEveryPackHasAProgram) {
  std::set<std::string> opcodes;
  for (const char* folder : {"cases", "robot_cases"}) {
    for (const fs::path& file : files_in(folder)) collect_opcodes(read_json(file)["program"], opcodes);
  }
  const auto packs = load_shipped_packs();
  for (const auto& [opcode, def] : packs->catalog.all()) EXPECT_TRUE(opcodes.contains(opcode)) << opcode;
}

}  // namespace
}  // namespace mirada::rig
