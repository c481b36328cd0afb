#pragma once
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

namespace mirada {

/// Each adds one subcommand to the program; its callback sets `exit_code`. One source file a subcommand.
struct Commands {
  CLI::App& app;
  int exit_code = 0;
};

/// Of an option's text: a number from `least` to `most`, so not NaN either, which CLI11's own Range lets
/// through.
CLI::Validator number_between(double least, double most);
/// As far as every whole number has its own double.
inline constexpr double kLargestSeed = 9e15;

void add_run(Commands& commands);
void add_check(Commands& commands);
void add_disasm(Commands& commands);
void add_serve(Commands& commands);
void add_see(Commands& commands);
void add_calibrate(Commands& commands);
void add_mount(Commands& commands);
void add_faces(Commands& commands);
void add_lab(Commands& commands);

}  // namespace mirada
