// Runs every program in cases/: {claim, rules?: [of docs/scratch-rules.md], program, ticks?: "world", keys?:
// [..], expect: {...}}. What is expected is compared exactly; what is not named is not looked at.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "programs/support.h"
#include "vm/scratch_blocks.h"

namespace mirada::vm::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(std::string(MIRADA_SOURCE_DIR) + "/tests/programs/cases")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Json read_case(const fs::path& file) { return Json::parse(*read_file(file)); }

Json as_json(const MonitorValue& value) {
  if (value.is_truth) return value.text == "true";
  if (value.is_number && std::isfinite(value.number)) return value.number;
  return value.text;
}

/// Numbers compare by value, so that 3 and 3.0 are one.
void expect_value(const Json& got, const Json& want, const std::string& what) {
  if (got.is_number() && want.is_number()) {
    EXPECT_EQ(got.get<double>(), want.get<double>()) << what;
  } else {
    EXPECT_EQ(got.dump(), want.dump()) << what;
  }
}

class Case : public testing::TestWithParam<fs::path> {};

void check_variables(const Machine& machine, const Json& expect) {
  const auto variables = machine.variables(kWholeMonitors);
  for (const auto& [name, want] : expect.items()) {
    ASSERT_TRUE(variables.contains(name)) << name;
    expect_value(as_json(variables.at(name)), want, name);
  }
}

void check_lists(const Machine& machine, const Json& expect) {
  const auto lists = machine.lists(kWholeMonitors);
  for (const auto& [name, want] : expect.items()) {
    ASSERT_TRUE(lists.contains(name)) << name;
    Json got = Json::array();
    for (const MonitorValue& item : lists.at(name)) got.push_back(as_json(item));
    ASSERT_EQ(got.size(), want.size()) << name << ": " << got.dump();
    for (std::size_t i = 0; i < got.size(); ++i)
      expect_value(got[i], want[i], name + " item " + std::to_string(i + 1));
  }
}

Json faults_of(std::vector<std::pair<std::string, std::string>> faults) {
  std::sort(faults.begin(), faults.end());
  Json out = Json::array();
  for (const auto& [place, code] : faults) out.push_back({place, code});
  return out;
}

void run_case(const Json& json) {
  const Json& expect = json["expect"];
  const Result<LoadedProgram> loaded = load_program(json["program"].dump(), core_catalog());
  std::vector<std::pair<std::string, std::string>> found;
  for (const Fault& fault : loaded.ok() ? loaded->warnings : loaded.faults()) {
    found.emplace_back(fault.place, std::string(fault.code()));
  }
  EXPECT_EQ(loaded.ok(), !expect.contains("refused")) << faults_of(found).dump();
  const char* kind = loaded.ok() ? "warnings" : "refused";
  EXPECT_EQ(faults_of(found).dump(), expect.value(kind, Json::array()).dump());
  if (!loaded.ok()) return;
  Running run(json["program"]);
  for (const auto& key : json.value("keys", Json::array())) run.machine->key(key, true);
  EXPECT_TRUE(run.finish(json.value("seconds", 30.0), json.value("ticks", "back to back") != "world"))
      << "the program still runs after " << Running::kMostTicks << " ticks and never waits";
  std::vector<std::pair<std::string, std::string>> faults;
  for (const BlockFault& fault : run.machine->take_faults()) {
    faults.emplace_back(fault.block, std::string(fault.fault.code()));
  }
  EXPECT_EQ(faults_of(faults).dump(), expect.value("faults", Json::array()).dump());
  check_variables(*run.machine, expect.value("variables", Json::object()));
  check_lists(*run.machine, expect.value("lists", Json::object()));
  if (expect.contains("say")) {
    EXPECT_EQ(Json(run.host.said).dump(), expect["say"].dump());
  }
  if (expect.contains("executions")) {
    EXPECT_EQ(run.machine->block_executions(), expect["executions"].get<std::uint64_t>());
  }
}

TEST_P(Case, DoesWhatItClaims) {
  const Json json = read_case(GetParam());
  SCOPED_TRACE(json["claim"].get<std::string>());
  ASSERT_TRUE(json.contains("expect"));
  run_case(json);
}

/// {"program": forever {}, ...}: fails, but ends.
Json endless_case() {
  return {{"program", program({hat({block("control_forever")})}, {})}, {"expect", Json::object()}};
}
TEST(CaseRunner, AProgramThatNeverEndsFailsItsCaseInWords) {
  EXPECT_NONFATAL_FAILURE(run_case(endless_case()), "the program still runs after 20000 ticks");
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, Case, testing::ValuesIn(case_files()), name_of);

/// The opcodes of a program, ours ("type") or Scratch's ("opcode").
void collect_opcodes(const Json& json, std::set<std::string>& opcodes) {
  for (const char* key : {"type", "opcode"}) {
    if (json.is_object() && json.contains(key) && json[key].is_string()) opcodes.insert(json[key]);
  }
  for (const auto& item : json.items()) {
    if (item.value().is_structured()) collect_opcodes(item.value(), opcodes);
  }
}

std::set<std::string> opcodes_in_cases() {
  std::set<std::string> opcodes;
  for (const fs::path& file : case_files()) collect_opcodes(read_case(file)["program"], opcodes);
  return opcodes;
}

TEST(Cases, EveryOpcodeOfTheCorePacksHasAProgram) {
  const std::set<std::string> opcodes = opcodes_in_cases();
  for (const auto& [opcode, def] : core_catalog().all()) EXPECT_TRUE(opcodes.contains(opcode)) << opcode;
  const auto scratch = scratch_blocks();
  for (const auto& [opcode, def] : scratch->all()) EXPECT_TRUE(opcodes.contains(opcode)) << opcode;
}

/// Scratch 3's own blocks that need no stage: each is known here and has a program.
TEST(Cases, EveryStagelessOpcodeOfScratchIsKnownAndHasAProgram) {
  const std::set<std::string> opcodes = opcodes_in_cases();
  const auto scratch = scratch_blocks();
  constexpr const char* kOpcodes[] = {"event_whenflagclicked",
                                      "event_whenkeypressed",
                                      "event_whenbroadcastreceived",
                                      "event_whengreaterthan",
                                      "event_broadcast",
                                      "event_broadcastandwait",
                                      "control_wait",
                                      "control_repeat",
                                      "control_forever",
                                      "control_if",
                                      "control_if_else",
                                      "control_wait_until",
                                      "control_repeat_until",
                                      "control_while",
                                      "control_for_each",
                                      "control_all_at_once",
                                      "control_stop",
                                      "control_start_as_clone",
                                      "control_create_clone_of",
                                      "control_delete_this_clone",
                                      "control_get_counter",
                                      "control_incr_counter",
                                      "control_clear_counter",
                                      "operator_add",
                                      "operator_subtract",
                                      "operator_multiply",
                                      "operator_divide",
                                      "operator_random",
                                      "operator_gt",
                                      "operator_lt",
                                      "operator_equals",
                                      "operator_and",
                                      "operator_or",
                                      "operator_not",
                                      "operator_join",
                                      "operator_letter_of",
                                      "operator_length",
                                      "operator_contains",
                                      "operator_mod",
                                      "operator_round",
                                      "operator_mathop",
                                      "data_variable",
                                      "data_setvariableto",
                                      "data_changevariableby",
                                      "data_showvariable",
                                      "data_hidevariable",
                                      "data_listcontents",
                                      "data_addtolist",
                                      "data_deleteoflist",
                                      "data_deletealloflist",
                                      "data_insertatlist",
                                      "data_replaceitemoflist",
                                      "data_itemoflist",
                                      "data_itemnumoflist",
                                      "data_lengthoflist",
                                      "data_listcontainsitem",
                                      "data_showlist",
                                      "data_hidelist",
                                      "procedures_definition",
                                      "procedures_call",
                                      "argument_reporter_string_number",
                                      "argument_reporter_boolean",
                                      "sensing_timer",
                                      "sensing_resettimer",
                                      "looks_say",
                                      "looks_think",
                                      "looks_sayforsecs",
                                      "looks_thinkforsecs",
                                      "looks_gotofrontback",
                                      "looks_goforwardbackwardlayers"};
  for (const char* opcode : kOpcodes) {
    EXPECT_TRUE(core_catalog().find(opcode) || scratch->find(opcode)) << opcode;
    EXPECT_TRUE(opcodes.contains(opcode)) << opcode;
  }
}

/// docs/scratch-rules.md numbers its rules in lines "1. ...".
TEST(Cases, EveryRuleOfScratchHasAProgram) {
  std::set<int> claimed;
  for (const fs::path& file : case_files()) {
    for (const Json& rule : read_case(file).value("rules", Json::array())) claimed.insert(rule.get<int>());
  }
  const Result<std::string> page = read_file(std::string(MIRADA_SOURCE_DIR) + "/docs/scratch-rules.md");
  ASSERT_TRUE(page.ok());
  std::istringstream lines(*page);
  std::set<int> rules;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t dot = line.find(". ");
    if (dot != 0 && dot <= 2 && std::isdigit(static_cast<unsigned char>(line[0]))) {
      rules.insert(std::stoi(line));
    }
  }
  EXPECT_EQ(rules.size(), 23U);
  EXPECT_EQ(claimed, rules);
}

}  // namespace
}  // namespace mirada::vm::test
