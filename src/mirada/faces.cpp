#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "commands.h"
#include "faces_messages.h"
#include "model/robot_config.h"
#include "picture_source.h"
#include "rig/own_folder.h"
#include "vision/face_finder.h"
#include "vision/identity/face_book.h"

namespace mirada {
namespace {

constexpr int kBadInput = 2;

struct FacesOptions {
  std::string file;
  std::string name, to;
  std::vector<std::string> pictures;
  std::string allow;
  std::string lang = "en";

  Lang language() const { return *lang_from(lang); }
};

int finish(const Status& done, const FacesOptions& options) {
  if (done) return 0;
  fmt::print(stderr, "{}\n", to_text(done.faults(), options.language()));
  return kBadInput;
}

int list_people(const vision::FaceBook& book, const FacesOptions& options) {
  const Lang lang = options.language();
  fmt::print("{}\n", format(book.allowed() ? messages::faces_are_on : messages::faces_are_off, {}, lang));
  for (const vision::FaceBook::Person& person : book.people())
    fmt::print("{}\n", format(messages::faces_person,
                              {{"name", person.name}, {"looks", std::to_string(person.looks)}}, lang));
  return 0;
}

/// The feature of the largest face in a picture.
Result<vision::FaceFeature> largest_face(const std::string& file, vision::FaceFinder& finder,
                                         vision::FaceDescriber& describer, const RobotConfig& robot) {
  auto source = PictureSource::open(file, robot.camera);
  if (!source) return source.faults();
  Frame frame;
  frame.bgr = source->next();
  frame.number = 1;
  const FacesPercept seen = finder.find(frame, {});
  if (seen.faces.empty()) return make_fault(file, messages::faces_none_in_picture, {{"file", file}});
  const FacePercept& face = seen.faces.front();
  auto feature = describer.describe(frame.bgr, {face.x_px, face.y_px, face.w_px, face.h_px});
  if (!feature) return make_fault(file, messages::faces_none_in_picture, {{"file", file}});
  return std::move(*feature);
}

Status learn_pictures(vision::FaceBook& book, const FacesOptions& options) {
  const RobotConfig robot = *robot_by_name("mirada-sim");
  auto finder = vision::FaceFinder::open(robot);
  if (!finder) return finder.faults();
  vision::FaceDescriber describer = vision::FaceDescriber::open();
  std::vector<vision::FaceFeature> looks;
  Faults faults;
  for (const std::string& file : options.pictures) {
    auto feature = largest_face(file, **finder, describer, robot);
    if (feature)
      looks.push_back(std::move(*feature));
    else
      faults.insert(faults.end(), feature.faults().begin(), feature.faults().end());
  }
  if (!faults.empty()) return faults;
  return book.learn(options.name, describer.kind(), looks);
}

/// A subcommand of `mirada faces` that works on the opened book.
void add_action(CLI::App& faces, Commands& commands, const std::shared_ptr<FacesOptions>& options,
                const std::string& name, const std::string& help,
                const std::function<void(CLI::App&)>& arguments,
                const std::function<int(vision::FaceBook&)>& act) {
  CLI::App* action = faces.add_subcommand(name, help);
  arguments(*action);
  action->fallthrough();  // --file and --lang may stand behind it too
  action->callback([&commands, options, act] {
    const auto file = options->file.empty() ? rig::known_faces_file() : std::filesystem::path(options->file);
    auto book = vision::FaceBook::open(file);
    commands.exit_code = book ? act(**book) : finish(book.faults(), *options);
  });
}

}  // namespace

void add_faces(Commands& commands) {
  auto options = std::make_shared<FacesOptions>();
  CLI::App* faces = commands.app.add_subcommand(
      "faces",
      "The faces that were learnt: list, learn from pictures, rename, forget, allow. A mirada serve "
      "that runs on the same file notices.");
  faces->require_subcommand(1);
  faces->add_option("--file", options->file, "The file; without it known.json in the user's own folder");
  faces->add_option("--lang", options->lang, "en or es")->check(CLI::IsMember({"en", "es"}));
  const auto name = [options](CLI::App& action) {
    action.add_option("NAME", options->name, "Somebody's name")->required();
  };
  const auto nothing = [](CLI::App&) {};
  add_action(*faces, commands, options, "list", "Who is known", nothing,
             [options](vision::FaceBook& book) { return list_people(book, *options); });
  add_action(
      *faces, commands, options, "learn", "Learn somebody from pictures; the largest face in each",
      [options, name](CLI::App& action) {
        name(action);
        action.add_option("PICTURES", options->pictures, "Picture files")->required();
      },
      [options](vision::FaceBook& book) { return finish(learn_pictures(book, *options), *options); });
  add_action(
      *faces, commands, options, "rename", "Give somebody another name",
      [options, name](CLI::App& action) {
        name(action);
        action.add_option("TO", options->to, "The new name")->required();
      },
      [options](vision::FaceBook& book) {
        return finish(book.rename(options->name, options->to), *options);
      });
  add_action(*faces, commands, options, "forget", "Forget somebody", name,
             [options](vision::FaceBook& book) { return finish(book.forget(options->name), *options); });
  add_action(*faces, commands, options, "forget-all", "Forget everybody", nothing,
             [options](vision::FaceBook& book) { return finish(book.forget_all(), *options); });
  add_action(
      *faces, commands, options, "allow", "Allow that faces are learnt and recognised, or not",
      [options](CLI::App& action) {
        action.add_option("ON", options->allow, "on or off")->required()->check(CLI::IsMember({"on", "off"}));
      },
      [options](vision::FaceBook& book) { return finish(book.allow(options->allow == "on"), *options); });
}

}  // namespace mirada
