// Scratch files as they come: archives, odd shapes, broken parts. What they mean is in cases/.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <zip.h>

#include "base/files.h"
#include "programs/support.h"

namespace mirada::vm::test {
namespace {

using Names = std::vector<std::pair<std::string, std::string>>;  // name, content

/// A real archive with these files, as bytes.
std::string archive(const Names& files) {
  const std::string path = testing::TempDir() + "mirada-scratch-file.sb3";
  int error = 0;
  zip_t* zip = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  for (const auto& [name, content] : files) {
    zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
    EXPECT_GE(zip_file_add(zip, name.c_str(), source, ZIP_FL_OVERWRITE), 0);
  }
  EXPECT_EQ(zip_close(zip), 0);
  std::string bytes = *read_file(path);
  std::filesystem::remove(path);
  return bytes;
}

/// A project whose stage has these blocks, a variable n and a list L, beside what `more` names.
std::string project(const std::string& blocks, const std::string& more = "") {
  return R"({"targets":[{"isStage":true,"name":"Stage","variables":{"vn":["n",0]},"lists":{"lL":["L",[]]},)"
         R"("broadcasts":{},"blocks":{)" +
         blocks + "}}" + more + R"(],"monitors":[],"extensions":[],"meta":{"semver":"3.0.0"}})";
}

std::string flag(const std::string& id, const std::string& next) {
  return "\"" + id + R"(":{"opcode":"event_whenflagclicked","next":")" + next +
         R"(","parent":null,"inputs":{},"fields":{},"shadow":false,"topLevel":true})";
}
std::string add(const std::string& id, const std::string& item, const std::string& next = "null") {
  return ",\"" + id + R"(":{"opcode":"data_addtolist","next":)" + next + R"(,"inputs":{"ITEM":)" + item +
         R"(},"fields":{"LIST":["L","lL"]},"shadow":false,"topLevel":false})";
}
std::string small() { return project(flag("a", "b") + add("b", R"([1,[10,"x"]])")); }

std::vector<std::string> codes(const Faults& faults) {
  std::vector<std::string> out;
  for (const Fault& fault : faults) out.emplace_back(fault.code());
  std::sort(out.begin(), out.end());
  return out;
}
std::vector<std::string> refusal(const std::string& bytes) {
  const auto loaded = load_program(bytes, core_catalog());
  return loaded.ok() ? std::vector<std::string>{"it loads"} : codes(loaded.faults());
}
using Codes = std::vector<std::string>;

TEST(ScratchFile, AnArchiveRunsWithWhateverElseIsInIt) {
  Running run(std::string_view(archive(
      {{"0a1b.svg", "<svg/>"}, {"project.json", small()}, {"../../etc/passwd", "no"}, {"x.wav", ""}})));
  run.finish();
  EXPECT_EQ(run.list("L"), "x");
}

TEST(ScratchFile, TheProjectMayLieInOneFolder) {
  Running run(std::string_view(archive({{"My game/project.json", small()}})));
  run.finish();
  EXPECT_EQ(run.list("L"), "x");
}

TEST(ScratchFile, StopAllMayComeTwiceInOneRoundWithACloneAbout) {
  std::ifstream in(std::string(MIRADA_SOURCE_DIR) +
                   "/tests/fuzz/corpus/scratch/stop-all-twice-in-one-round-with-a-clone-about.json");
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  ASSERT_FALSE(text.empty());
  Running run{std::string_view(text)};
  EXPECT_TRUE(run.finish(5, false));
}

TEST(ScratchFile, ADotInAPathIsTheSamePlace) {
  for (const char* name :
       {"./project.json", "././project.json", "./My game/project.json", "My game/./project.json"}) {
    Running run(std::string_view(archive({{name, small()}})));
    run.finish();
    EXPECT_EQ(run.list("L"), "x") << name;
  }
  const std::string other = project(flag("a", "b") + add("b", R"([1,[10,"folder"]])"));
  Running run(std::string_view(archive({{"old/project.json", other}, {"./project.json", small()}})));
  run.finish();
  EXPECT_EQ(run.list("L"), "x");
}

TEST(ScratchFile, OtherArchivesAreRefusedInWords) {
  EXPECT_EQ(refusal(archive({{"readme.txt", "x"}})), Codes{"archive_without_project"});
  EXPECT_EQ(refusal(archive({{"../project.json", small()}})), Codes{"archive_without_project"});
  for (const char* trick :
       {"/project.json", ".//project.json", "./../project.json", "a/../project.json", "..\\project.json",
        "a\\b/project.json", ".git/project.json", "a/b/project.json"}) {
    EXPECT_EQ(refusal(archive({{trick, small()}})), Codes{"archive_without_project"}) << trick;
  }
  EXPECT_EQ(refusal(archive({{"sprite.json", "{}"}})), Codes{"only_a_sprite"});
  EXPECT_EQ(refusal(archive({{"project.json", R"({"objName":"Stage","children":[]})"}})),
            Codes{"old_scratch"});
  EXPECT_EQ(refusal(R"({"objName":"Stage","children":[]})"), Codes{"old_scratch"});
  EXPECT_EQ(refusal("ScratchV02\x01\x02"), Codes{"old_scratch"});
  EXPECT_EQ(refusal("PK\x03\x04 and then nothing"), Codes{"archive_broken"});
  EXPECT_EQ(refusal(archive({{"project.json", "{\"targets\":"}})), Codes{"project_broken"});
  EXPECT_EQ(refusal(archive({{"project.json", "{\"meta\":{}}"}})), Codes{"no_targets"});
  std::string cut = archive({{"project.json", small()}});
  cut.resize(cut.size() / 2);
  EXPECT_EQ(refusal(cut), Codes{"archive_broken"});
}

TEST(ScratchFile, ABombIsNotUnpacked) {
  const std::string bomb = archive({{"project.json", small() + std::string(20u << 20, ' ')}});
  EXPECT_LT(bomb.size(), 1u << 20);
  EXPECT_EQ(refusal(bomb), Codes{"archive_too_large"});
}

TEST(ScratchFile, EveryWrongShapeIsToldAtOnce) {
  const std::string bad =
      R"({"targets":[7,{"isStage":true,"name":"Stage","variables":{"v":5},"lists":{"l":["L",{}]},)"
      R"("broadcasts":{"m":3},"blocks":{"s":"text","a":{"opcode":"event_whenflagclicked","next":3,)"
      R"("topLevel":true,"inputs":[1],"fields":{"F":7}},"b":{"topLevel":true,"inputs":{"X":4,"Y":[1,{}],)"
      R"("Z":[1,[99,""]]}}}},{"name":"Cat","blocks":4}]})";
  const auto loaded = load_program(bad, core_catalog());
  ASSERT_FALSE(loaded.ok());
  std::vector<std::string> places;
  for (const Fault& fault : loaded.faults()) {
    if (fault.code() == "wrong_shape") places.push_back(fault.place);
  }
  std::sort(places.begin(), places.end());
  const std::string b = "/targets/1/blocks/";
  EXPECT_EQ(places,
            (Codes{"/targets/0", b + "a/fields/F", b + "a/inputs", b + "a/next", b + "b/inputs/X",
                   b + "b/inputs/Y/1", b + "b/inputs/Z/1", b + "b/opcode", b + "s", "/targets/1/broadcasts/m",
                   "/targets/1/lists/l", "/targets/1/variables/v", "/targets/2/blocks"}));
}

TEST(ScratchFile, WhatIsNotThereOrGoesInACircleIsLeftOutAndTheRestRuns) {
  const std::string text = project(flag("a", "b") + add("b", R"([3,"gone",[10,"beneath"]])", "\"c\"") +
                                   add("c", R"([1,[10,"y"]])", "\"b\"") + "," + flag("d", "nowhere") + "," +
                                   flag("e", "f") + add("f", R"([1,[10,"z"]])"));
  Running run{std::string_view(text)};
  EXPECT_EQ(codes(run.loaded.warnings), (Codes{"block_cycle", "dangling_block", "dangling_block"}));
  run.finish();
  EXPECT_EQ(run.list("L"), "beneath y z");
}

TEST(ScratchFile, ScriptsStartInTheOrderInWhichJavaScriptGoesThroughTheFile) {
  std::string blocks;
  for (const char* id : {"z", "10", "k", "2"}) {
    blocks += (blocks.empty() ? "" : ",") + flag(id, std::string(id) + "+") +
              add(std::string(id) + "+", "[1,[10,\"" + std::string(id) + "\"]]");
  }
  Running run{std::string_view(project(blocks))};
  run.finish();
  EXPECT_EQ(run.list("L"), "2 10 z k");
}

TEST(ScratchFile, SocketsAreReadInEveryFormThatWritersUse) {
  const std::string text = project(
      flag("a", "b") + add("b", R"([1,[4,7]])", "\"c\"") + add("c", R"([1,[9,"#ff0000"]])", "\"d\"") +
      add("d", R"([3,[12,"n","vn"],[10,""]])", "\"e\"") + add("e", R"([1,null])", "\"f\"") +
      add("f", R"([1,"lit"])", "\"g\"") +
      R"(,"lit":{"opcode":"text","next":null,"inputs":{},"fields":{"TEXT":["own"]},"shadow":true,"topLevel":false})"
      R"(,"g":{"opcode":"control_repeat","next":null,"inputs":{"TIMES":[1,[6,"2"]],"SUBSTACK":[1,"h"]},"fields":{},)"
      R"("shadow":false,"topLevel":false})" +
      add("h", R"([1,[10,"in"]])") + R"(,"loose":[12,"n","vn",40,50])");
  Running run{std::string_view(text)};
  EXPECT_TRUE(run.loaded.warnings.empty());
  run.finish();
  EXPECT_EQ(run.list("L"), "7 #ff0000 0  own in in");
  EXPECT_TRUE(run.machine->lists().at("L")[0].is_number);
}

/// Scratch reads these words in whatever case; projects that came from Scratch 2 have them small.
TEST(ScratchFile, WordsOfMenusAreReadInAnyCase) {
  const std::string text =
      project(R"("t":{"opcode":"event_whengreaterthan","next":"u","inputs":{"VALUE":[1,[4,"0"]]},"fields":{)"
              R"("WHENGREATERTHANMENU":["timer"]},"shadow":false,"topLevel":true})" +
              add("u", R"([1,[10,"timer"]])") + "," + flag("a", "w") +
              R"(,"w":{"opcode":"control_wait","next":"b","inputs":{"DURATION":[1,[5,"0.1"]]},"fields":{})"
              R"(,"shadow":false,"topLevel":false})" +
              add("b", R"([3,"m",[10,""]])") +
              R"(,"m":{"opcode":"operator_mathop","next":null,"inputs":{"NUM":[1,[4,"2.5"]]},"fields":{)"
              R"("OPERATOR":["FLOOR"]},"shadow":false,"topLevel":false})");
  Running run{std::string_view(text)};
  EXPECT_TRUE(run.loaded.warnings.empty());
  run.finish(1, false);
  EXPECT_EQ(run.list("L"), "timer 2");
}

TEST(ScratchFile, ABlockThatNamesNoListOrVariableIsMarked) {
  const std::string text = project(
      flag("a", "b") +
      R"(,"b":{"opcode":"data_addtolist","next":"c","inputs":{"ITEM":[1,[10,"x"]]},"fields":{},"shadow":false,"topLevel":false})"
      R"(,"c":{"opcode":"data_setvariableto","next":"d","inputs":{"VALUE":[1,[10,"x"]]},"fields":{},"shadow":false,"topLevel":false})" +
      add("d", R"([1,[10,"y"]])"));
  Running run{std::string_view(text)};
  EXPECT_EQ(codes(run.loaded.warnings), (Codes{"field_absent", "field_absent"}));
  EXPECT_EQ(run.loaded.warnings.at(0).place, "b");
  EXPECT_NE(to_text({run.loaded.warnings.at(0)}, Lang::en).find("LIST"), std::string::npos);
  run.finish();
  EXPECT_EQ(run.list("L"), "y");
}

TEST(ScratchFile, SpritesMayUseTheSameIdsAndNames) {
  const auto cat = [](const std::string& name) {
    return R"(,{"isStage":false,"name":")" + name + R"(","variables":{"vn":["n",0]},"lists":{},"blocks":{)" +
           flag("a", "b") + R"(,"b":{"opcode":"data_setvariableto","next":null,"inputs":{"VALUE":[1,[10,")" +
           name + R"("]]},"fields":{"VARIABLE":["n","vn"]},"shadow":false,"topLevel":false}}})";
  };
  Running run{std::string_view(project("", cat("Cat") + cat("Dog")))};
  run.finish();
  EXPECT_EQ(run.machine->variables().at("Cat.n").text, "Cat");
  EXPECT_EQ(run.machine->variables().at("Dog.n").text, "Dog");
  EXPECT_EQ(run.machine->variables().at("n").text, "0");
}

TEST(ScratchFile, AProjectWithoutAStageRunsOnAnEmptyOne) {
  const std::string text = R"({"targets":[{"isStage":false,"name":"Cat","variables":{"vn":["n",0]},"lists":{)"
                           R"("lL":["L",[]]},"blocks":{)" +
                           flag("a", "b") + add("b", R"([1,[10,"x"]])") + "}}]}";
  Running run{std::string_view(text)};
  EXPECT_EQ(codes(run.loaded.warnings), Codes{"no_stage"});
  run.finish();
  EXPECT_EQ(run.list("Cat.L"), "x");
}

TEST(ScratchFile, TenThousandDeepIsOneFault) {
  constexpr int kDepth = 10'000;
  std::string blocks = flag("a", "b") + add("b", R"([2,"j0"])");
  for (int i = 0; i < kDepth; ++i) {
    const std::string inner = i + 1 < kDepth ? "[2,\"j" + std::to_string(i + 1) + "\"]" : R"([1,[10,"x"]])";
    blocks += ",\"j" + std::to_string(i) + R"(":{"opcode":"operator_join","next":null,"inputs":{"STRING1":)" +
              inner + R"(},"fields":{},"shadow":)" + (i % 2 ? "true" : "false") + R"(,"topLevel":false})";
  }
  EXPECT_EQ(refusal(project(blocks)), Codes{"nested_too_deep"});
}

TEST(ScratchFile, ManyBlocksAndVariablesAreReadInTheirTime) {
  std::string blocks;
  for (int i = 0; i < 20'000; ++i) {
    blocks += (i ? ",\"b" : "\"b") + std::to_string(i) +
              R"(":{"opcode":"data_changevariableby","next":null,"inputs":{"VALUE":[1,[4,"1"]]},)"
              R"("fields":{"VARIABLE":["w)" +
              std::to_string(i) + R"(","id)" + std::to_string(i) + R"("]},"shadow":false,"topLevel":true})";
  }
  EXPECT_EQ(refusal(project(blocks)), Codes{"it loads"});
}

}  // namespace
}  // namespace mirada::vm::test
