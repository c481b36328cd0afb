#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "commands.h"
#include "program_file.h"
#include "vm/disassemble.h"

namespace mirada {
namespace {

int disassemble(const std::string& path, bool table) {
  if (table) {
    std::cout << vm::instruction_table();
    return 0;
  }
  const ProgramFile file = load_program_file(path);
  if (!file.program) {
    std::cerr << to_text(file.program.faults(), Lang::en) << "\n";
    return 2;
  }
  std::cout << vm::disassemble(*file.program);
  return 0;
}

}  // namespace

void add_disasm(Commands& commands) {
  auto path = std::make_shared<std::string>();
  auto table = std::make_shared<bool>(false);
  CLI::App* sub =
      commands.app.add_subcommand("disasm", "Show the instructions that a program is compiled to.");
  CLI::Option* all = sub->add_flag("--table", *table, "The instruction set itself, as a Markdown table");
  sub->add_option("program", *path, "The program's file")->excludes(all);
  sub->require_option(1);
  sub->callback([path, table, &commands] { commands.exit_code = disassemble(*path, *table); });
}

}  // namespace mirada
