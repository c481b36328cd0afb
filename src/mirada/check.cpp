#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "commands.h"
#include "program_file.h"
#include "vm/machine.h"

namespace mirada {
namespace {

struct CheckArguments {
  std::string program;
  std::string lang = "en";
  bool json = false;
};

nlohmann::json fault_json(const Fault& fault) {
  return {{"place", fault.place},
          {"code", fault.code()},
          {"severity", fault.severity == Severity::error ? "error" : "warning"},
          {"message", {{"en", fault.text(Lang::en)}, {"es", fault.text(Lang::es)}}}};
}

/// Exit 0: it can run (warnings are listed); 2: it cannot.
int check(const CheckArguments& arguments) {
  const Lang lang = arguments.lang == "es" ? Lang::es : Lang::en;
  const ProgramFile file = load_program_file(arguments.program);
  const bool ok = file.program.ok();
  const Faults& faults = ok ? file.program->warnings : file.program.faults();
  if (arguments.json) {
    nlohmann::json out{{"ok", ok}, {"faults", nlohmann::json::array()}};
    for (const Fault& fault : faults) out["faults"].push_back(fault_json(fault));
    std::cout << out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  } else if (!faults.empty()) {
    (ok ? std::cout : std::cerr) << to_text(faults, lang) << "\n";
  }
  return ok ? 0 : 2;
}

}  // namespace

void add_check(Commands& commands) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* sub = commands.app.add_subcommand(
      "check", "Say everything that is wrong with a program. Exit 0: it can run; 2: it cannot.");
  sub->add_option("program", arguments->program, "The program's file (.json, or a Scratch project)")
      ->required();
  sub->add_flag("--json", arguments->json, "All faults as JSON, in both languages");
  sub->add_option("--lang", arguments->lang, "Language of the words")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
  sub->callback([arguments, &commands] { commands.exit_code = check(*arguments); });
}

}  // namespace mirada
