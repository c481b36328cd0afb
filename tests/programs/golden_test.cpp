// Every operator result recorded from Scratch, computed by programs: once with operands that the compiler
// knows nothing about, once with literals, where it specialises.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "programs/support.h"

namespace mirada::vm::test {
namespace {

struct Row {
  std::string opcode;
  std::string first, second;  // inputs
  Json fields = Json::object();
};

Row row_of(const std::string& op) {
  if (op.starts_with("mathop:")) return {"operator_mathop", "NUM", "", {{"OPERATOR", op.substr(7)}}};
  if (op == "round") return {"operator_round", "NUM", ""};
  if (op == "not") return {"operator_not", "OPERAND", ""};
  if (op == "length") return {"operator_length", "STRING", ""};
  if (op == "letter_of") return {"operator_letter_of", "LETTER", "STRING"};
  if (op == "join" || op == "contains") return {"operator_" + op, "STRING1", "STRING2"};
  const bool numbers = op == "add" || op == "subtract" || op == "multiply" || op == "divide" || op == "mod";
  if (numbers) return {"operator_" + op, "NUM1", "NUM2"};
  return {"operator_" + op, "OPERAND1", "OPERAND2"};
}

double number_from(const std::string& text) {
  if (text == "NaN") return NAN;
  if (text == "Infinity") return INFINITY;
  if (text == "-Infinity") return -INFINITY;
  return std::stod(text);
}

/// Blocks that hand operand `index` of the test to the program, so that its type is not known before.
class Operands {
 public:
  Operands() {
    for (const auto& [opcode, def] : core_catalog().all()) catalog.add(def);
    BlockDef def;
    def.opcode = "test_operand";
    def.pack = "test";
    def.shape = Shape::reporter;
    def.args.resize(1);
    def.args[0].name = "N";
    def.native = [this](NativeCall& call) {
      const Json& value = values[static_cast<std::size_t>(call.number(0))];
      if (value.contains("n")) return NativeResult::of(number_from(value["n"]));
      if (value.contains("s")) return NativeResult::of(value["s"].get<std::string>());
      return NativeResult::of(value["b"].get<bool>());
    };
    catalog.add(def);
  }
  Json unknown(const Json& value) {
    values.push_back(value);
    return in(block("test_operand", {{"N", number(static_cast<double>(values.size() - 1))}}));
  }
  Json literal(const Json& value) {
    if (value.contains("s")) return text(value["s"]);
    if (value.contains("n") && std::isfinite(number_from(value["n"])) && value["n"] != "-0") {
      return number(number_from(value["n"]));
    }
    return unknown(value);
  }
  BlockCatalog catalog;
  std::vector<Json> values;
};

void expect_same(const MonitorValue& got, const Json& want, const Json& op) {
  if (want.contains("b")) {
    EXPECT_TRUE(got.is_truth) << op.dump();
    EXPECT_EQ(got.text, want["b"].get<bool>() ? "true" : "false") << op.dump();
  } else if (want.contains("s")) {
    EXPECT_FALSE(got.is_number) << op.dump();
    EXPECT_EQ(got.text, want["s"].get<std::string>()) << op.dump();
  } else {
    const double number = number_from(want["n"]);
    EXPECT_TRUE(got.is_number) << op.dump();
    if (std::isnan(number)) {
      EXPECT_TRUE(std::isnan(got.number)) << op.dump() << " gave " << got.text;
    } else {
      EXPECT_EQ(got.number, number) << op.dump() << " gave " << got.text;
      EXPECT_EQ(std::signbit(got.number), std::signbit(number)) << op.dump();
    }
  }
}

void check_all(bool literals) {
  std::ifstream file(std::string(MIRADA_SOURCE_DIR) + "/tests/data/scratch/golden-sample.json");
  const Json golden = Json::parse(file);
  const Json& ops = golden["ops"];
  ASSERT_EQ(ops.size(), 4693U);
  constexpr std::size_t kChunk = 500;
  for (std::size_t from = 0; from < ops.size(); from += kChunk) {
    Operands operands;
    std::vector<Json> blocks;
    const std::size_t to = std::min(ops.size(), from + kChunk);
    for (std::size_t i = from; i < to; ++i) {
      const Row row = row_of(ops[i][0]);
      Json inputs;
      const auto operand = [&](const Json& v) {
        return literals ? operands.literal(v) : operands.unknown(v);
      };
      inputs[row.first] = operand(ops[i][1]);
      if (!row.second.empty()) inputs[row.second] = operand(ops[i][2]);
      blocks.push_back(block("data_addtolist", {{"ITEM", in(block(row.opcode, inputs, row.fields))}},
                             {{"LIST", named("R")}}));
    }
    Running run(program({hat(std::move(blocks))}, {}, {"R"}), {}, operands.catalog);
    run.finish();
    const std::vector<MonitorValue> got = run.machine->lists(kWholeMonitors).at("R");
    ASSERT_EQ(got.size(), to - from);
    for (std::size_t i = from; i < to; ++i) expect_same(got[i - from], ops[i][3], ops[i]);
  }
}

TEST(Golden, OperatorsOfUnknownOperandsGiveWhatScratchGives) { check_all(false); }
TEST(Golden, OperatorsOfLiteralsGiveWhatScratchGives) { check_all(true); }

}  // namespace
}  // namespace mirada::vm::test
