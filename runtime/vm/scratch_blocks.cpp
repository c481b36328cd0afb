#include "vm/scratch_blocks.h"

#include <initializer_list>

namespace mirada::vm {
namespace {

ArgDef text_input(const char* name) {
  ArgDef arg;
  arg.name = name;
  arg.type = ArgType::text;
  return arg;
}

}  // namespace

std::shared_ptr<const BlockCatalog> scratch_blocks() {
  auto catalog = std::make_shared<BlockCatalog>();
  const auto add = [&](const char* opcode, Shape shape, std::initializer_list<const char*> inputs) {
    BlockDef def;
    def.opcode = opcode;
    def.pack = "scratch";
    def.shape = shape;
    def.implementation = Implementation::core;
    for (const char* input : inputs) def.args.push_back(text_input(input));
    catalog->add(std::move(def));
  };
  for (const char* opcode : {"looks_say", "looks_think"}) add(opcode, Shape::command, {"MESSAGE"});
  for (const char* opcode : {"looks_sayforsecs", "looks_thinkforsecs"}) {
    add(opcode, Shape::command, {"MESSAGE", "SECS"});
  }
  add("control_start_as_clone", Shape::hat, {});
  add("control_create_clone_of", Shape::command, {"CLONE_OPTION"});
  add("control_delete_this_clone", Shape::cap, {});
  add("control_get_counter", Shape::reporter, {});
  for (const char* opcode : {"control_incr_counter", "control_clear_counter"})
    add(opcode, Shape::command, {});
  add("looks_gotofrontback", Shape::command, {});
  add("looks_goforwardbackwardlayers", Shape::command, {"NUM"});
  for (const char* opcode : {"data_showvariable", "data_hidevariable", "data_showlist", "data_hidelist"}) {
    add(opcode, Shape::command, {});
  }
  return catalog;
}

}  // namespace mirada::vm
