#include "vm/validate.h"

#include <algorithm>
#include <map>

#include "vm/literal.h"
#include "vm/messages.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

bool is_head(const BlockDef& def) { return def.shape == Shape::hat; }
bool is_value(const BlockDef& def) { return def.shape == Shape::reporter || def.shape == Shape::boolean; }

bool is_key(const std::string& name) {
  static constexpr std::string_view kNamed[] = {"space",       "up arrow", "down arrow", "left arrow",
                                                "right arrow", "enter",    "any"};
  if (std::find(std::begin(kNamed), std::end(kNamed), name) != std::end(kNamed)) return true;
  return name.size() == 1 && name[0] > ' ' && name[0] <= '~';
}

std::string choices_of(const ArgDef& arg) {
  std::string out;
  for (const MenuOption& option : arg.options) out += (out.empty() ? "" : ", ") + option.value;
  return out;
}

class Validator {
 public:
  Validator(Program& program, const BlockCatalog& catalog, Validation& out)
      : program_(program), catalog_(catalog), out_(out) {}

  void run() {
    check_size();
    check_packs();
    check_variables();
    look_up();
    mark_what_runs();
    check_nesting();
    collect_definitions();
    for (std::size_t i = 0; i < program_.blocks.size(); ++i) check_block(static_cast<BlockIndex>(i));
  }

 private:
  /// An error where a script can reach the block, else a warning.
  void fault(const Block& block, const Message& message, MessageArgs args = {}) {
    const auto index = static_cast<std::size_t>(&block - program_.blocks.data());
    const Severity severity = out_.runs[index] ? Severity::error : Severity::warning;
    out_.faults.push_back(make_fault(block.id, message, std::move(args), severity));
  }
  void warn(const Block& block, const Message& message, MessageArgs args = {}) {
    out_.faults.push_back(make_fault(block.id, message, std::move(args), Severity::warning));
  }
  void check_size();
  void check_packs();
  void check_variables();
  void look_up();
  void mark_what_runs();
  void check_nesting();
  void collect_definitions();
  void check_block(BlockIndex index);
  void check_names(const Block& block, const BlockDef& def);
  void check_place(const Block& block, const BlockDef& def);
  void check_field(const Block& block, const ArgDef& arg);
  void check_named(const Block& block, const ArgDef& arg, const Field& field);
  void check_literal(const Block& block, const ArgDef& arg);
  void check_unknown_parts(const Block& block, const BlockDef& def);
  void check_signature(const Block& block);
  void check_parameter(const Block& block);
  void check_parameter_count(const Block& block, const Signature& signature);
  const Signature* definition_around(const Block& block) const;

  Program& program_;
  const BlockCatalog& catalog_;
  Validation& out_;
  std::map<std::string, VariableKind> variables_;
  std::map<std::string, const Signature*> definitions_;
  std::vector<BlockIndex> top_of_;
};

void Validator::check_size() {
  const std::size_t count = counted_blocks(program_);
  const std::size_t limit = program_.from_scratch ? limits::kScratchBlocks : limits::kBlocks;
  if (count <= limit) return;
  out_.faults.push_back(make_fault("", messages::too_many_blocks,
                                   {{"count", std::to_string(count)}, {"limit", std::to_string(limit)}}));
}

void Validator::check_packs() {
  std::set<std::string_view> known;
  for (const auto& [opcode, def] : catalog_.all()) known.insert(def.pack);
  for (std::size_t i = 0; i < program_.packs.size(); ++i) {
    if (known.contains(program_.packs[i])) continue;
    out_.faults.push_back(
        make_fault("/packs/" + std::to_string(i), messages::missing_pack, {{"pack", program_.packs[i]}}));
  }
}

void Validator::check_variables() {
  for (const Variable& variable : program_.variables) {
    if (variables_.emplace(variable.id, variable.kind).second) continue;
    out_.faults.push_back(make_fault(variable.id, messages::duplicate_variable, {{"id", variable.id}}));
  }
}

void Validator::look_up() {
  std::set<std::string> left_out;
  for (Block& block : program_.blocks) {
    block.def = catalog_.find(block.opcode);
    if (!program_.from_scratch) continue;
    // A robot's blocks may share a name with Scratch's and mean something else.
    if (!block.def || block.def->implementation != Implementation::core) {
      block.def = program_.scratch_blocks->find(block.opcode);
    }
    if (!block.def && !literal_field(block)) left_out.insert(block.opcode);
  }
  if (left_out.empty()) return;
  std::string list;
  for (const std::string& opcode : left_out) list += (list.empty() ? "" : ", ") + opcode;
  out_.faults.push_back(make_fault("", messages::stage_blocks, {{"blocks", list}}, Severity::warning));
}

/// Blocks stand after the block that holds them, so one pass from the front hands liveness and tops down.
void Validator::mark_what_runs() {
  const std::size_t count = program_.blocks.size();
  out_.runs.assign(count, false);
  top_of_.assign(count, kNone);
  std::vector<bool> chain_runs(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const Block& block = program_.blocks[i];
    const auto parent = static_cast<std::size_t>(block.parent);
    bool runs = false;
    if (block.parent == kNone) {
      runs = block.def != nullptr && is_head(*block.def);
      top_of_[i] = static_cast<BlockIndex>(i);
    } else {
      const bool follows = program_.blocks[parent].next == static_cast<BlockIndex>(i);
      runs = follows ? chain_runs[parent] : static_cast<bool>(out_.runs[parent]);
      top_of_[i] = top_of_[parent];
    }
    const bool switched_off_head = block.parent == kNone && block.disabled;
    chain_runs[i] = runs && !switched_off_head;
    out_.runs[i] = runs && !block.disabled;
    if (out_.runs[i] && block.def) out_.needs.insert(block.def->needs.begin(), block.def->needs.end());
  }
}

void Validator::check_nesting() {
  std::vector<int> depth(program_.blocks.size(), 0);
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    const Block& block = program_.blocks[i];
    if (block.enclosing == kNone) continue;
    const int around = depth[static_cast<std::size_t>(block.enclosing)];
    depth[i] = around + 1;
    // Named once, where the limit is passed, and whatever hangs inside is left alone.
    const bool counts = !literal_field(block);
    if (counts && depth[i] == limits::kNesting + 1 && program_.at(block.enclosing).enclosing != kNone) {
      out_.faults.push_back(
          make_fault(block.id, messages::nested_too_deep, {{"limit", std::to_string(limits::kNesting)}}));
    }
  }
}

void Validator::collect_definitions() {
  for (const Block& block : program_.blocks) {
    if (block.opcode != "procedures_definition" || block.signature < 0 || block.disabled) continue;
    const Signature& signature = program_.signatures[static_cast<std::size_t>(block.signature)];
    check_parameter_count(block, signature);
    if (!definitions_.emplace(signature.id, &signature).second && !program_.from_scratch) {
      fault(block, messages::two_definitions, {{"name", signature.name}});
    }
    std::set<std::string> names;
    for (const Parameter& param : signature.params) {
      if (!names.insert(param.name).second && !program_.from_scratch) {
        fault(block, messages::two_parameters, {{"name", param.name}});
      }
    }
  }
}

/// Whether the block runs or not: it is compiled.
void Validator::check_parameter_count(const Block& block, const Signature& signature) {
  if (signature.params.size() <= limits::kParameters) return;
  out_.faults.push_back(make_fault(block.id, messages::too_many_parameters,
                                   {{"name", signature.name},
                                    {"count", std::to_string(signature.params.size())},
                                    {"limit", std::to_string(limits::kParameters)}}));
}

void Validator::check_block(BlockIndex index) {
  const Block& block = program_.at(index);
  if (!block.def) {
    if (literal_field(block) || program_.from_scratch) return;
    return fault(block, messages::unknown_block, {{"opcode", block.opcode}});
  }
  const BlockDef& def = *block.def;
  if (program_.from_scratch) return check_names(block, def);
  check_place(block, def);
  for (const ArgDef& arg : def.args) {
    if (arg.is_field) {
      check_field(block, arg);
    } else {
      check_literal(block, arg);
    }
  }
  check_unknown_parts(block, def);
  if (block.signature >= 0) check_signature(block);
  if (block.opcode.starts_with("argument_reporter")) check_parameter(block);
  if (block.opcode == "procedures_return" && !definition_around(block))
    warn(block, messages::return_elsewhere);
}

/// Scratch takes what it finds, and its own rules say what happens then; but who names nothing is told so.
void Validator::check_names(const Block& block, const BlockDef& def) {
  for (const ArgDef& arg : def.args) {
    const bool names = arg.type == ArgType::list || arg.type == ArgType::variable;
    if (names && !block.field(arg.name)) warn(block, messages::field_absent, {{"field", arg.name}});
  }
}

void Validator::check_place(const Block& block, const BlockDef& def) {
  if (block.parent == kNone) return;
  const Block& parent = program_.at(block.parent);
  const auto index = static_cast<BlockIndex>(&block - program_.blocks.data());
  const bool follows = parent.next == index;
  if (is_head(def)) return fault(block, messages::hat_inside);
  bool wants_value = false;
  if (!follows) {
    wants_value = parent.signature >= 0;
    if (parent.def) {
      for (const ArgDef& arg : parent.def->args) {
        const Input* input = parent.input(arg.name);
        if (!input || (input->block != index && input->shadow != index)) continue;
        wants_value = arg.type != ArgType::statements;
      }
    }
  }
  if (follows && parent.def && parent.def->shape == Shape::cap) warn(block, messages::after_cap);
  if (follows && parent.def && is_value(*parent.def)) return;
  if (!parent.def && !follows) return;
  if (wants_value && !is_value(def)) fault(block, messages::not_a_value);
  if (!wants_value && is_value(def)) fault(block, messages::not_a_command);
}

void Validator::check_field(const Block& block, const ArgDef& arg) {
  const Field* field = block.field(arg.name);
  if (!field) {
    if (arg.type == ArgType::broadcast && block.input(arg.name)) return;
    return fault(block, messages::field_absent, {{"field", arg.name}});
  }
  switch (arg.type) {
    case ArgType::variable:
    case ArgType::list:
    case ArgType::broadcast:
      return check_named(block, arg, *field);
    case ArgType::key:
      if (!is_key(field->value)) {
        fault(
            block, messages::wrong_choice,
            {{"field", arg.name}, {"choices", "space, any, up arrow, a..z, 0..9"}, {"value", field->value}});
      }
      return;
    default:
      break;
  }
  const bool known = std::any_of(arg.options.begin(), arg.options.end(),
                                 [&](const MenuOption& option) { return option.value == field->value; });
  if (known || arg.options.empty()) return;
  fault(block, messages::wrong_choice,
        {{"field", arg.name}, {"choices", choices_of(arg)}, {"value", field->value}});
}

void Validator::check_named(const Block& block, const ArgDef& arg, const Field& field) {
  const VariableKind wanted = arg.type == ArgType::list        ? VariableKind::list
                              : arg.type == ArgType::broadcast ? VariableKind::message
                                                               : VariableKind::scalar;
  const auto it = variables_.find(field.id);
  if (it != variables_.end() && it->second == wanted) return;
  if (wanted == VariableKind::message && field.id.empty() && !field.value.empty()) return;
  const char* kind = wanted == VariableKind::list      ? "list"
                     : wanted == VariableKind::message ? "message"
                                                       : "variable";
  fault(block, messages::dangling_variable, {{"kind", kind}, {"id", field.id}});
}

void Validator::check_literal(const Block& block, const ArgDef& arg) {
  const Input* input = block.input(arg.name);
  if (!input || input->content() == kNone) return;
  if (arg.type != ArgType::number && arg.type != ArgType::angle) return;
  const Field* literal = literal_field(program_.at(input->content()));
  if (!literal) return;
  const double number = string_to_number(literal->value);
  if (number != number && literal->name == "NUM" && !program_.from_scratch) {
    return fault(block, messages::not_a_number, {{"field", arg.name}, {"value", literal->value}});
  }
  if (number != number) return;
  const double low = arg.min.value_or(number);
  const double high = arg.max.value_or(number);
  if (number >= low && number <= high) return;
  // The name is for those who read the code; the words stand on the block.
  const Message& words = !arg.max   ? messages::below_range
                         : !arg.min ? messages::above_range
                                    : messages::out_of_range;
  warn(block, words,
       {{"field", arg.name},
        {"value", literal->value},
        {"min", arg.min ? number_text(low) : ""},
        {"max", arg.max ? number_text(high) : ""}});
}

void Validator::check_unknown_parts(const Block& block, const BlockDef& def) {
  const auto known = [&](const std::string& name) {
    return std::any_of(def.args.begin(), def.args.end(), [&](const ArgDef& arg) { return arg.name == name; });
  };
  if (block.signature >= 0 || block.opcode.starts_with("argument_reporter")) return;
  for (const Input& input : block.inputs) {
    if (!known(input.name)) warn(block, messages::unknown_input, {{"field", input.name}});
  }
  for (const Field& field : block.fields) {
    if (!known(field.name)) warn(block, messages::unknown_field, {{"field", field.name}});
  }
}

void Validator::check_signature(const Block& block) {
  const Signature& said = program_.signatures[static_cast<std::size_t>(block.signature)];
  const auto it = definitions_.find(said.id);
  if (it == definitions_.end()) return warn(block, messages::no_definition, {{"name", said.name}});
  const Signature& real = *it->second;
  if (block.opcode == "procedures_call_value" && !real.returns) {
    fault(block, messages::gives_no_value, {{"name", real.name}});
  }
  for (const Input& input : block.inputs) {
    const bool named = std::any_of(real.params.begin(), real.params.end(),
                                   [&](const Parameter& param) { return param.id == input.name; });
    if (!named && !program_.from_scratch) warn(block, messages::unknown_input, {{"field", input.name}});
  }
}

const Signature* Validator::definition_around(const Block& block) const {
  const auto index = static_cast<std::size_t>(&block - program_.blocks.data());
  const Block& top = program_.at(top_of_[index]);
  if (top.opcode != "procedures_definition" || top.signature < 0) return nullptr;
  return &program_.signatures[static_cast<std::size_t>(top.signature)];
}

void Validator::check_parameter(const Block& block) {
  const Field* field = block.field("VALUE");
  if (!field) return;
  const Signature* around = definition_around(block);
  const bool known =
      around && std::any_of(around->params.begin(), around->params.end(),
                            [&](const Parameter& param) { return param.name == field->value; });
  if (!known) warn(block, messages::parameter_elsewhere, {{"name", field->value}});
}

}  // namespace

Validation validate(Program& program, const BlockCatalog& catalog) {
  Validation out;
  Validator(program, catalog, out).run();
  return out;
}

}  // namespace mirada::vm
