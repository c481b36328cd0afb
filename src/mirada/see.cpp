#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "commands.h"
#include "model/robot_config.h"
#include "picture_source.h"
#include "see_messages.h"
#include "see_report.h"
#include "vision/face_finder.h"
#include "vision/faces/face_tracker.h"
#include "vision/identity/face_namer.h"
#include "vision/overlay.h"
#include "vision/visual_sonar.h"

namespace mirada {
namespace {

constexpr int kBadInput = 2;
constexpr Micros kFramePeriod = 40 * kMillisecond;  // of videos, whatever they say

struct SeeOptions {
  std::vector<std::string> files;
  std::string robot = "mirada-sim";
  double pan_deg = 0;
  double tilt_deg = 0;
  bool json = false;
  bool no_faces = false;
  bool lines_are_obstacles = false;
  std::string floor = "learnt";
  std::string overlay;
  std::string lang = "en";
  std::string face_model;
  std::string known_faces;
};

/// All that looking needs, opened and checked before the first picture is looked at.
struct SeeJob {
  RobotConfig robot;
  std::vector<PictureSource> sources;
  std::unique_ptr<vision::FaceFinder> faces;
  std::shared_ptr<vision::FaceBook> book;  ///< null: nobody is asked for
  Faults warnings;
};

void append(Faults& faults, const Faults& more) { faults.insert(faults.end(), more.begin(), more.end()); }

bool can_draw_to(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

Result<SeeJob> open_job(const SeeOptions& options) {
  SeeJob job;
  Faults faults;
  auto robot = robot_by_name(options.robot, &job.warnings);
  if (robot) {
    job.robot = std::move(*robot);
  } else {
    append(faults, robot.faults());
  }
  for (const std::string& file : options.files) {
    auto source = PictureSource::open(file, job.robot.camera);
    if (source) {
      job.sources.push_back(std::move(*source));
    } else if (robot || source.faults().front().message != &messages::see_wrong_shape) {
      append(faults, source.faults());
    }
  }
  if (!options.overlay.empty() && !can_draw_to(options.overlay)) {
    faults.push_back(make_fault("--overlay", messages::see_overlay_type, {{"file", options.overlay}}));
  }
  if (!options.no_faces && faults.empty()) {
    auto faces = vision::FaceFinder::open(job.robot, options.face_model);
    if (faces) {
      if (const auto& fallback = (*faces)->fallback()) job.warnings.push_back(*fallback);
      job.faces = std::move(*faces);
    } else {
      append(faults, faces.faults());
    }
  }
  if (!options.known_faces.empty()) {
    auto book = vision::FaceBook::copy_of(options.known_faces);
    if (book) {
      job.book = std::move(*book);
      if (const auto plain = vision::face_identity_fallback()) job.warnings.push_back(*plain);
    } else {
      append(faults, book.faults());
    }
  }
  if (!faults.empty()) return faults;
  return job;
}

/// OUT.png for one picture; OUT-0001.png and so on for more.
std::string overlay_name(const std::string& wanted, std::size_t number, bool many) {
  if (!many) return wanted;
  const std::filesystem::path path(wanted);
  return (path.parent_path() /
          fmt::format("{}-{:04}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

bool write_overlay(const std::string& file, const cv::Mat& bgr, const SeenPicture& seen) {
  cv::Mat drawn = bgr.clone();
  vision::draw_overlay(drawn, seen.sonar, seen.faces);
  try {
    return cv::imwrite(file, drawn);
  } catch (const cv::Exception&) {
    return false;
  }
}

int refuse(const Faults& faults, const SeeOptions& options) {
  if (options.json)
    fmt::print("{}\n", fault_report(faults).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  fmt::print(stderr, "{}\n", to_text(faults, *lang_from(options.lang)));
  return kBadInput;
}

int look_at_all(SeeJob& job, const SeeOptions& options) {
  vision::SonarSettings settings;
  settings.lines_are_obstacles = options.lines_are_obstacles;
  if (options.floor == "fixed-colour") settings.floor = vision::SonarSettings::Floor::fixed_colour;
  vision::VisualSonar sonar(job.robot, settings);
  const NeckAngles neck{rad(options.pan_deg), rad(options.tilt_deg)};
  const bool many = job.sources.size() > 1 || job.sources.front().is_video();
  Frame frame;
  vision::FaceTracker tracker(job.robot);
  std::optional<vision::FaceNamer> namer;
  if (job.book) namer.emplace(job.book);
  for (PictureSource& source : job.sources) {
    sonar.forget();
    tracker = vision::FaceTracker(job.robot);
    if (namer) namer->forget();
    for (int index = 0; !(frame.bgr = source.next()).empty(); ++index) {
      ++frame.number;
      frame.t_exposure = index * kFramePeriod;
      SeenPicture seen{source.file(),
                       source.is_video() ? index : -1,
                       frame.bgr.cols,
                       frame.bgr.rows,
                       job.robot.id,
                       {},
                       {}};
      seen.sonar = sonar.look(frame, neck, {});
      if (job.faces) {
        seen.faces = job.faces->find(frame, neck);
        tracker.follow(seen.faces, neck, {});
        if (namer && source.is_video()) namer->look(frame.bgr, seen.faces, true);
        if (namer && !source.is_video()) namer->name_at_once(frame.bgr, seen.faces);
      }
      const std::string text =
          options.json ? see_report(seen).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
                       : see_words(seen, *lang_from(options.lang));
      fmt::print("{}\n", text);
      if (options.overlay.empty()) continue;
      const std::string file = overlay_name(options.overlay, frame.number, many);
      if (!write_overlay(file, frame.bgr, seen)) {
        return refuse({make_fault("--overlay", messages::see_overlay_unwritten, {{"file", file}})}, options);
      }
    }
  }
  return 0;
}

int see(const SeeOptions& options) {
  auto job = open_job(options);
  if (!job) return refuse(job.faults(), options);
  if (!job->warnings.empty()) fmt::print(stderr, "{}\n", to_text(job->warnings, *lang_from(options.lang)));
  return look_at_all(*job, options);
}

}  // namespace

void add_see(Commands& commands) {
  auto options = std::make_shared<SeeOptions>();
  CLI::App* app = commands.app.add_subcommand(
      "see", "Look at pictures or videos as the robot would: obstacle distances and faces.");
  app->add_option("FILES", options->files,
                  "Pictures (PNG, JPEG ...) or videos (AVI, MP4 ...); a report per picture")
      ->required();
  app->add_option("--robot", options->robot, "Id of a shipped robot, or a robot.json file")
      ->capture_default_str();
  app->add_option("--pan", options->pan_deg,
                  "Where the neck pointed, in degrees, positive to the LEFT (as in robot.json)")
      ->check(number_between(-180.0, 180.0));
  app->add_option("--tilt", options->tilt_deg,
                  "The neck's tilt in degrees, positive DOWN; adds to the mount's tilt of robot.json")
      ->check(number_between(-90.0, 90.0));
  app->add_flag("--json", options->json,
                "Reports as JSON, one line a picture; bearings positive to the left");
  app->add_option("--overlay", options->overlay,
                  "Draw what was seen to this .png or .jpg (numbered when there are more)");
  app->add_flag("--no-faces", options->no_faces, "Do not look for faces");
  app->add_flag("--lines-are-obstacles", options->lines_are_obstacles, "A painted line ends the free floor");
  app->add_option("--model", options->face_model,
                  "A face network of your own (ONNX, in the shape of UltraFace); without it the one that "
                  "scripts/run fetched, else the plain way (Haar)");
  app->add_option("--known-faces", options->known_faces,
                  "File of known faces (see mirada faces): says who the faces are");
  app->add_option("--floor", options->floor,
                  "How the floor is told: learnt, or the paper's fixed-colour border")
      ->check(CLI::IsMember({"learnt", "fixed-colour"}))
      ->capture_default_str();
  app->add_option("--lang", options->lang, "en or es")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
  app->callback([options, &commands] { commands.exit_code = see(*options); });
}

}  // namespace mirada
