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
