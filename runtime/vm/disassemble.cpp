#include "vm/disassemble.h"

#include <fmt/format.h>

#include "vm/code.h"
#include "vm/digits.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

std::string register_text(const Code& code, std::int32_t operand) {
  if (operand >= 0) return fmt::format("r{}", operand);
  const auto place = static_cast<std::size_t>(~operand);
  for (const VariableInfo& variable : code.variables) {
    if (!variable.own && static_cast<std::size_t>(variable.place) == place) return "[" + variable.name + "]";
  }
  const GlobalInit& constant = code.globals[place];
  if (constant.is_text) return "\"" + constant.text + "\"";
  const std::string number = number_to_string(behind_digits(constant.number));
  return is_digits(constant.number) ? "\"" + number + "\"" : number;
}

std::string list_text(const Code& code, std::int32_t list) {
  if (list < 0) return fmt::format("own list {}", ~list);
  const auto i = static_cast<std::size_t>(list);
  return i < code.lists.size() ? "[" + code.lists[i].name + "]" : "[no list]";
}

std::string operand_text(const Code& code, char kind, std::int32_t operand, std::size_t at) {
  switch (kind) {
    case 'n':
    case 'N':
    case 'v':
    case 'V':
      return register_text(code, operand);
    case 'l':
      return list_text(code, operand);
    case 'j':
      return fmt::format("-> {}", static_cast<std::int64_t>(at) + operand);
    default:
      return std::to_string(operand);
  }
}

std::string instruction_text(const Code& code, const Function& function, std::size_t at) {
  const Instr& instr = function.code[at];
  const OpRow& row = row_of(instr.op);
  std::string operands;
  const char kinds[] = {row.a, row.b, row.c};
  const std::int32_t values[] = {instr.a, instr.b, instr.c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (kinds[i] != '_')
      operands += (operands.empty() ? "" : ", ") + operand_text(code, kinds[i], values[i], at);
  }
  const BlockIndex block = function.block_of[at];
  const std::string opcode = block == kNone ? "" : code.program.at(block).opcode;
  const std::string count = instr.executions > 0 ? fmt::format("+{}", instr.executions) : "";
  return fmt::format("{:5}  {:<14} {:<34} {:>4}  ; {}\n", at, row.name, operands, count, opcode);
}

}  // namespace

std::string disassemble(const LoadedProgram& program) {
  const Code& code = *program.code;
  std::string out;
  for (const VariableInfo& variable : code.variables) {
    const char* kind = variable.kind == Kind::number ? "bare number" : "value";
    out +=
        fmt::format("variable {}: {}{}\n", variable.name, kind, variable.own ? ", one for each clone" : "");
  }
  for (const ListInfo& list : code.lists) {
    out += fmt::format("list {}: {}\n", list.name, list.numbers ? "bare numbers" : "values");
  }
  for (const Function& function : code.functions) {
    out += fmt::format("\n{}: {} registers, {} parameters{}\n", function.name, function.frame_size,
                       function.params, function.warp ? ", all at once" : "");
    for (std::size_t at = 0; at < function.code.size(); ++at) out += instruction_text(code, function, at);
  }
  return out;
}

std::string instruction_table() {
  std::string out = "| instruction | a | b | c | meaning |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const OpRow& row = row_of(static_cast<Op>(i));
    const auto kind = [](char c) { return c == '_' ? std::string() : std::string(1, c); };
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.name, kind(row.a), kind(row.b), kind(row.c),
                       row.meaning);
  }
  return out;
}

}  // namespace mirada::vm
