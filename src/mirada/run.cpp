#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "commands.h"
#include "rig/lockstep.h"
#include "rig/place_choice.h"
#include "vision/face_finder.h"

namespace mirada {
namespace {

constexpr std::uintmax_t kMostProgramBytes = 64u << 20;
constexpr double kLongest_s = 86'400;

std::atomic<bool> stop_asked{false};

struct RunArguments {
  std::string program;
  std::string world = "sala-1";
  std::string robot = "mirada-sim";
  std::string place;
  std::uint64_t seed = 1;
  double seconds = 60;
  std::string report;
  std::string lang = "en";
  std::string face_model;
  std::string faces;

  Lang language() const { return lang == "es" ? Lang::es : Lang::en; }
};

/// World and robot as asked for; every fault of both.
Result<rig::LockstepOptions> read_options(const RunArguments& arguments) {
  rig::LockstepOptions options;
  options.seed = arguments.seed;
  options.seconds = arguments.seconds;
  options.stop_asked = [] { return stop_asked.load(); };
  options.face_model = arguments.face_model;
  Faults faults;
  if (const auto model = vision::check_face_model(arguments.face_model); !model) faults = model.faults();
  if (!arguments.faces.empty()) {
    auto book = vision::FaceBook::copy_of(arguments.faces);
    if (book) {
      options.book = std::move(*book);
    } else {
      faults.insert(faults.end(), book.faults().begin(), book.faults().end());
    }
  }
  if (arguments.world != "none") {
    auto world = world::world_by_name(arguments.world);
    if (world) {
      options.world = std::move(*world);
    } else {
      faults.insert(faults.end(), world.faults().begin(), world.faults().end());
    }
  }
  auto robot = robot_by_name(arguments.robot);
  if (!robot) faults.insert(faults.end(), robot.faults().begin(), robot.faults().end());
  auto place = rig::choose_place(arguments.place);
  if (!place) faults.insert(faults.end(), place.faults().begin(), place.faults().end());
  if (!faults.empty()) return faults;
  options.robot = std::move(*robot);
  options.robot.place = std::move(*place);
  return options;
}

/// What somebody at a terminal wants to know.
std::string summary(const session::RunReport& report, const std::string& program, Lang lang) {
  std::string out;
  const std::string whole = report.status == session::RunStatus::invalid ? program + ": " : "";
  for (const vm::BlockFault& fault : report.faults) {
    out += (fault.block.empty() ? whole : fault.block + ": ") + fault.fault.text(lang) + "\n";
  }
  out += std::string(to_string(report.status)) + ", " + number_text(report.simulated_s, 2) + " s";
  if (report.robot) {
    out += ", " + number_text(report.robot->path_m, 2) + " m, contacts " +
           std::to_string(report.robot->contacts);
  }
  return out + "\n";
}

/// 0 = ran, 2 = invalid input (or a report that could not be written).
int deliver(const session::RunReport& report, const RunArguments& arguments) {
  const Lang lang = arguments.language();
  const bool invalid = report.status == session::RunStatus::invalid;
  if (arguments.report != "-") (invalid ? std::cerr : std::cout) << summary(report, arguments.program, lang);
  if (arguments.report.empty()) return invalid ? 2 : 0;
  const std::string text =
      to_json(report, lang).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (arguments.report == "-") {
    std::cout << text << std::flush;
  } else if (const Status written = write_file_atomically(arguments.report, text); !written) {
    std::cerr << to_text(written.faults(), lang);
    return 2;
  }
  return invalid ? 2 : 0;
}

int run(const RunArguments& arguments) {
  const auto program = read_file(arguments.program, kMostProgramBytes);
  auto options = read_options(arguments);
  Faults faults;
  if (!program) faults = program.faults();
  if (!options) faults.insert(faults.end(), options.faults().begin(), options.faults().end());
  if (!faults.empty()) return deliver(session::invalid_report(faults), arguments);
  std::signal(SIGINT, [](int) { stop_asked.store(true); });
  std::signal(SIGTERM, [](int) { stop_asked.store(true); });
  return deliver(rig::run_lockstep(*program, *options), arguments);
}

}  // namespace

void add_run(Commands& commands) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* sub = commands.app.add_subcommand("run",
                                              "Run a program without a browser, in simulated time, as fast "
                                              "as it goes. Exit 0: it ran; 2: invalid input.");
  sub->add_option("program", arguments->program, "The program's file")->required();
  sub->add_option("--world", arguments->world, "A room: id or file; none = no room, no pictures")
      ->capture_default_str();
  sub->add_option("--robot", arguments->robot, "A robot: id or file")->capture_default_str();
  sub->add_option("--place", arguments->place,
                  "What the robot knows of where it is: the id of a place that ships, or a place.json file");
  sub->add_option("--model", arguments->face_model,
                  "A face network of your own (ONNX, in the shape of UltraFace); without it the one that "
                  "scripts/run fetched, else the plain way (Haar)");
  sub->add_option("--known-faces", arguments->faces,
                  "File of known faces (see mirada faces): they may be recognised, and what the program "
                  "learns is known until it ends. Without it nobody is known and nobody can be learnt");
  sub->add_option("--seed", arguments->seed, "The same seed, the same run")
      ->check(number_between(0, kLargestSeed))
      ->capture_default_str();
  sub->add_option("--seconds", arguments->seconds, "Longest run, in simulated seconds")
      ->check(number_between(0.001, kLongest_s))
      ->capture_default_str();
  sub->add_option("--report", arguments->report, "Write the run report here as JSON; - = to the terminal");
  sub->add_option("--lang", arguments->lang, "Language of the words")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
  sub->callback([arguments, &commands] { commands.exit_code = run(*arguments); });
}

}  // namespace mirada
