// Scratch projects opened in the editor: the program that it gets does what the project does.
#include "vm/scratch_import.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/files.h"
#include "programs/support.h"

namespace mirada::vm::test {
namespace {

namespace fs = std::filesystem;

/// The cases that are Scratch projects, by claim.
std::vector<Json> projects() {
  std::vector<Json> out;
  for (const auto& entry : fs::directory_iterator(std::string(MIRADA_SOURCE_DIR) + "/tests/programs/cases")) {
    Json json = Json::parse(*read_file(entry.path().string()));
    if (json["program"].contains("targets")) out.push_back(std::move(json));
  }
  std::sort(out.begin(), out.end(), [](const Json& a, const Json& b) { return a["claim"] < b["claim"]; });
  return out;
}

void expect_same(const MonitorValue& got, const Json& want, const std::string& what) {
  EXPECT_EQ(got.text, want.is_string() ? want.get<std::string>() : want.dump()) << what;
  // JSON has no numbers such as these: the cases write them as texts.
  if (got.text == "NaN" || got.text.ends_with("Infinity")) return;
  EXPECT_EQ(got.is_number, want.is_number()) << what;
}

/// A sprite's own are "Sprite.name" in a project and "Sprite: name" on the one canvas.
std::string name_on_canvas(std::string name) {
  const std::size_t dot = name.find('.');
  return dot == std::string::npos ? name : name.replace(dot, 1, ": ");
}

void expect_same_values(const Json& expect, const Machine& machine) {
  const auto variables = machine.variables(kWholeMonitors);
  const auto lists = machine.lists(kWholeMonitors);
  const Json wanted_variables = expect.value("variables", Json::object());
  const Json wanted_lists = expect.value("lists", Json::object());
  for (const auto& [name, want] : wanted_variables.items()) {
    expect_same(variables.at(name_on_canvas(name)), want, name);
  }
  for (const auto& [name, want] : wanted_lists.items()) {
    const auto& got = lists.at(name_on_canvas(name));
    ASSERT_EQ(got.size(), want.size()) << name;
    for (std::size_t i = 0; i < want.size(); ++i) {
      expect_same(got[i], want[i], name + " item " + std::to_string(i + 1));
    }
  }
}

TEST(ScratchImport, WhatNeedsNoPlaceholderRunsAsItDidInScratch) {
  int run_here = 0;
  for (const Json& json : projects()) {
    SCOPED_TRACE(json["claim"].get<std::string>());
    const std::string text = json["program"].dump();
    // One canvas is one sprite; "all at once" is warp here, "stop all" ends everything where it
    // stands, and who waits leaves the tick to the others.
    const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
    const bool ends_tick =
        json["claim"].get<std::string>().find("ends the tick for the others") != std::string::npos;
    const bool differs =
        ends_tick || has("other scripts") || has("control_all_at_once") || has(R"("STOP_OPTION":["all")");
    if (differs) continue;
    const ImportedProject imported = import_scratch(text, core_catalog(), "Imported");
    ASSERT_FALSE(imported.program_json.empty());
    const Json program = Json::parse(imported.program_json);
    EXPECT_EQ(program["name"], "Imported");
    if (!imported.faults.empty()) continue;
    ++run_here;
    Running run(std::string_view(imported.program_json));
    for (const auto& key : json.value("keys", Json::array())) run.machine->key(key, true);
    run.finish(30, json.value("ticks", "back to back") != "world");
    expect_same_values(json["expect"], *run.machine);
  }
  EXPECT_GT(run_here, 15);
}

TEST(ScratchImport, WhatTheRobotLacksIsListedOnceAndKept) {
  for (const Json& json : projects()) {
    if (json["claim"] != "blocks that need a stage are skipped and said in one message") continue;
    const ImportedProject imported = import_scratch(json["program"].dump(), core_catalog(), "");
    ASSERT_EQ(imported.faults.size(), 1U);
    EXPECT_EQ(imported.faults[0].code(), "placeholder_blocks");
    EXPECT_NE(imported.faults[0].text(Lang::en).find("motion_movesteps, motion_xposition, pen_penDown"),
              std::string::npos);
    EXPECT_NE(imported.program_json.find("\"pen_penDown\""), std::string::npos);
    return;
  }
  FAIL() << "the case is gone";
}

TEST(ScratchImport, WhatIsNoScratchProjectIsRefusedInWords) {
  for (const std::string text :
       {"", "{}", "{\"targets\":7}", "{\"workspace\":{\"blocks\":{\"blocks\":[]}}}"}) {
    const ImportedProject imported = import_scratch(text, core_catalog(), "");
    EXPECT_TRUE(imported.program_json.empty()) << text;
    EXPECT_TRUE(has_errors(imported.faults)) << text;
  }
}

}  // namespace
}  // namespace mirada::vm::test
