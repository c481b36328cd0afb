#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/files.h"
#include "packs/packs.h"

namespace mirada::packs {
namespace {

constexpr const char* kGood = R"({
  "format": 1, "id": "dance", "version": "1.0.0", "order": 5, "colour": "#4C97FF",
  "name": {"en": "Dance", "es": "Baile"},
  "blocks": [{
    "opcode": "dance_spin", "shape": "command", "implementation": "native", "needs": ["drive"],
    "text": {"en": "spin [TURNS] times [SIDE]", "es": "gira [SIDE] [TURNS] veces"},
    "args": [{"name": "TURNS", "type": "number", "min": 0, "max": 10, "default": 2},
             {"name": "SIDE", "type": "menu", "default": "left",
              "options": [{"value": "left", "text": {"en": "left", "es": "izquierda"}}]}]
  }]})";

const vm::NativeTable& natives() {
  static const vm::NativeTable table = {
      {"dance_spin", [](vm::NativeCall&) { return vm::NativeResult::finished(); }}};
  return table;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::vector<std::string> fault_codes(const std::string& text) {
  std::vector<std::string> codes;
  const Result<Pack> pack = read_pack(text, "dance/pack.json", natives());
  if (pack) return codes;
  for (const Fault& fault : pack.faults()) codes.emplace_back(fault.code());
  return codes;
}

TEST(PackReader, ReadsABlockWithItsArguments) {
  const Result<Pack> pack = read_pack(kGood, "dance/pack.json", natives());
  ASSERT_TRUE(pack) << to_text(pack.faults(), Lang::en);
  const vm::BlockDef& block = pack->blocks.at(0);
  EXPECT_EQ(block.pack, "dance");
  EXPECT_TRUE(block.native);
  EXPECT_TRUE(block.visible) << "a native block with needs is visible unless it says otherwise";
  EXPECT_EQ(block.args.at(0).max, 10);
  EXPECT_EQ(block.args.at(0).default_value, "2");
  EXPECT_FALSE(block.args.at(0).is_field);
  EXPECT_TRUE(block.args.at(1).is_field);
  EXPECT_EQ(block.args.at(1).options.at(0).es, "izquierda");
}

TEST(PackReader, ListsEveryFaultAtOnceWithItsPlace) {
  std::string bad = replaced(kGood, "#4C97FF", "blue");
  bad = replaced(bad, "\"es\": \"Baile\"", "\"es\": 7");
  bad = replaced(bad, "\"min\": 0", "\"min\": 20");
  bad = replaced(bad, "\"default\": \"left\"", "\"default\": \"up\"");
  bad = replaced(bad, "spin [TURNS]", "spin [TIMES]");
  const Result<Pack> pack = read_pack(bad, "dance/pack.json", natives());
  ASSERT_FALSE(pack);
  std::vector<std::string> places;
  for (const Fault& fault : pack.faults()) places.push_back(fault.place);
  const std::vector<std::string> expected = {"dance/pack.json/colour",
                                             "dance/pack.json/name/es",
                                             "dance/pack.json/blocks/0/args/0/min",
                                             "dance/pack.json/blocks/0/args/1/default",
                                             "dance/pack.json/blocks/0/text/en",
                                             "dance/pack.json/blocks/0/text/en"};
  EXPECT_EQ(places, expected);
}

TEST(PackReader, RefusesANativeBlockWithoutCode) {
  EXPECT_EQ(fault_codes(replaced(kGood, "dance_spin", "dance_jump")),
            std::vector<std::string>{"code_missing"});
}

TEST(PackReader, RefusesTheSameOpcodeOrArgumentTwice) {
  const std::string doubled = replaced(kGood, "\"SIDE\", \"type\"", "\"TURNS\", \"type\"");
  const std::vector<std::string> codes = fault_codes(doubled);
  EXPECT_NE(std::find(codes.begin(), codes.end(), "twice"), codes.end());
}

TEST(PackReader, RefusesBrokenJsonAndAnEmptyPack) {
  EXPECT_EQ(fault_codes("{\"format\": 1,"), std::vector<std::string>{"json_broken"});
  EXPECT_GE(fault_codes("{}").size(), 6u);
  EXPECT_EQ(fault_codes(replaced(kGood, "\"format\": 1", "\"format\": 2")),
            std::vector<std::string>{"wrong_format"});
}

TEST(PackReader, IsNotHurtByValuesOfAnyDepth) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  EXPECT_EQ(fault_codes(replaced(kGood, "\"format\": 1", "\"format\": " + deep)).back(), "number_needed");
  EXPECT_EQ(fault_codes(replaced(kGood, "\"default\": 2", "\"default\": " + deep)),
            std::vector<std::string>{"wrong_default"});
  EXPECT_EQ(fault_codes(replaced(kGood, "[\"drive\"]", deep)), std::vector<std::string>{"wrong_name"});
  EXPECT_EQ(fault_codes(replaced(kGood, "[\"drive\"]", "{\"a\": " + deep + "}")),
            std::vector<std::string>{"array_needed"});
}

TEST(LoadPacks, KeepsTheGoodOnesWhenOneIsBroken) {
  const auto folder = std::filesystem::temp_directory_path() / ("mirada-packs-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "dance");
  std::filesystem::create_directories(folder / "again");
  std::filesystem::create_directories(folder / "broken");
  ASSERT_TRUE(write_file_atomically(folder / "dance/pack.json", kGood));
  ASSERT_TRUE(
      write_file_atomically(folder / "again/pack.json", replaced(kGood, "\"order\": 5", "\"order\": 9")));
  ASSERT_TRUE(write_file_atomically(folder / "broken/pack.json", "{"));
  const PackSet set = load_packs(folder, natives());
  std::filesystem::remove_all(folder);
  ASSERT_EQ(set.packs.size(), 2u);
  EXPECT_EQ(set.packs[0].order, 5);
  EXPECT_NE(set.catalog.find("dance_spin"), nullptr);
  std::vector<std::string> codes;
  for (const Fault& fault : set.faults) codes.emplace_back(fault.code());
  EXPECT_EQ(codes, (std::vector<std::string>{"json_broken", "opcode_taken"}));
}

}  // namespace
}  // namespace mirada::packs
