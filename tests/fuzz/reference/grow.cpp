// Random valid programs. Only what is the same whenever it runs: no clock, no chance.
#include <array>

#include "fuzz/reference/tree.h"

namespace mirada::vm::reference {
namespace {

constexpr std::array kTexts = {"",         " ",         "0",    "1",     "-1",   "abc", "ABC",
                               "5",        "05",        "1e3",  "0x10",  "b",    "NaN", "true",
                               "Infinity", "-Infinity", "last", "false", " 12 ", ".5",  "5.",
                               "2.5",      "1.0",       "-0",   "all",   "1,0",  "x y", "7"};
constexpr std::array kNumbers = {0.0, 1.0,  -1.0, 2.0,  3.0,  2.5,          -2.5,
                                 0.1, 10.0, 1e21, 1e-7, -0.0, 4294967296.0, 1e308};
constexpr std::array kTwoNumbers = {"operator_add", "operator_subtract", "operator_multiply",
                                    "operator_divide", "operator_mod"};
constexpr std::array kComparisons = {"operator_lt", "operator_gt", "operator_equals"};
constexpr std::array kFunctions = {"abs", "floor", "ceiling", "sqrt"};

class Grower {
 public:
  Grower(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  Tree tree() {
    Tree out;
    const int blocks = pick(4);
    for (int i = 0; i < blocks; ++i) {
      MyBlock block;
      const int params = pick(4);
      for (int p = 0; p < params; ++p) block.params += "ntb"[pick(3)];
      block.returns = pick(2) == 0;
      block.warp = block.returns || pick(2) == 0;  // a reporter that yields would have to stop half-way
      definition_ = &block;
      block.body = statements(3, 4);
      if (block.returns && pick(4) > 0) {
        block.body.push_back({.opcode = "procedures_return", .inputs = {value(3)}});
      }
      definition_ = nullptr;
      blocks_.push_back(block);
    }
    out.blocks = blocks_;
    const int scripts = 1 + pick(3);
    for (int i = 0; i < scripts; ++i) out.scripts.push_back({-1, statements(4, 6)});
    in_receiver_ = true;
    const int receivers = pick(3);
    for (int i = 0; i < receivers; ++i) out.scripts.push_back({pick(kMessages), statements(3, 3)});
    return out;
  }

 private:
  int pick(int below) { return (at_ < size_ ? data_[at_++] : 0) % below; }
  template <class Table>
  auto one_of(const Table& table) {
    return table[static_cast<std::size_t>(pick(static_cast<int>(table.size())))];
  }

  Node literal() {
    if (pick(2) == 0) return {.opcode = "text", .text = one_of(kTexts)};
    return {.opcode = "number", .number = one_of(kNumbers)};
  }

  Node value(int depth) {
    if (depth <= 0 || --budget_ < 0) return pick(2) ? literal() : variable();
    const int d = depth - 1;
    switch (pick(14)) {
      case 0:
      case 1:
        return literal();
      case 2:
        return variable();
      case 3:
        return parameter();
      case 4:
        return {.opcode = one_of(kTwoNumbers), .inputs = two(d)};
      case 5:
        return truth(d);
      case 6:
        return {.opcode = "operator_join", .inputs = two(d)};
      case 7:
        return {.opcode = "operator_letter_of", .inputs = two(d)};
      case 8:
        return {.opcode = pick(2) ? "operator_length" : "operator_round", .inputs = {value(d)}};
      case 9:
        return {.opcode = "operator_mathop", .text = one_of(kFunctions), .inputs = {value(d)}};
      case 10:
        return {.opcode = "data_itemoflist", .name = pick(kLists), .inputs = {value(d)}};
      case 11:
        return {.opcode = "data_itemnumoflist", .name = pick(kLists), .inputs = {value(d)}};
      case 12:
        return {.opcode = pick(3) ? "data_lengthoflist" : "data_listcontents", .name = pick(kLists)};
      default:
        return call("procedures_call_value", d);
    }
  }

  Node truth(int depth) {
    if (depth <= 0 || --budget_ < 0) return {.opcode = "operator_not", .inputs = {literal()}};
    const int d = depth - 1;
    switch (pick(6)) {
      case 0:
        return {.opcode = "operator_not", .inputs = {truth(d)}};
      case 1:
        return {.opcode = pick(2) ? "operator_and" : "operator_or", .inputs = {truth(d), truth(d)}};
      case 2:
        return {.opcode = "operator_contains", .inputs = two(d)};
      case 3:
        return {.opcode = "data_listcontainsitem", .name = pick(kLists), .inputs = {value(d)}};
      default:
        return {.opcode = one_of(kComparisons), .inputs = two(d)};
    }
  }

  std::vector<Node> two(int depth) {
    std::vector<Node> out;
    out.push_back(value(depth));
    out.push_back(value(depth));
    return out;
  }
  Node variable() { return {.opcode = "data_variable", .name = pick(kVariables)}; }
  Node parameter() {
    if (!definition_ || definition_->params.empty()) return variable();
    return {.opcode = "param", .name = pick(static_cast<int>(definition_->params.size()))};
  }

  /// Only blocks that are whole already are called, so nothing calls itself.
  Node call(const char* opcode, int depth) {
    const bool wants_value = std::string(opcode) == "procedures_call_value";
    if (blocks_.empty()) return wants_value ? literal() : set(depth);
    const int which = pick(static_cast<int>(blocks_.size()));
    const MyBlock& block = blocks_[static_cast<std::size_t>(which)];
    if (wants_value && !block.returns) return literal();
    Node out{.opcode = opcode, .name = which};
    for (std::size_t i = 0; i < block.params.size(); ++i) out.inputs.push_back(value(depth));
    return out;
  }

  Node set(int depth) {
    return {.opcode = "data_setvariableto", .name = pick(kVariables), .inputs = {value(depth)}};
  }

  std::vector<Node> statements(int depth, int most) {
    std::vector<Node> out;
    const int count = 1 + pick(most);
    for (int i = 0; i < count && budget_ > 0; ++i) out.push_back(statement(depth));
    return out;
  }

  Node loop(int depth) {
    const int d = depth - 1;
    if (depth <= 0) return set(1);
    switch (pick(5)) {
      case 0:
        return {.opcode = "control_for_each",
                .name = pick(kVariables),
                .inputs = {small()},
                .first = statements(d, 3)};
      case 1:
        return {.opcode = "data_for_each_item",
                .text = std::to_string(pick(kLists)),
                .name = pick(kVariables),
                .first = statements(d, 3)};
      case 2:
        return {.opcode = pick(2) ? "control_repeat_until" : "control_while",
                .inputs = {truth(2)},
                .first = statements(d, 3)};
      case 3:
        return {.opcode = "control_all_at_once", .first = statements(d, 3)};
      default:
        return {.opcode = "control_repeat", .inputs = {small()}, .first = statements(d, 3)};
    }
  }
  Node small() {
    return pick(4) ? Node{.opcode = "number", .number = static_cast<double>(pick(5))} : value(2);
  }

  Node statement(int depth) {
    --budget_;
    switch (pick(13)) {
      case 0:
      case 1:
        return set(3);
      case 2:
        return {.opcode = "data_changevariableby", .name = pick(kVariables), .inputs = {value(2)}};
      case 3:
      case 4:
        return {.opcode = "data_addtolist", .name = pick(kLists), .inputs = {value(3)}};
      case 5:
        return {.opcode = "data_deleteoflist", .name = pick(kLists), .inputs = {value(1)}};
      case 6:
        return {.opcode = pick(2) ? "data_insertatlist" : "data_replaceitemoflist",
                .name = pick(kLists),
                .inputs = two(2)};
      case 7:
        return loop(depth);
      case 8:
        if (depth <= 0) return set(2);
        return {.opcode = "control_if", .inputs = {truth(3)}, .first = statements(depth - 1, 3)};
      case 9:
        if (depth <= 0) return set(2);
        return {.opcode = "control_if_else",
                .inputs = {truth(3)},
                .first = statements(depth - 1, 2),
                .second = statements(depth - 1, 2)};
      case 10:
        return call("procedures_call", 2);
      case 11:
        // What receivers send would never end.
        if (in_receiver_ || definition_) return set(2);
        return {.opcode = pick(2) ? "event_broadcast" : "event_broadcastandwait", .name = pick(kMessages)};
      default:
        return pick(4) ? loop(depth)
                       : Node{.opcode = pick(2) ? "control_stop" : "data_deletealloflist", .name = 0};
    }
  }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
  int budget_ = 160;
  bool in_receiver_ = false;
  const MyBlock* definition_ = nullptr;
  std::vector<MyBlock> blocks_;
};

}  // namespace

Tree grow(const std::uint8_t* data, std::size_t size) { return Grower(data, size).tree(); }

}  // namespace mirada::vm::reference
