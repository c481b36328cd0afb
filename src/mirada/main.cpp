#include <CLI/CLI.hpp>

#include "commands.h"

int main(int argc, char** argv) {
  CLI::App app{"Mirada: blocks that see. Each subcommand has its own --help."};
  app.require_subcommand(1);
  mirada::Commands commands{app};
  mirada::add_run(commands);
  mirada::add_see(commands);
  mirada::add_calibrate(commands);
  CLI11_PARSE(app, argc, argv);
  return commands.exit_code;
}
