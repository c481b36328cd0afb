// What the documentation shows is what the engine does.
#include <gtest/gtest.h>

#include "base/files.h"
#include "programs/support.h"
#include "vm/disassemble.h"

namespace mirada::vm::test {
namespace {

std::string page(const std::string& name) {
  return *read_file(std::string(MIRADA_SOURCE_DIR) + "/docs/" + name);
}

/// The first fenced part of a page that is marked so.
std::string fenced(const std::string& text, const std::string& mark) {
  const std::string open = "\n```" + mark + "\n";
  const std::size_t from = text.find(open);
  if (from == std::string::npos) return {};
  const std::size_t start = from + open.size();
  return text.substr(start, text.find("```", start) - start);
}

TEST(Pages, TheWorkedExampleIsWhatTheCompilerMakesOfIt) {
  const std::string text = page("block-engine.md");
  const std::string program = fenced(text, "json");
  const auto loaded = load_program(program, core_catalog());
  ASSERT_TRUE(loaded.ok()) << to_text(loaded.faults(), Lang::en);
  EXPECT_EQ(fenced(text, "disasm"), disassemble(*loaded))
      << "put what `mirada disasm` gives into docs/block-engine.md, and look whether its words still fit";
  Running run{std::string_view(program)};
  run.finish();
  EXPECT_EQ(run.list("log"), "big: 9 big: 10");
}

TEST(Pages, ThePageOfInstructionsIsTheTable) {
  EXPECT_NE(page("instructions.md").find(instruction_table()), std::string::npos)
      << "put what `mirada disasm --table` gives into docs/instructions.md";
}

}  // namespace
}  // namespace mirada::vm::test
