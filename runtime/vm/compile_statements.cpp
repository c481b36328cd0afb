#include <limits>

#include "vm/compiler.h"
#include "vm/literal.h"

namespace mirada::vm {

void Compiler::stack(BlockIndex first) {
  for (BlockIndex at = first; at != kNone; at = program_.at(at).next) {
    if (!program_.at(at).disabled) statement(at);
  }
}

void Compiler::statement(BlockIndex index) {
  const Block& block = program_.at(index);
  if (!block.def) return;
  const BlockIndex around = build_->block();
  build_->set_block(index);
  if (block.def->implementation == Implementation::native) {
    build_->executed(1);
    build_->free(native(block, false));
  } else if (!call(block) && !control_statement(block) && !data_statement(block) &&
             !scratch_statement(block)) {
    list_statement(block);
  }
  build_->set_block(around);
}

bool Compiler::control_statement(const Block& block) {
  const std::string& opcode = block.opcode;
  if (opcode == "control_repeat") return repeat(block), true;
  if (opcode == "control_repeat_until") return repeat_while(block, false), true;
  if (opcode == "control_while") return repeat_while(block, true), true;
  if (opcode == "control_forever") return forever(block), true;
  if (opcode == "control_if" || opcode == "control_if_else") return if_else(block), true;
  if (opcode == "control_for_each") return for_each(block), true;
  if (opcode == "data_for_each_item") return for_each_item(block), true;
  if (opcode == "control_wait_until") return wait_until(block), true;
  if (opcode == "control_all_at_once") return all_at_once(block), true;
  build_->executed(1);
  if (opcode == "control_stop") return stop(block), true;
  if (opcode == "event_broadcast") return broadcast(block, Op::broadcast), true;
  if (opcode == "event_broadcastandwait") return broadcast(block, Op::broadcast_wait), true;
  if (opcode == "procedures_return") return give_back(block), true;
  if (opcode == "control_wait") {
    const Operand seconds = number_input(block, "DURATION");
    build_->emit_end(Op::wait, seconds.reg);
    return build_->free(seconds), true;
  }
  if (opcode == "sensing_resettimer") return build_->emit(Op::reset_timer), true;
  return false;
}

/// Blocks that only imported projects have.
bool Compiler::scratch_statement(const Block& block) {
  const std::string& opcode = block.opcode;
  if (!program_.from_scratch) return false;
  if (opcode == "control_incr_counter") return build_->emit(Op::count_up), true;
  if (opcode == "control_clear_counter") return build_->emit(Op::clear_counter), true;
  if (opcode == "control_delete_this_clone") return build_->emit_end(Op::delete_clone), true;
  if (opcode == "control_create_clone_of") {
    const Operand name = value_input(block, "CLONE_OPTION");
    build_->emit(Op::clone, name.reg);
    return build_->free(name), true;
  }
  if (opcode == "looks_gotofrontback") return go_to_layer(block), true;
  if (opcode == "looks_goforwardbackwardlayers") return go_by_layers(block), true;
  if (!opcode.starts_with("looks_")) return false;
  const Operand text = value_input(block, "MESSAGE");
  build_->emit(Op::say, text.reg);
  build_->free(text);
  if (!opcode.ends_with("forsecs")) return true;
  const Operand seconds = number_input(block, "SECS");
  build_->emit_end(Op::wait, seconds.reg);
  build_->free(seconds);
  return build_->emit(Op::say, text_constant("")), true;
}

/// Sprites lie over each other even where nobody sees them: the topmost one's scripts start first.
void Compiler::go_to_layer(const Block& block) {
  const Field* where = block.field("FRONT_BACK");
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  build_->emit(Op::layer, number_constant(where && where->value == "front" ? kEnd : -kEnd));
}

void Compiler::go_by_layers(const Block& block) {
  const Field* where = block.field("FORWARD_BACKWARD");
  const Operand given = number_input(block, "NUM");
  build_->free(given);
  const bool up = where && where->value == "forward";
  const Operand layers =
      emit_to(Kind::number, type::number, up ? Op::add : Op::subtract, number_constant(0), given.reg);
  build_->emit(Op::layer, layers.reg);
  build_->free(layers);
}

void Compiler::mouth(const Block& block, std::string_view name) {
  ++depth_;
  if (const Input* input = block.input(name)) stack(input->block);
  --depth_;
}

/// The yield at the end of a loop's turn; in warp there is none.
void Compiler::end_of_turn(Label& check) { build_->jump(warp_ ? Op::jump : Op::loop, check); }

void Compiler::repeat(const Block& block) {
  const Operand times = number_input(block, "TIMES");
  build_->free(times);
  const Operand counter = emit_to(Kind::number, type::number, Op::round, times.reg);
  Label body;
  Label check;
  Label exit;
  build_->executed(1);
  if (warp_) {
    build_->jump(Op::repeat, exit, counter.reg);
    build_->bind(body);
    mouth(block, "SUBSTACK");
    build_->executed(1);
    build_->jump(Op::repeat_back, body, counter.reg);
  } else {
    build_->jump(Op::repeat, exit, counter.reg);
    build_->bind(body);
    mouth(block, "SUBSTACK");
    build_->executed(1);
    build_->jump(Op::loop, check);
    build_->bind(check);
    build_->jump(Op::repeat_back, body, counter.reg);
  }
  build_->bind(exit);
  build_->free(counter);
}

/// repeat until (wanted: false) and while (wanted: true). In warp the condition is looked at again at the end
/// of the turn, which saves a jump.
void Compiler::repeat_while(const Block& block, bool wanted) {
  Label check;
  Label body;
  Label exit;
  build_->bind(check);
  build_->executed(1);
  jump_when(block, "CONDITION", !wanted, exit);
  build_->bind(body);
  mouth(block, "SUBSTACK");
  if (warp_) {
    build_->executed(1);
    jump_when(block, "CONDITION", wanted, body);
  } else {
    build_->jump(Op::loop, check);
  }
  build_->bind(exit);
}

void Compiler::forever(const Block& block) {
  Label body;
  build_->executed(1);
  build_->bind(body);
  mouth(block, "SUBSTACK");
  build_->executed(1);
  end_of_turn(body);
}

void Compiler::if_else(const Block& block) {
  Label otherwise;
  Label end;
  build_->executed(1);
  jump_when(block, "CONDITION", false, otherwise);
  mouth(block, "SUBSTACK");
  const Input* second = block.opcode == "control_if_else" ? block.input("SUBSTACK2") : nullptr;
  if (second && second->block != kNone) {
    build_->jump(Op::jump, end);
    build_->bind(otherwise);
    mouth(block, "SUBSTACK2");
    build_->bind(end);
  } else {
    build_->bind(otherwise);
  }
}

void Compiler::for_each(const Block& block) {
  const Operand index = emit_to(Kind::number, type::number, Op::set, number_constant(0));
  Label check;
  Label exit;
  build_->bind(check);
  build_->executed(1);
  const Operand given = number_input(block, "VALUE");
  build_->free(given);
  const Operand limit = emit_to(Kind::number, type::number, Op::no_nan, given.reg);
  build_->free(limit);
  build_->jump(Op::jump_not_less, exit, index.reg, limit.reg);
  build_->emit(Op::add, index.reg, index.reg, number_constant(1));
  if (const Place* place = place_of(block, "VARIABLE")) {
    write(*place, {index.reg, Kind::number, type::number, false});
  }
  mouth(block, "SUBSTACK");
  end_of_turn(check);
  build_->bind(exit);
  build_->free(index);
}

void Compiler::for_each_item(const Block& block) {
  const Operand index = emit_to(Kind::number, type::number, Op::set, number_constant(0));
  const std::int32_t list = list_of(block);
  Label check;
  Label exit;
  build_->bind(check);
  build_->executed(1);
  const Operand length = emit_to(Kind::number, type::number, Op::list_length, list);
  build_->free(length);
  build_->jump(Op::jump_not_less, exit, index.reg, length.reg);
  build_->emit(Op::add, index.reg, index.reg, number_constant(1));
  if (const Place* place = place_of(block, "VARIABLE")) {
    const bool bare = list_is_bare(block);
    const Types types = types_.variable(types_.variable_of(block, "LIST"));
    const Operand item = emit_to(bare ? Kind::number : Kind::value, types,
                                 bare ? Op::list_get_n : Op::list_get_at, list, index.reg);
    write(*place, item);
    build_->free(item);
  }
  mouth(block, "SUBSTACK");
  end_of_turn(check);
  build_->bind(exit);
  build_->free(index);
}

void Compiler::wait_until(const Block& block) {
  Label check;
  Label done;
  build_->bind(check);
  build_->executed(1);
  jump_when(block, "CONDITION", true, done);
  build_->jump(Op::poll, check);
  build_->bind(done);
}

/// In an imported project the block only runs what it holds, as in Scratch.
void Compiler::all_at_once(const Block& block) {
  build_->executed(1);
  if (program_.from_scratch || warp_) return mouth(block, "SUBSTACK");
  build_->emit(Op::warp_on);
  warp_ = true;
  mouth(block, "SUBSTACK");
  warp_ = false;
  build_->emit_end(Op::warp_off);
}

void Compiler::stop(const Block& block) {
  const Field* option = block.field("STOP_OPTION");
  if (!option) return;
  if (option->value == "all") build_->emit_end(Op::stop_all);
  if (option->value == "this script") end_script();
  if (option->value.starts_with("other scripts")) build_->emit(Op::stop_others);
}

/// The end of a script, or of a my-block without a value: an empty text where a value is wanted.
void Compiler::end_script() {
  if (definition_ < 0) {
    build_->emit_end(Op::end);
    return;
  }
  const Types types = types_.returned(definition_);
  if (!types_.signature(definition_).returns || is_bare(types) || types == type::truth) {
    build_->emit_end(Op::ret);
  } else {
    build_->emit_end(Op::ret_v, text_constant(""));
  }
}

void Compiler::broadcast(const Block& block, Op op) {
  const Field* field = block.field("BROADCAST_INPUT");
  if (!field) {
    const Operand name = value_input(block, "BROADCAST_INPUT");
    build_->emit_end(op, name.reg);
    if (op == Op::broadcast_wait) build_->emit(Op::await);
    return build_->free(name);
  }
  std::string name = field->value;
  for (const Variable& variable : program_.variables) {
    if (variable.id == field->id) name = variable.name;
  }
  build_->emit_end(op, text_constant(name));
  if (op == Op::broadcast_wait) build_->emit(Op::await);
}

void Compiler::give_back(const Block& block) {
  if (definition_ < 0) return end_script();
  const Types types = types_.returned(definition_);
  const bool bare = is_bare(types) || types == type::truth;
  const Operand value = types == type::truth ? truth_input(block, "VALUE")
                        : bare               ? bare_input(block, "VALUE", types)
                                             : value_input(block, "VALUE");
  build_->emit_end(bare ? Op::ret_n : Op::ret_v, value.reg);
  build_->free(value);
}

bool Compiler::data_statement(const Block& block) {
  if (block.opcode == "data_setvariableto") return set_variable(block), true;
  if (block.opcode == "data_changevariableby") return change_variable(block), true;
  if (block.opcode == "data_scriptvariable") {
    if (const Place* place = place_of(block, "VARIABLE")) {
      write(*place, {number_constant(0), Kind::number, type::number, false});
    }
    return true;
  }
  return false;
}

void Compiler::set_variable(const Block& block) {
  const Place* place = place_of(block, "VARIABLE");
  if (!place) return;
  if (place->kind == Kind::value) {
    const Operand value = value_input(block, "VALUE");
    write(*place, value);
    return build_->free(value);
  }
  const Operand value = bare_input(block, "VALUE", place->types);
  write(*place, value);
  build_->free(value);
}

void Compiler::change_variable(const Block& block) {
  const Place* place = place_of(block, "VARIABLE");
  if (!place) return;
  Operand old;
  if (has_effects(content(block, "VALUE"))) {
    // The amount is worked out first, as Scratch does: it may change the variable itself.
    const Operand by = number_input(block, "VALUE");
    old = as_number(read(*place));
    build_->free(old);
    build_->free(by);
    const Operand sum = emit_to(Kind::number, type::number, Op::add, old.reg, by.reg);
    write(*place, sum);
    return build_->free(sum);
  }
  old = as_number(read(*place));
  const Operand by = number_input(block, "VALUE");
  build_->free(old);
  build_->free(by);
  const Operand sum = emit_to(Kind::number, type::number, Op::add, old.reg, by.reg);
  write(*place, sum);
  build_->free(sum);
}

bool Compiler::list_statement(const Block& block) {
  const std::string& opcode = block.opcode;
  const bool bare = list_is_bare(block);
  const Types types = bare ? types_.variable(types_.variable_of(block, "LIST")) : type::any;
  const std::int32_t list = list_of(block);
  if (opcode == "data_deletealloflist") return build_->emit(Op::list_clear, list), true;
  if (opcode == "data_addtolist") {
    const Operand item = bare ? bare_input(block, "ITEM", types) : value_input(block, "ITEM");
    build_->emit(bare ? Op::list_add_n : Op::list_add, list, item.reg);
    return build_->free(item), true;
  }
  const bool bare_index = is_bare(types_.of_input(block, "INDEX"));
  if (opcode == "data_replaceitemoflist" && bare && bare_index) {
    Operand index = number_input(block, "INDEX");
    if (has_effects(content(block, "ITEM"))) index = kept(index);
    const Operand item = bare_input(block, "ITEM", types);
    build_->emit(Op::list_set_n, list, index.reg, item.reg);
    build_->free(index);
    return build_->free(item), true;
  }
  if (opcode == "data_deleteoflist") {
    const Operand index = value_input(block, "INDEX");
    build_->emit(Op::list_delete, list, index.reg);
    return build_->free(index), true;
  }
  if (opcode != "data_replaceitemoflist" && opcode != "data_insertatlist") return false;
  Operand index = value_input(block, "INDEX");
  if (has_effects(content(block, "ITEM"))) index = kept(index);
  const Operand item = value_input(block, "ITEM");
  build_->emit(opcode == "data_insertatlist" ? Op::list_insert : Op::list_set, list, index.reg, item.reg);
  build_->free(index);
  return build_->free(item), true;
}

}  // namespace mirada::vm
