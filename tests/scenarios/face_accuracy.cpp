// Faces in composites and in the simulated room, with known truth: recall, precision, distance and cost as
// one JSON object. The heads are those of Debian's opencv-doc that show one from the front.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/clock.h"
#include "base/random.h"
#include "vision/faces/face_place.h"
#include "vision/faces/face_watch.h"
#include "vision/faces/haar_faces.h"
#include "world/render/renderer.h"

namespace {

using namespace mirada;
using nlohmann::json;

const std::string kPhotographs = "/usr/share/doc/opencv-doc/examples/data/";
const char* const kBackgrounds[] = {"aero1.jpg",  "aloeL.jpg",        "building.jpg",     "home.jpg",
                                    "fruits.jpg", "leuvenA.jpg",      "stuff.jpg",        "board.jpg",
                                    "left01.jpg", "apple.jpg",        "sudoku.png",       "box_in_scene.png",
                                    "cards.png",  "blox.jpg",         "HappyFish.jpg",    "butterfly.jpg",
                                    "aero3.jpg",  "rubberwhale1.png", "starry_night.jpg", "graf1.png"};

using Find = std::function<std::vector<vision::FaceBox>(const cv::Mat&)>;

struct Head {
  cv::Mat bgr;
  cv::Rect2d face;
};

std::vector<Head> heads() {
  const cv::Mat a = cv::imread(kPhotographs + "messi5.jpg");
  const cv::Mat b = cv::imread(kPhotographs + "basketball1.png");
  if (a.empty() || b.empty()) return {};
  return {{a(cv::Rect(195, 65, 95, 95)), {31, 27, 31, 40}}, {b(cv::Rect(50, 70, 75, 90)), {21, 22, 34, 42}}};
}

double overlap(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double both = (a & b).area();
  return both / (a.area() + b.area() - both);
}

struct Tally {
  int faces = 0, hits = 0, wrong = 0;
  void look(const std::vector<vision::FaceBox>& found, const cv::Rect2d& truth) {
    ++faces;
    bool hit = false;
    for (const vision::FaceBox& box : found) {
      if (!hit && overlap(box.box_px, truth) > 0.4) {
        hit = true;
      } else {
        ++wrong;
      }
    }
    hits += hit;
  }
  json row(const std::string& what, const std::string& detector) const {
    return {{"what", what}, {"detector", detector}, {"faces", faces}, {"hits", hits}, {"false", wrong}};
  }
};

/// A head in a photograph without faces; the light falls by `light`, with the noise of a cheap camera.
Tally composites(const Find& find, double from_px, double to_px, double light, int count, Random& random,
                 const std::function<void(const cv::Rect2d&)>& told = {}) {
  Tally tally;
  const std::vector<Head> all = heads();
  for (int i = 0; i < count; ++i) {
    const Head& head = all[static_cast<std::size_t>(i) % all.size()];
    cv::Mat scene = cv::imread(kPhotographs + kBackgrounds[static_cast<std::size_t>(random.integer(0, 19))]);
    cv::resize(scene, scene, {320, 240}, 0, 0, cv::INTER_AREA);
    const double scale = random.uniform(from_px, to_px) / head.face.width;
    cv::Mat small;
    cv::resize(head.bgr, small, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    cv::Rect2d face(head.face.x * scale, head.face.y * scale, head.face.width * scale,
                    head.face.height * scale);
    if (random.uniform() < 0.5) {
      cv::flip(small, small, 1);
      face.x = small.cols - face.x - face.width;
    }
    const cv::Point at(static_cast<int>(random.integer(0, 319 - small.cols)),
                       static_cast<int>(random.integer(0, 239 - small.rows)));
    small.copyTo(scene(cv::Rect(at, small.size())));
    scene.forEach<cv::Vec3b>([&](cv::Vec3b& p, const int*) { p = cv::Vec3b(cv::Vec3d(p) * light); });
    cv::Mat noise(scene.size(), CV_16SC3);
    cv::theRNG().state = static_cast<std::uint64_t>(i) + 1;
    cv::randn(noise, 0, 3);
    cv::add(scene, noise, scene, {}, CV_8U);
    face.x += at.x;
    face.y += at.y;
    tally.look(find(scene), face);
    if (told) told(face);
  }
  return tally;
}

struct Painted {
  cv::Mat bgr;
  double away_m = 0;
};

/// Somebody of the simulated room, straight ahead at the lens's height.
cv::Mat painted(double away_m, double turned_rad, const world::PersonConfig& person, const RobotConfig& robot,
                std::uint64_t seed) {
  world::WorldConfig room = *world::world_by_name("sala-1");
  room.people = {person};
  world::Renderer renderer(room, robot.camera, seed);
  Eigen::Isometry3d X_WC = robot.X_RC({0, -robot.mount.tilt_rad});
  X_WC.translation() = Eigen::Vector3d(room.X_WR_start.x_m, room.X_WR_start.y_m, person.height_m - 0.12);
  const Pose2 X_WP{room.X_WR_start.x_m + away_m, room.X_WR_start.y_m, M_PI + turned_rad};
  return renderer.render(X_WC, {X_WP}, static_cast<Micros>(seed));
}

json turned_heads(const Find& find, const std::string& detector, const RobotConfig& robot) {
  json out = json::array();
  for (const double turned_deg : {0.0, 20.0, 40.0, 60.0}) {
    int faces = 0, hits = 0;
    Random random(5, "turned");
    for (int i = 0; i < 24; ++i) {
      world::PersonConfig person;
      person.height_m = random.uniform(1.0, 1.7);
      const double side = i % 2 == 0 ? 1 : -1;
      const cv::Mat bgr = painted(random.uniform(0.7, 1.6), side * rad(turned_deg), person, robot,
                                  static_cast<std::uint64_t>(i));
      ++faces;
      for (const vision::FaceBox& box : find(bgr)) {
        if (box.box_px.contains({160, 120})) {
          ++hits;
          break;
        }
      }
    }
    out.push_back({{"turned_deg", turned_deg}, {"detector", detector}, {"faces", faces}, {"hits", hits}});
  }
  return out;
}

json distances(const Find& find, const RobotConfig& robot) {
  json out = json::array();
  Random random(6, "distances");
  for (const double away_m : {0.5, 0.75, 1.0, 1.5, 2.0, 2.5}) {
    std::vector<double> errors;
    for (int i = 0; i < 12; ++i) {
      world::PersonConfig person;
      person.height_m = random.uniform(0.9, 1.8);
      person.skin = i % 3 == 0 ? world::Colour{168, 116, 80} : person.skin;
      const double there_m = away_m * random.uniform(0.95, 1.05);
      const cv::Mat bgr =
          painted(there_m, random.uniform(-0.3, 0.3), person, robot, static_cast<std::uint64_t>(i));
      for (const vision::FaceBox& box : find(bgr)) {
        if (!box.box_px.contains({160, 120})) continue;
        const double seen_m =
            vision::kFaceSize_m / (2 * std::tan(vision::seen_size_rad(box.box_px, robot.camera) / 2));
        errors.push_back(std::abs(seen_m / there_m - 1));
        break;
      }
    }
    std::sort(errors.begin(), errors.end());
    out.push_back({{"m", away_m},
                   {"faces", 12},
                   {"found", errors.size()},
                   {"median_error", errors.empty() ? 1.0 : errors[errors.size() / 2]}});
  }
  return out;
}

struct Bodies {
  int pictures = 0, found = 0, as_face = 0;
  std::vector<double> bearing_deg, distance;
};

/// Somebody shows their face for a second, turns round and stays: how they are followed by their clothes.
void turn_round(double away_m, int variant, const RobotConfig& robot, Bodies& out) {
  vision::FaceWatch watch(robot, *vision::FaceFinder::open(robot));
  const world::Colour shirts[] = {{70, 110, 180}, {190, 60, 50},  {60, 140, 80},
                                  {210, 160, 50}, {120, 70, 150}, {70, 110, 180}};
  world::PersonConfig person;
  person.height_m = 1.0;
  person.shirt = shirts[variant];
  world::WorldConfig room = *world::world_by_name("sala-1");
  room.people = {person};
  world::Renderer renderer(room, robot.camera, static_cast<std::uint64_t>(variant) + 1);
  const NeckAngles neck{0, rad(-42)};
  Eigen::Isometry3d X_WC = robot.X_RC(neck);
  X_WC.pretranslate(Eigen::Vector3d(room.X_WR_start.x_m, room.X_WR_start.y_m, 0));
  const double side_m = 0.06 * away_m * (variant - 2);
  for (int i = 0; i < 50; ++i) {
    const double turned = i < 20 ? 0 : std::min(M_PI, rad(12) * (i - 19));
    const Pose2 X_WP{room.X_WR_start.x_m + away_m, room.X_WR_start.y_m + side_m, M_PI + turned};
    const Micros t = i * 50'000;
    const Frame frame{renderer.render(X_WC, {X_WP}, t), t, static_cast<std::uint64_t>(i) + 1};
    const FacesPercept seen = watch.look(frame, neck, {});
    if (i < 36) continue;
    ++out.pictures;
    out.as_face += !seen.faces.empty();
    if (seen.bodies.empty()) continue;
    ++out.found;
    const FacePercept& body = seen.bodies.front();
    out.bearing_deg.push_back(std::abs(deg(body.bearing_rad - std::atan2(side_m, away_m))));
    out.distance.push_back(std::abs(body.distance_m / std::hypot(away_m, side_m) - 1));
  }
}

json backs(const RobotConfig& robot) {
  json out = json::array();
  for (const double away_m : {0.9, 1.2, 1.6, 2.2}) {
    Bodies bodies;
    for (int variant = 0; variant < 6; ++variant) turn_round(away_m, variant, robot, bodies);
    const auto median = [](std::vector<double>& all) {
      std::sort(all.begin(), all.end());
      return all.empty() ? 0.0 : all[all.size() / 2];
    };
    out.push_back({{"m", away_m},
                   {"pictures", bodies.pictures},
                   {"found", bodies.found},
                   {"as_face", bodies.as_face},
                   {"bearing_deg", median(bodies.bearing_deg)},
                   {"distance_error", median(bodies.distance)}});
  }
  return out;
}

/// Somebody who walks across at 20 pictures a second: what one picture costs, on one thread.
json cost(const RobotConfig& robot) {
  auto finder = vision::FaceFinder::open(robot);
  if (!finder) return nullptr;
  vision::FaceWatch watch(robot, std::move(*finder));
  std::vector<cv::Mat> pictures;
  world::PersonConfig person;
  for (int i = 0; i < 60; ++i) pictures.push_back(painted(1.2, rad(i - 30), person, robot, 1));
  const SteadyClock clock;
  std::vector<double> ms;
  for (int i = 0; i < 240; ++i) {
    const Frame frame{pictures[static_cast<std::size_t>(i % 120 < 60 ? i % 60 : 59 - i % 60)], i * 50'000,
                      static_cast<std::uint64_t>(i) + 1};
    const Micros before = clock.now();
    watch.look(frame, {}, {});
    ms.push_back(seconds(clock.now() - before) * 1000);
  }
  double sum = 0;
  for (const double one : ms) sum += one;
  std::sort(ms.begin(), ms.end());
  return {{"pictures", ms.size()},
          {"mean_ms", sum / static_cast<double>(ms.size())},
          {"median_ms", ms[ms.size() / 2]},
          {"p95_ms", ms[ms.size() * 95 / 100]}};
}

struct Shown {
  cv::Mat bgr;
  cv::Rect2d face;  // empty: nobody
};

/// The cascade with uniform areas left out and without, by turns on the same pictures.
json skipping(const std::string& what, const std::vector<Shown>& pictures,
              const std::array<Find, 2>& finders) {
  const SteadyClock clock;
  std::array<Tally, 2> tallies;
  std::array<double, 2> ms{};
  for (const Shown& shown : pictures) {
    for (std::size_t i = 0; i < finders.size(); ++i) {
      const Micros before = clock.now();
      const auto found = finders[i](shown.bgr);
      ms[i] += seconds(clock.now() - before) * 1000;
      tallies[i].look(found, shown.face);
    }
  }
  const auto row = [&](std::size_t i) {
    return json{{"mean_ms", ms[i] / static_cast<double>(pictures.size())},
                {"hits", tallies[i].hits},
                {"false", tallies[i].wrong}};
  };
  return {{"what", what}, {"pictures", pictures.size()}, {"haar_everywhere", row(0)}, {"haar", row(1)}};
}

std::vector<Shown> photographs() {
  std::vector<Shown> out;
  Random random(7, "skipping");
  const Find keep = [&](const cv::Mat& bgr) {
    out.push_back({bgr.clone(), {}});
    return std::vector<vision::FaceBox>();
  };
  composites(keep, 24, 48, 1, 240, random, [&](const cv::Rect2d& face) { out.back().face = face; });
  return out;
}

std::vector<Shown> rooms_with_somebody(const RobotConfig& robot) {
  std::vector<Shown> out;
  Random random(7, "skipping rooms");
  for (std::uint64_t i = 0; i < 120; ++i) {
    world::PersonConfig person;
    person.height_m = random.uniform(1.0, 1.7);
    const double away_m = random.uniform(0.7, 1.6);
    const double side_px = vision::kFaceSize_m / away_m * robot.camera.fx_px;
    const cv::Rect2d face(160 - 0.44 * side_px, 120 - 0.54 * side_px, 0.88 * side_px, 1.08 * side_px);
    out.push_back({painted(away_m, 0, person, robot, i), face});
  }
  return out;
}

/// What a robot that turns on its place sees of a room with nobody in it, close to a wall and farther off.
std::vector<Shown> empty_rooms(const RobotConfig& robot) {
  std::vector<Shown> out;
  world::WorldConfig room = *world::world_by_name("sala-1");
  room.people.clear();
  world::Renderer renderer(room, robot.camera, 7);
  for (int i = 0; i < 120; ++i) {
    const Pose2& X_WR = room.X_WR_start;
    const Eigen::Isometry3d X_WR3 =
        Eigen::Translation3d(X_WR.x_m, X_WR.y_m, 0) *
        Eigen::AngleAxisd(X_WR.heading_rad + i * 2 * M_PI / 120, Eigen::Vector3d::UnitZ());
    out.push_back({renderer.render(X_WR3 * robot.X_RC({0, -robot.mount.tilt_rad}), {}, i), {}});
  }
  return out;
}

}  // namespace

int main() {
  cv::setNumThreads(1);
  const RobotConfig robot = *robot_by_name("mirada-sim");
  auto net = vision::FaceNet::open(vision::FaceNet::default_file());
  auto haar = vision::HaarFaces::open();
  if (!net || !haar || heads().empty()) {
    std::cerr << "the face model, opencv-data or opencv-doc is missing\n";
    return 2;
  }
  auto everywhere = vision::HaarFaces::open(vision::HaarFaces::Search::everywhere);
  const std::array<std::pair<std::string, Find>, 2> detectors{
      {{"ultraface", [&](const cv::Mat& bgr) { return net->find(bgr); }},
       {"haar", [&](const cv::Mat& bgr) { return haar->find(bgr); }}}};
  json rows = json::array(), turned = json::array();
  for (const auto& [name, find] : detectors) {
    Random random(4, "composites");
    rows.push_back(composites(find, 24, 48, 1, 240, random).row("24 to 48 px", name));
    rows.push_back(composites(find, 14, 24, 1, 120, random).row("14 to 24 px", name));
    rows.push_back(
        composites(find, 24, 48, 0.25, 120, random).row("24 to 48 px, a quarter of the light", name));
    for (const json& row : turned_heads(find, name, robot)) turned.push_back(row);
  }
  const std::array<Find, 2> finders{[&](const cv::Mat& bgr) { return everywhere->find(bgr); },
                                    detectors[1].second};
  const json skips = {skipping("photographs", photographs(), finders),
                      skipping("simulated rooms with somebody", rooms_with_somebody(robot), finders),
                      skipping("a simulated room with nobody", empty_rooms(robot), finders)};
  std::cout << json{{"composites", rows},
                    {"turned", turned},
                    {"distances", distances(detectors[0].second, robot)},
                    {"backs", backs(robot)},
                    {"skipping", skips},
                    {"cost", cost(robot)}}
                   .dump(1)
            << "\n";
}
