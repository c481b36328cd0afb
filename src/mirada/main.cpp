#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "base/message.h"
#include "commands.h"

namespace mirada {

CLI::Validator number_between(double least, double most) {
  const std::string range = "[" + number_text(least, 6) + " - " + number_text(most, 6) + "]";
  const auto check = [least, most, range](const std::string& text) -> std::string {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    const bool whole = !text.empty() && end == text.c_str() + text.size();
    return whole && number >= least && number <= most ? "" : text + " is not a number in " + range;
  };
  return {check, "in " + range, "number"};
}

}  // namespace mirada

namespace {

constexpr int kBadInput = 2;

/// What was meant for a subcommand and is none, if anything.
std::string unknown_first_word(const CLI::App& app, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.empty() || word == "-h" || word == "--help") return "";
  const auto named = app.get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
  return named.empty() ? word : "";
}

int refuse(const CLI::App& app, const std::string& word) {
  std::cerr << "mirada: there is no \"" << word << "\". Choose from:";
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    std::cerr << " " << sub->get_name();
  std::cerr << " (mirada --help tells what they do).\n";
  return kBadInput;
}

}  // namespace

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
  if (const std::string word = unknown_first_word(app, argc, argv); !word.empty()) return refuse(app, word);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& wrong) {
    return app.exit(wrong) == 0 ? 0 : kBadInput;
  }
  return commands.exit_code;
}
