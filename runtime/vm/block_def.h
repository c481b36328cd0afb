#pragma once
#include <optional>
#include <string>
#include <vector>

#include "vm/native.h"

namespace mirada::vm {

enum class Shape { command, reporter, boolean, hat, cap, c_block };
enum class ArgType { number, angle, text, boolean, menu, variable, list, broadcast, key, statements };
enum class Implementation { core, native, blocks };

struct MenuOption {
  std::string value;
  std::string en;
  std::string es;
};

/// One argument of a block, as pack.json declares it.
struct ArgDef {
  std::string name;  ///< the input's or field's name in the workspace JSON
  ArgType type = ArgType::number;
  bool is_field = false;  ///< menus, variables, lists and keys that no reporter can be dropped on
  std::string unit;
  std::optional<double> min;
  std::optional<double> max;
  std::string default_value;
  std::vector<MenuOption> options;
};

/// One block of the catalog: what editor, validator, compiler and documentation know of it.
struct BlockDef {
  std::string opcode;
  std::string pack;
  Shape shape = Shape::command;
  std::string text_en;
  std::string text_es;
  std::vector<ArgDef> args;
  std::vector<std::string> needs;  ///< "sonar", "faces", "drive", "neck": devices and percepts
  Implementation implementation = Implementation::native;
  NativeFn native;       ///< empty unless implementation is native
  bool visible = false;  ///< its script takes no further turn in this tick (devices, percepts, say)
};

}  // namespace mirada::vm
