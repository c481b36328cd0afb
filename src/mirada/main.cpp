#include <CLI/CLI.hpp>

#include "commands.h"

namespace {
constexpr int kBadInput = 2;
}

int main(int argc, char** argv) {
  CLI::App app{"Mirada: blocks that see. Each subcommand has its own --help."};
  app.require_subcommand(1);
  mirada::Commands commands{app};
  mirada::add_run(commands);
  mirada::add_check(commands);
  mirada::add_disasm(commands);
  mirada::add_serve(commands);
  mirada::add_see(commands);
  mirada::add_calibrate(commands);
  mirada::add_mount(commands);
  mirada::add_faces(commands);
  mirada::add_lab(commands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& wrong) {
    return app.exit(wrong) == 0 ? 0 : kBadInput;
  }
  return commands.exit_code;
}
