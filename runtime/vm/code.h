#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vm/ast.h"

namespace mirada::vm {

enum class Op : std::uint16_t {
#define OP(name, a, b, c, meaning) name,
#define HOT OP
#include "vm/opcodes.def"
#undef HOT
#undef OP
  op_count
};
constexpr std::size_t kOpCount = static_cast<std::size_t>(Op::op_count);

/// One row of opcodes.def.
struct OpRow {
  const char* name;
  char a, b, c;
  bool hot;
  const char* meaning;
};
const OpRow& row_of(Op op);

struct Instr;
struct Turn;
union Slot;
/// Executes one instruction; gives the next one, or null when the script's turn is over.
using Handler = const Instr* (*)(const Instr* at, Slot* frame, Slot* globals, Turn& turn);

/// One instruction. An operand that is a register: 0.. in the frame, -1, -2, .. globals 0, 1, ..; a jump is
/// relative.
struct Instr {
  Handler run = nullptr;
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t c = 0;
  std::uint16_t executions = 0;  ///< blocks of the straight piece that ends here
  Op op = Op::end;
};

constexpr std::int32_t global_operand(std::size_t index) { return ~static_cast<std::int32_t>(index); }
/// The handler for an instruction, chosen by where its operands are. vm/interpreter.cpp.
Handler handler_of(const Instr& instr);

enum class Kind : std::uint8_t { number, value };

/// The compiled form of one script, my block, hat condition or clicked reporter.
struct Function {
  std::vector<Instr> code{};
  std::vector<BlockIndex> block_of{};        ///< by instruction, for faults and highlights
  std::vector<std::uint16_t> value_slots{};  ///< frame registers that hold values (counted texts)
  std::uint32_t frame_size = 0;
  std::uint32_t reserve = 0;  ///< registers from the frame's start, arguments for callees included
  std::uint32_t params = 0;
  std::string name{};
  bool warp = false;
  std::int32_t sprite = 0;
};

enum class HatKind : std::uint8_t { flag, key, message, edge, clone };
struct Script {
  HatKind kind = HatKind::flag;
  BlockIndex hat = kNone;
  std::int32_t function = -1;
  std::int32_t condition = -1;  ///< of an edge hat: the function that answers its truth
  std::int32_t sprite = 0;
  std::string name{};         ///< key, or message in lower case
  bool from_outside = false;  ///< an edge hat on a percept or device
};

/// What a global register holds when the program is loaded.
struct GlobalInit {
  Kind kind = Kind::number;
  bool is_text = false;
  double number = 0;
  std::string text{};
  bool is_truth = false;
};

/// How a variable is kept: numbers bare; texts that are canonical numbers too, and known to be texts.
struct VariableInfo {
  std::string name{};      ///< a sprite's own as "Sprite.name"
  std::int32_t place = 0;  ///< a global register's index, or the place among a cloned sprite's own
  Kind kind = Kind::number;
  bool digits = false;  ///< bare numbers that are shown as texts
  bool own = false;     ///< lives in each clone
  bool shown = true;    ///< not script-local
  std::int32_t sprite = 0;
};
struct ListInfo {
  std::string name{};
  bool numbers = false;
  bool digits = false;
  bool mixed = false;  ///< numbers and texts of digits, bare: vm/digits.h
  bool own = false;
  std::int32_t sprite = 0;
  std::vector<GlobalInit> initial{};
};

/// One place where a native block is called.
struct NativeSite {
  const BlockDef* def = nullptr;
  BlockIndex block = kNone;
  std::vector<std::int32_t> args{};  ///< value registers, in pack.json's order
  bool wants_value = false;
};

/// What every clone of a sprite has of its own.
struct OwnVariable {
  Kind kind = Kind::number;
  GlobalInit initial{};
};
struct OwnParts {
  std::vector<OwnVariable> variables{};
  std::vector<std::int32_t> lists{};  ///< indices of Code::lists
};

/// A program ready to run: immutable, shared between threads.
struct Code {
  Program program;
  std::vector<bool> runs{};  ///< by block: a script can reach it
  std::vector<Function> functions{};
  std::vector<Script> scripts{};  ///< in the order in which they start
  std::vector<GlobalInit> globals{};
  std::vector<VariableInfo> variables{};
  std::vector<ListInfo> lists{};
  std::vector<NativeSite> natives{};
  std::vector<OwnParts> own{};  ///< by sprite
  const BlockCatalog* catalog = nullptr;
};

}  // namespace mirada::vm
