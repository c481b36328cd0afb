#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "commands.h"
#include "mount_messages.h"
#include "vision/calibration/board_finder.h"
#include "vision/calibration/picture_set.h"
#include "vision/mount/floor_sight.h"
#include "vision/mount/mount_measure.h"
#include "vision/tags/tag_finder.h"

namespace mirada {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kBadInput = 2;
constexpr double kBoardCorner_px = 0.06;
constexpr double kTagCorner_px = 0.15;
constexpr double kSameShape = 0.01;

struct MountOptions {
  std::string image;
  std::string robot = "mirada-sim";
  std::string board;
  double square_mm = 25;
  double tag_mm = 0;
  int tag_id = -1;
  std::vector<std::string> lines;
  double thickness_mm = 0;
  double pan_deg = 0;
  double tilt_deg = 0;
  std::string out;
  bool check = false;
  bool json = false;
  std::string lang = "en";

  Lang language() const { return lang == "es" ? Lang::es : Lang::en; }
  NeckAngles neck() const { return {rad(pan_deg), rad(tilt_deg)}; }
};

void append(Faults& faults, const Faults& more) { faults.insert(faults.end(), more.begin(), more.end()); }

int refuse(const Faults& faults, const MountOptions& options) {
  if (options.json) {
    Json list = Json::array();
    for (const Fault& fault : faults) {
      list.push_back(
          {{"place", fault.place}, {"code", fault.code()}, {"message", fault.text(options.language())}});
    }
    fmt::print("{}\n", Json{{"faults", list}}.dump(2, ' ', false, Json::error_handler_t::replace));
  }
  fmt::print(stderr, "{}\n", to_text(faults, options.language()));
  return kBadInput;
}

/// Eight numbers "u1,v1,u2,v2=x1,y1,x2,y2".
std::optional<vision::KnownLine> read_line(std::string text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return std::nullopt;
  text[equals] = ',';
  double numbers[8];
  const char* at = text.data();
  const char* end = text.data() + text.size();
  for (int i = 0; i < 8; ++i) {
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !std::isfinite(numbers[i])) return std::nullopt;
    if (i < 7 ? next == end || *next != ',' : next != end) return std::nullopt;
    at = next + 1;
  }
  vision::KnownLine line;
  line.seen_px = {Eigen::Vector2d(numbers[0], numbers[1]), Eigen::Vector2d(numbers[2], numbers[3])};
  line.points_R_m = {Eigen::Vector2d(numbers[4], numbers[5]), Eigen::Vector2d(numbers[6], numbers[7])};
  return line;
}

struct Job {
  RobotConfig robot;
  CameraModel camera;  ///< of the picture's size
  cv::Mat gray;
  std::optional<vision::BoardSpec> board;
  std::vector<vision::KnownLine> lines;
};

void read_target(const MountOptions& options, Job& job, Faults& faults) {
  const int said = !options.board.empty() + (options.tag_mm != 0) + !options.lines.empty();
  if (said != 1) {
    faults.push_back(
        make_fault("mount", said == 0 ? messages::mount_says_nothing : messages::mount_says_twice));
  }
  if (!options.board.empty()) {
    auto board = vision::chessboard_spec(options.board, options.square_mm);
    if (board) {
      job.board = *board;
    } else {
      append(faults, board.faults());
    }
  }
  if (options.tag_mm != 0 && !(options.tag_mm >= 5 && options.tag_mm <= 1000)) {
    faults.push_back(
        make_fault("--tag-mm", messages::mount_tag_size, {{"value", number_text(options.tag_mm)}}));
  }
  for (const std::string& text : options.lines) {
    const auto line = read_line(text);
    if (line) {
      job.lines.push_back(*line);
    } else {
      faults.push_back(make_fault("--line", messages::mount_line_text, {{"value", text}}));
    }
  }
}

Result<Job> read_job(const MountOptions& options) {
  Job job;
  Faults faults;
  read_target(options, job, faults);
  auto robot = robot_by_name(options.robot);
  if (robot) {
    job.robot = std::move(*robot);
  } else {
    append(faults, robot.faults());
  }
  auto gray = vision::read_gray(options.image);
  if (gray) {
    job.gray = std::move(*gray);
  } else {
    append(faults, gray.faults());
  }
  if (!robot || !gray) return faults;
  const CameraModel& camera = job.robot.camera;
  const double shape =
      static_cast<double>(job.gray.cols) * camera.height_px / job.gray.rows / camera.width_px;
  if (std::abs(shape - 1) > kSameShape) {
    faults.push_back(make_fault(options.image, messages::mount_picture_shape,
                                {{"value", fmt::format("{}x{}", job.gray.cols, job.gray.rows)},
                                 {"wanted", fmt::format("{}x{}", camera.width_px, camera.height_px)}}));
  }
  if (!faults.empty()) return faults;
  job.camera = camera.scaled_to(job.gray.cols, job.gray.rows);
  return job;
}

Result<vision::FloorSight> sight_of_board(const Job& job, const MountOptions& options) {
  auto view = vision::BoardFinder(*job.board).find(job.gray, options.image);
  if (!view) return view.faults();
  std::vector<Eigen::Vector2d> points_m;
  for (const cv::Point3f& p : view->corners_B_m) points_m.emplace_back(p.x, p.y);
  return vision::sight_from_points(job.camera, {view->corners_px.begin(), view->corners_px.end()}, points_m,
                                   options.thickness_mm * 1e-3, kBoardCorner_px);
}

Result<vision::TagSighting> the_tag(const Job& job, const MountOptions& options) {
  std::string seen;
  std::vector<vision::TagSighting> fitting;
  for (const vision::TagSighting& tag : vision::TagFinder().find(job.gray)) {
    seen += (seen.empty() ? "" : ", ") + std::to_string(tag.id);
    if (options.tag_id < 0 || tag.id == options.tag_id) fitting.push_back(tag);
  }
  if (fitting.size() == 1) return fitting.front();
  if (!fitting.empty()) return make_fault(options.image, messages::mount_many_tags, {{"seen", seen}});
  const std::string which = options.tag_id < 0 ? "" : "(" + std::to_string(options.tag_id) + ") ";
  return make_fault(options.image, messages::mount_no_tag, {{"which", which}});
}

Result<vision::FloorSight> sight_of_tag(const Job& job, const MountOptions& options) {
  const auto tag = the_tag(job, options);
  if (!tag) return tag.faults();
  const double h = options.tag_mm * 0.5e-3;
  return vision::sight_from_points(job.camera, {tag->corners_px.begin(), tag->corners_px.end()},
                                   {{-h, h}, {h, h}, {h, -h}, {-h, -h}}, options.thickness_mm * 1e-3,
                                   kTagCorner_px);
}

Result<vision::FloorSight> measure(const Job& job, const MountOptions& options) {
  if (job.board) return sight_of_board(job, options);
  if (!job.lines.empty()) return vision::sight_from_lines(job.robot, job.camera, options.neck(), job.lines);
  return sight_of_tag(job, options);
}

double rounded(double value, int digits) {
  const double by = std::pow(10, digits);
  return std::round(value * by) / by;
}

/// The "mount" of robot.json.
Json mount_json(const MountConfig& mount, double axis_height_m) {
  Json out;
  out["forward_m"] = rounded(mount.p_TM_m.x(), 5);
  if (mount.p_TM_m.y() != 0) out["left_m"] = rounded(mount.p_TM_m.y(), 5);
  out["height_m"] = rounded(mount.p_TM_m.z() + axis_height_m, 5);
  out["tilt_deg"] = rounded(deg(mount.tilt_rad), 3);
  if (mount.yaw_rad != 0) out["yaw_deg"] = rounded(deg(mount.yaw_rad), 3);
  out["roll_deg"] = rounded(deg(mount.roll_rad), 3);
  out["sigma_tilt_deg"] = rounded(deg(mount.sigma_tilt_rad), 3);
  out["sigma_height_m"] = rounded(mount.sigma_height_m, 5);
  out["sigma_pan_deg"] = rounded(deg(mount.sigma_pan_rad), 3);
  return out;
}

/// Into a robot's file that is there already, else as a file of its own.
Status keep(const std::string& file, const Json& mount, const Json& measured) {
  Json whole;
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    auto text = read_file(file);
    if (!text) return text.faults();
    whole = Json::parse(*text, nullptr, false);
  }
  if (whole.is_object() && whole.value("format", "") == "mirada-robot") {
    whole["mount"] = mount;
  } else {
    whole = {{"format", "mirada-mount"}, {"version", 1}, {"mount", mount}, {"measured", measured}};
  }
  return write_file_atomically(file, whole.dump(2) + "\n");
}

Json measured_json(const vision::FloorSight& sight, const MountOptions& options) {
  return {{"image", options.image},
          {"from", !options.board.empty()  ? "board"
                   : options.lines.empty() ? "tag"
                                           : "lines"},
          {"height_m", rounded(sight.height_m, 5)},
          {"tilt_deg", rounded(deg(sight.tilt_rad), 3)},
          {"roll_deg", rounded(deg(sight.roll_rad), 3)},
          {"sigma_height_m", rounded(sight.sigma_height_m, 5)},
          {"sigma_tilt_deg", rounded(deg(sight.sigma_tilt_rad), 3)},
          {"rms_px", rounded(sight.rms_px, 3)}};
}

std::string words(const vision::FloorSight& sight, Lang lang) {
  return format(messages::mount_result,
                {{"height", number_text(100 * sight.height_m, 2)},
                 {"sigma_height", number_text(1000 * sight.sigma_height_m, 1)},
                 {"tilt", number_text(deg(sight.tilt_rad), 2)},
                 {"sigma_tilt", number_text(deg(sight.sigma_tilt_rad), 2)},
                 {"roll", number_text(deg(sight.roll_rad), 2)},
                 {"rms", number_text(sight.rms_px, 2)}},
                lang);
}

int check(const Job& job, const vision::FloorSight& sight, const MountOptions& options) {
  const vision::MountCheck found = vision::check_mount(job.robot, options.neck(), sight);
  const bool fine = found.verdict == vision::MountCheck::Verdict::fine;
  if (options.json) {
    const bool knocked = found.verdict == vision::MountCheck::Verdict::knocked;
    const Json out = {{"verdict", fine      ? "fine"
                                  : knocked ? "knocked"
                                            : "cannot_tell"},
                      {"height_off_m", rounded(found.height_off_m, 4)},
                      {"tilt_off_deg", rounded(deg(found.tilt_off_rad), 2)},
                      {"roll_off_deg", rounded(deg(found.roll_off_rad), 2)},
                      {"measured", measured_json(sight, options)}};
    fmt::print("{}\n", out.dump(2));
  } else {
    fmt::print("{}\n", words(sight, options.language()));
    if (fine) fmt::print("{}\n", format(messages::mount_as_told, {}, options.language()));
  }
  if (!found.words.empty()) fmt::print(stderr, "{}\n", to_text(found.words, options.language()));
  return fine ? 0 : 1;
}

int mount(const MountOptions& options) {
  const auto job = read_job(options);
  if (!job) return refuse(job.faults(), options);
  const auto sight = measure(*job, options);
  if (!sight) return refuse(sight.faults(), options);
  if (options.check) return check(*job, *sight, options);
  if (const Faults faults = vision::doubt(*sight, job->robot, options.neck()); !faults.empty()) {
    return refuse(faults, options);
  }
  const MountConfig found = vision::measured_mount(job->robot, options.neck(), *sight);
  const Json snippet = mount_json(found, job->robot.neck.p_PT_m.z());
  const Json measured = measured_json(*sight, options);
  if (!options.out.empty()) {
    const Status kept = keep(options.out, snippet, measured);
    if (!kept) return refuse(kept.faults(), options);
  }
  if (options.json) {
    fmt::print("{}\n", Json{{"mount", snippet}, {"measured", measured}}.dump(2));
    return 0;
  }
  const Lang lang = options.language();
  fmt::print("{}\n", words(*sight, lang));
  if (options.out.empty()) {
    fmt::print("{}\n\"mount\": {}\n", format(messages::mount_not_kept, {}, lang), snippet.dump());
  } else {
    fmt::print("{}\n", format(messages::mount_kept, {{"file", options.out}}, lang));
  }
  return 0;
}

void add_options(CLI::App& app, MountOptions& options) {
  app.add_option("IMAGE", options.image, "A picture by the robot's camera of something known on the floor")
      ->required();
  app.add_option("--robot", options.robot, "Id of a shipped robot, or a robot.json file")
      ->capture_default_str();
  app.add_option("--board", options.board, "A chessboard on the floor: inner corners, columns x rows");
  app.add_option("--square-mm", options.square_mm, "Side of its squares, measured")->capture_default_str();
  app.add_option("--tag-mm", options.tag_mm,
                 "An AprilTag 36h11 on the floor: side of its black square, measured");
  app.add_option("--tag-id", options.tag_id, "Which tag, when there are more");
  app.add_option(
      "--line", options.lines,
      "A line on the floor, twice or more: u1,v1,u2,v2=x1,y1,x2,y2 (pixels=metres, x ahead, y left)");
  app.add_option("--thickness-mm", options.thickness_mm, "How thick the board or tag is")
      ->check(number_between(0.0, 100.0));
  app.add_option("--pan", options.pan_deg, "Where the neck pointed, degrees, positive to the LEFT")
      ->check(number_between(-180.0, 180.0));
  app.add_option("--tilt", options.tilt_deg, "The neck's tilt, degrees, positive DOWN")
      ->check(number_between(-90.0, 90.0));
  app.add_option("--out", options.out, "Put the mount into this robot.json, or write a mount.json");
  app.add_flag("--check", options.check,
               "Only say whether the camera still stands as the robot's file says (exit 1: no)");
  app.add_flag("--json", options.json, "The answer as JSON");
  app.add_option("--lang", options.lang, "en or es")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
}

}  // namespace

void add_mount(Commands& commands) {
  auto options = std::make_shared<MountOptions>();
  CLI::App* app = commands.app.add_subcommand(
      "mount",
      "Measure how high the camera is and how far it looks down, from something known on the floor.");
  add_options(*app, *options);
  app->callback([options, &commands] { commands.exit_code = mount(*options); });
}

}  // namespace mirada
