#include <cstdlib>
#include <filesystem>
#include <memory>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/units.h"
#include "calibrate_messages.h"
#include "commands.h"
#include "vision/calibration/camera_json.h"
#include "vision/calibration/judge.h"
#include "vision/calibration/picture_set.h"

namespace mirada {
namespace {

constexpr int kBadInput = 2;

struct CalibrateOptions {
  std::vector<std::string> files;
  std::string board = "9x6";
  std::string charuco;
  double square_mm = 25;
  double marker_mm = 0;
  std::string dictionary = "4x4";
  std::string model = "auto";
  std::string camera;
  std::string name;
  std::string out;
  bool json = false;
  std::string lang = "en";

  Lang language() const { return lang == "es" ? Lang::es : Lang::en; }
};

void append(Faults& faults, const Faults& more) { faults.insert(faults.end(), more.begin(), more.end()); }

nlohmann::ordered_json to_json(const Faults& faults, Lang lang) {
  auto out = nlohmann::ordered_json::array();
  for (const Fault& fault : faults) {
    out.push_back({{"place", fault.place}, {"code", fault.code()}, {"message", fault.text(lang)}});
  }
  return out;
}

void print_json(const nlohmann::ordered_json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

int refuse(const Faults& faults, const Faults& refused, const CalibrateOptions& options) {
  Faults all = refused;
  append(all, faults);
  if (options.json) {
    print_json({{"trusted", false},
                {"faults", to_json(faults, options.language())},
                {"refused", to_json(refused, options.language())}});
  }
  fmt::print(stderr, "{}\n", to_text(all, options.language()));
  return kBadInput;
}

struct Job {
  vision::BoardSpec board;
  std::optional<CameraPreset> preset;
};

Result<Job> read_job(const CalibrateOptions& options) {
  Job job;
  Faults faults;
  auto board = options.charuco.empty() ? vision::chessboard_spec(options.board, options.square_mm)
                                       : vision::charuco_spec(options.charuco, options.square_mm,
                                                              options.marker_mm, options.dictionary);
  if (board) {
    job.board = *board;
  } else {
    append(faults, board.faults());
  }
  if (!options.camera.empty()) {
    auto preset = camera_preset(options.camera);
    if (preset) {
      job.preset = std::move(*preset);
    } else {
      append(faults, preset.faults());
    }
  }
  if (!faults.empty()) return faults;
  return job;
}

/// The one camera among those we know that `calibration` may turn out to be.
std::vector<CameraPreset> known_cameras() {
  std::vector<CameraPreset> out;
  for (const std::string& id : shipped_cameras()) {
    if (auto preset = camera_preset(id)) out.push_back(std::move(*preset));
  }
  return out;
}

std::string summary(const vision::Calibration& c, std::size_t given, Lang lang) {
  const CameraModel& camera = c.camera;
  std::string out;
  for (const vision::SolvedView& view : c.views) {
    out += format(messages::calibrate_view,
                  {{"image", view.image},
                   {"rms", fmt::format("{:.3f}", view.rms_px)},
                   {"tilt", number_text(deg(view.tilt_rad), 0)}},
                  lang) +
           "\n";
  }
  out += format(messages::calibrate_lens,
                {{"lens", camera.lens == CameraModel::Lens::fisheye ? "fisheye" : "brown"},
                 {"fx", fmt::format("{:.2f}", camera.fx_px)},
                 {"fy", fmt::format("{:.2f}", camera.fy_px)},
                 {"cx", fmt::format("{:.2f}", camera.cx_px)},
                 {"cy", fmt::format("{:.2f}", camera.cy_px)},
                 {"sigma", fmt::format("{:.2f}", c.sigma_fx_px)}},
                lang) +
         "\n";
  out += format(messages::calibrate_view_angle,
                {{"hfov", number_text(deg(camera.hfov_rad()), 1)},
                 {"vfov", number_text(deg(camera.vfov_rad()), 1)},
                 {"seen", number_text(deg(c.seen_hfov_rad), 1)}},
                lang) +
         "\n";
  return out + format(messages::calibrate_result,
                      {{"rms", fmt::format("{:.4f}", c.rms_px)},
                       {"used", std::to_string(c.views.size())},
                       {"given", std::to_string(given)},
                       {"coverage", number_text(100 * c.coverage, 0)}},
                      lang);
}

/// The name that robot.json will compare with its own camera's.
std::string camera_name(const CalibrateOptions& options, const Job& job) {
  if (!options.name.empty()) return options.name;
  return job.preset ? job.preset->name_en : "";
}

int deliver(const vision::Calibration& calibration, const Job& job, const Faults& notes,
            const CalibrateOptions& options) {
  const Lang lang = options.language();
  const auto camera = camera_json(calibration, job.board, job.preset ? job.preset->id : "");
  if (!options.out.empty()) {
    const Status written = write_file_atomically(options.out, camera.dump(2) + "\n");
    if (!written) return refuse(written.faults(), notes, options);
  }
  if (options.json) {
    print_json({{"trusted", true}, {"camera", camera}, {"refused", to_json(notes, lang)}});
  } else {
    fmt::print("{}\n", summary(calibration, options.files.size(), lang));
    if (options.out.empty()) fmt::print("{}\n", format(messages::calibrate_not_kept, {}, lang));
  }
  if (!notes.empty()) fmt::print(stderr, "{}\n", to_text(notes, lang));
  return 0;
}

int calibrate(const CalibrateOptions& options) {
  const auto job = read_job(options);
  if (!job) return refuse(job.faults(), {}, options);
  const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
  const bool show = isatty(STDERR_FILENO) != 0;
  vision::PictureSet set = vision::read_pictures(files, job->board, [&](std::size_t done) {
    if (show) fmt::print(stderr, "\r{}/{} ", done, files.size());
  });
  if (show) fmt::print(stderr, "\r");
  const auto lens = options.model == "brown"     ? vision::LensChoice::brown
                    : options.model == "fisheye" ? vision::LensChoice::fisheye
                                                 : vision::LensChoice::automatic;
  auto calibration = vision::solve(std::move(set.views), lens);
  if (!calibration) return refuse(calibration.faults(), set.refused, options);
  calibration->camera.name = camera_name(options, *job);
  append(set.refused, calibration->refused);
  Faults faults = vision::distrust(*calibration);
  if (job->preset) append(faults, vision::check_datasheet(*calibration, *job->preset, known_cameras()));
  if (has_errors(faults)) {
    if (!options.json) fmt::print("{}\n", summary(*calibration, options.files.size(), options.language()));
    return refuse(faults, set.refused, options);
  }
  append(set.refused, faults);
  return deliver(*calibration, *job, set.refused, options);
}

void add_options(CLI::App& app, CalibrateOptions& options) {
  app.add_option("IMAGES", options.files, "Pictures of the board, 12 or more, all of one size")->required();
  app.add_option("--board", options.board, "Inner corners of the chessboard, columns x rows")
      ->capture_default_str();
  app.add_option("--charuco", options.charuco,
                 "SQUARES of a ChArUco board, columns x rows, instead of --board");
  app.add_option("--square-mm", options.square_mm, "Side of a square, measured")->capture_default_str();
  app.add_option("--marker-mm", options.marker_mm,
                 "Side of a ChArUco mark's black square (0: three fifths of a square)");
  app.add_option("--dictionary", options.dictionary, "The ChArUco board's marks: 4x4, 5x5, 6x6 or 36h11")
      ->capture_default_str();
  app.add_option("--model", options.model, "The lens: brown (5 numbers), fisheye (4), or auto")
      ->check(CLI::IsMember({"brown", "fisheye", "auto"}))
      ->capture_default_str();
  app.add_option("--camera", options.camera,
                 "Compare the field of view with this camera's datasheet: an id such as pi-camera-v2");
  app.add_option("--name", options.name,
                 "What the camera is called in camera.json (default: the datasheet's)");
  app.add_option("--out", options.out, "Write the calibration here (robot.json's \"calibration\")");
  app.add_flag("--json", options.json, "The report as JSON");
  app.add_option("--lang", options.lang, "en or es")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
}

}  // namespace

void add_calibrate(Commands& commands) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* app = commands.app.add_subcommand(
      "calibrate", "Measure a camera's lens from pictures of a chessboard or ChArUco board.");
  add_options(*app, *options);
  app->callback([options, &commands] { commands.exit_code = calibrate(*options); });
}

}  // namespace mirada
