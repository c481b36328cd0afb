#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/clock.h"
#include "base/files.h"
#include "commands.h"
#include "rig/station_factory.h"
#include "server/join_code.h"
#include "server/server.h"

namespace mirada {
namespace {

constexpr int kBadInput = 2;

struct ServeOptions {
  std::string listen = "127.0.0.1";
  std::uint16_t port = 8080;
  std::string world, robot, camera, place;
  std::uint64_t seed = 1;
  std::string lang = "en";
  std::string ui;
  std::string face_model;
  std::string faces;
};

/// The signals that end the program, blocked in this thread and all that it starts, so that they can be
/// waited for.
sigset_t hold_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

int complain(const Faults& faults, Lang lang) {
  for (const Fault& fault : faults) std::fprintf(stderr, "%s\n", fault.text(lang).c_str());
  return kBadInput;
}

void warn(const Faults& faults, Lang lang) { std::fputs(to_text(faults, lang).c_str(), stderr); }

void announce(const server::Server& server, const server::ServerOptions& codes, Lang lang) {
  const bool es = lang == Lang::es;
  if (!codes.join_code.empty()) {
    std::printf(es ? "Para conducir hace falta el código %s\n" : "Driving needs the code %s\n",
                codes.join_code.c_str());
  }
  std::printf(es ? "Para permitir que aprenda caras, el código del profesor es %s\n"
                 : "To allow it to learn faces, the teacher's code is %s\n",
              codes.teacher_code.c_str());
  std::printf(es ? "Mirada está lista: %s\n" : "Mirada is ready: %s\n", server.url().c_str());
  std::fflush(stdout);
}

int serve(const ServeOptions& options) {
  const Lang lang = lang_from(options.lang).value_or(Lang::en);
  const sigset_t signals = hold_signals();
  const auto packs = rig::load_shipped_packs();
  warn(packs->faults, lang);
  auto station = rig::make_station({options.world, options.robot, options.seed, options.camera,
                                    options.face_model, lang, packs, options.place, options.faces});
  if (!station.ok()) return complain(station.faults(), lang);

  Faults example_faults;
  const auto examples = server::load_examples(data_folder("blocks"), *packs, example_faults);
  warn(example_faults, lang);
  server::ServerOptions to_serve;
  to_serve.address = options.listen;
  to_serve.port = options.port;
  to_serve.ui_folder = options.ui.empty() ? data_folder("ui/dist") : std::filesystem::path(options.ui);
  to_serve.lang = lang;
  if (!server::is_loopback_address(options.listen)) to_serve.join_code = server::make_join_code();
  to_serve.teacher_code = server::make_join_code();
  const SteadyClock clock;
  {
    const auto server = server::Server::open(to_serve, **station, *packs, examples, clock);
    if (!server.ok()) return complain(server.faults(), lang);
    announce(**server, to_serve, lang);
    int signal = 0;
    sigwait(&signals, &signal);
    (*station)->stop(session::StopReason::stop_button);
  }
  // A start that was on its way while the server closed must not outlive it.
  (*station)->stop(session::StopReason::stop_button);
  return 0;
}

}  // namespace

void add_serve(Commands& commands) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* command = commands.app.add_subcommand("serve", "Serves the editor and the robot to browsers.");
  command->add_option("--port", options->port, "Port to serve on (0 = any free one)")->capture_default_str();
  command
      ->add_option("--listen", options->listen,
                   "Address to serve on; another than this machine's own needs a code to drive")
      ->capture_default_str();
  command->add_option("--world", options->world, "Room: the id of one that ships, or a file");
  command->add_option("--robot", options->robot, "Robot: the id of one that ships, or a file");
  command->add_option(
      "--place", options->place,
      "What the robot knows of where it is: the id of a place that ships, or a place.json file");
  command->add_option("--seed", options->seed, "Seed of the room's chance")
      ->check(number_between(0, kLargestSeed))
      ->capture_default_str();
  command->add_option("--camera", options->camera,
                      "v4l2:0, or a picture or video file, instead of the simulated camera");
  command->add_option("--lang", options->lang, "First language")
      ->check(CLI::IsMember(std::vector<std::string>{"en", "es"}))
      ->capture_default_str();
  command->add_option("--model", options->face_model,
                      "A face network of your own (ONNX, in the shape of UltraFace); without it the one that "
                      "scripts/run fetched, else the plain way (Haar)");
  command->add_option("--known-faces", options->faces,
                      "File of the known faces; without it known.json in the user's own folder");
  command->add_option("--ui", options->ui, "Folder of the built editor");
  command->callback([&commands, options] { commands.exit_code = serve(*options); });
}

}  // namespace mirada
