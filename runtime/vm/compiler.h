#pragma once
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "vm/code.h"
#include "vm/function_builder.h"
#include "vm/types.h"

namespace mirada::vm {

/// What the compiler adds to: the tables of a program, or those of one clicked reporter beside it.
struct CodeTables {
  std::vector<Function> functions;
  std::vector<GlobalInit> globals;
  std::vector<NativeSite> natives;
};

/// Turns scripts, my blocks and reporters into functions. One object compiles one program (compile_program)
/// or one reporter of it (compile_reporter).
class Compiler {
 public:
  Compiler(const Program& program, const std::vector<bool>& runs, CodeTables& tables);

  /// Everything that runs: fills the tables and gives the rest of the code.
  void compile_program(Code& code);
  /// One reporter of a compiled program, answering its value; the tables continue those of `code`.
  void compile_reporter(const Code& code, BlockIndex reporter, std::size_t globals, std::size_t natives);

 private:
  // compile_program.cpp
  void place_variables(Code& code);
  void place_scalar(Code& code, std::size_t variable);
  void place_list(Code& code, std::size_t variable);
  void add_script(Code& code, BlockIndex top);
  std::int32_t compile_script(BlockIndex top);
  std::int32_t compile_condition(BlockIndex hat);
  void compile_definition(int definition);
  void declare_locals(BlockIndex top);
  std::int32_t number_constant(double number);
  std::int32_t text_constant(const std::string& text);

  // compile_statements.cpp
  void stack(BlockIndex first);
  void statement(BlockIndex index);
  bool control_statement(const Block& block);
  bool scratch_statement(const Block& block);
  bool data_statement(const Block& block);
  bool list_statement(const Block& block);
  void go_to_layer(const Block& block);
  void go_by_layers(const Block& block);
  void mouth(const Block& block, std::string_view name);
  void end_of_turn(Label& check);
  void repeat(const Block& block);
  void repeat_while(const Block& block, bool wanted);
  void forever(const Block& block);
  void if_else(const Block& block);
  void for_each(const Block& block);
  void for_each_item(const Block& block);
  void wait_until(const Block& block);
  void all_at_once(const Block& block);
  void stop(const Block& block);
  void broadcast(const Block& block, Op op);
  void set_variable(const Block& block);
  void change_variable(const Block& block);
  void give_back(const Block& block);
  void end_script();

  // compile_calls.cpp
  bool call(const Block& block);
  Operand call_value(const Block& block);
  void pass_arguments(const Block& block, int definition);
  Operand argument(const Block& block, const Parameter& param, Types wanted);
  Operand native(const Block& block, bool wants_value);
  std::int32_t native_argument(const Block& block, const ArgDef& arg);

  // compile_expressions.cpp
  Operand expression(BlockIndex index);
  Operand input(const Block& block, std::string_view name);
  Operand bare_input(const Block& block, std::string_view name, Types wanted);
  Operand number_input(const Block& block, std::string_view name);
  Operand value_input(const Block& block, std::string_view name);
  Operand truth_input(const Block& block, std::string_view name);
  Operand as_number(Operand operand);
  Operand as_value(Operand operand);
  static Op box_of(const Operand& operand);
  Operand as_truth(Operand operand);
  Operand kept(Operand operand);  ///< copied when a later input could change it
  Operand literal(const Block& block);
  Operand reporter(const Block& block, BlockIndex index);
  Operand arithmetic(const Block& block, Op op, std::string_view a, std::string_view b);
  Operand comparison(const Block& block);
  Operand truth_operator(const Block& block, Op op);
  Operand text_operator(const Block& block);
  Operand variable(const Block& block);
  Operand argument_reporter(const Block& block, BlockIndex index);
  Operand list_reporter(const Block& block);
  Operand item_of_list(const Block& block);
  bool list_item_as_number(const Block& block, std::string_view name, Op op, Operand& out);
  Operand emit_to(Kind kind, Types types, Op op, std::int32_t b = 0, std::int32_t c = 0);
  void jump_when(const Block& block, std::string_view name, bool wanted, Label& to);
  bool jump_compare(BlockIndex condition, bool wanted, Label& to);
  bool two_numbers(const Block& block, Operand& a, Operand& b);

  // Places of variables and lists (compile_program.cpp)
  struct Place {
    std::int32_t reg = 0;
    Kind kind = Kind::number;
    Types types = type::number;
    bool own = false;
  };
  const Place* place_of(const Block& block, std::string_view field);
  Operand read(const Place& place);
  void write(const Place& place, const Operand& given);
  std::int32_t list_of(const Block& block);
  bool list_is_bare(const Block& block) const;
  BlockIndex content(const Block& block, std::string_view name) const;
  bool has_effects(BlockIndex index) const {
    return index != kNone && effects_[static_cast<std::size_t>(index)];
  }

  const Program& program_;
  TypeTable types_;
  CodeTables& tables_;
  std::size_t globals_before_ = 0;
  std::size_t natives_before_ = 0;
  std::vector<bool> effects_;              ///< by block: its value may take turns or change variables
  std::vector<Place> places_;              ///< by variable of the program
  std::vector<std::int32_t> list_places_;  ///< by variable of the program
  std::int32_t list_of_none_ = 0;          ///< for blocks that name no list; behind all others, shown nowhere
  std::unordered_map<std::string, std::int32_t> numbers_;
  std::unordered_map<std::string, std::int32_t> texts_;

  std::unordered_map<BlockIndex, std::vector<BlockIndex>> script_variables_;  ///< by top: what declares them

  // The function being compiled.
  FunctionBuilder* build_ = nullptr;
  int definition_ = -1;
  bool warp_ = false;
  int depth_ = 0;  ///< of C-blocks
  std::unordered_map<int, Place> locals_;
  std::vector<Place> params_;
};

}  // namespace mirada::vm
