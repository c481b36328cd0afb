// Six projects that Scratch ran, with the list that each left.
#include <fstream>

#include <gtest/gtest.h>

#include "base/files.h"
#include "programs/support.h"

namespace mirada::vm::test {
namespace {

TEST(Interleaving, ScriptsTakeTurnsAsInScratch) {
  const std::string folder = std::string(MIRADA_SOURCE_DIR) + "/tests/data/scratch/interleavings/";
  const Json expected = Json::parse(*read_file(folder + "expected.json"));
  ASSERT_EQ(expected.size(), 6U);
  for (const auto& [file, row] : expected.items()) {
    const Result<std::string> project = read_file(folder + file);
    ASSERT_TRUE(project.ok()) << file;
    for (const bool back_to_back : {true, false}) {
      const std::string_view text(*project);
      Running run(text);
      run.finish(60, back_to_back);
      EXPECT_EQ(run.list("L"), row["list L at the end, joined by spaces"].get<std::string>()) << row["claim"];
    }
  }
}

}  // namespace
}  // namespace mirada::vm::test
