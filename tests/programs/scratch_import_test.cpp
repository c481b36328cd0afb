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

void expect_same_values(const Json& expect, const Machine& machine) {
  const auto variables = machine.variables();
  const auto lists = machine.lists(200'000);
  const Json wanted_variables = expect.value("variables", Json::object());
  const Json wanted_lists = expect.value("lists", Json::object());
  for (const auto& [name, want] : wanted_variables.items()) {
    if (name.find('.') != std::string::npos) continue;  // a sprite's own has another name here
    const std::string text = want.is_string() ? want.get<std::string>() : want.dump();
    EXPECT_EQ(variables.at(name).text, text) << name;
  }
  for (const auto& [name, want] : wanted_lists.items()) {
    if (name.find('.') != std::string::npos) continue;
    ASSERT_EQ(lists.at(name).size(), want.size()) << name;
    for (std::size_t i = 0; i < want.size(); ++i) {
      const std::string text = want[i].is_string() ? want[i].get<std::string>() : want[i].dump();
      EXPECT_EQ(lists.at(name)[i].text, text) << name << " item " << i + 1;
    }
  }
}

TEST(ScratchImport, WhatNeedsNoPlaceholderRunsAsItDidInScratch) {
  int run_here = 0;
  for (const Json& json : projects()) {
    SCOPED_TRACE(json["claim"].get<std::string>());
    const std::string text = json["program"].dump();
    // One canvas is one sprite; "all at once" is warp here; a call of ours has no defaults for empty slots.
    const bool differs = text.find("other scripts") != std::string::npos ||
                         text.find("control_all_at_once") != std::string::npos ||
                         text.find("flags %b %s") != std::string::npos;
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
