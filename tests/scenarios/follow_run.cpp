#include "follow_run.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "base/random.h"
#include "follow_oracle.h"
#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"

namespace mirada::scenarios {
namespace {

using Eigen::Vector2d;

constexpr double kHalfRoom_m = 4;
constexpr double kWall_m = 1.3;  // the walker keeps off the walls
constexpr double kStep_s = 0.01;
constexpr std::size_t kLessonSteps = 450;  // of the world: the walker waits at one corner a step

std::string follow_program(bool learn) {
  using namespace rig;
  const std::string loop = forever(block({"control_wait", "wait", number_input("DURATION", "1"), ""}));
  const std::string follow =
      block({"people_follow_person", "follow", number_input("DISTANCE", "100"), ""}, loop);
  const std::string begin =
      learn ? block({"people_learn", "learn", text_input("NAME", "Ana"), ""}, follow) : follow;
  return program(flag(block({"looking_tilt_to", "tilt", number_input("ANGLE", "45"), ""}, begin)));
}

/// Corners by chance, none of them over the robot's head: each leg begins with a turn of at most 100 degrees.
std::vector<Vector2d> way_by_chance(Vector2d at, double heading_rad, Random& random) {
  std::vector<Vector2d> out;
  while (out.size() < 40) {
    const double turn = random.uniform(-rad(100), rad(100));
    const double leg_m = random.uniform(0.8, 2.2);
    const double next_rad = heading_rad + turn;
    const Vector2d next = at + leg_m * Vector2d(std::cos(next_rad), std::sin(next_rad));
    const double most = kHalfRoom_m - kWall_m;
    if (std::max(std::abs(next.x()), std::abs(next.y())) > most) {
      heading_rad = wrap_rad(heading_rad + rad(35));
      continue;
    }
    heading_rad = next_rad;
    at = next;
    out.push_back(at);
  }
  return out;
}

void trace_line(std::ostream& out, Micros t, const world::Truth& truth) {
  const Pose2& person = truth.people[0];
  const Vector2d to(person.x_m - truth.X_WR.x_m, person.y_m - truth.X_WR.y_m);
  const double way_rad = std::atan2(to.y(), to.x());
  out << mirada::seconds(t) << ',' << deg(wrap_rad(way_rad - truth.X_WR.heading_rad - truth.neck.pan_rad))
      << ',' << to.norm() << ',' << deg(wrap_rad(way_rad + M_PI - person.heading_rad)) << ','
      << deg(truth.neck.pan_rad) << ',' << deg(truth.X_WR.heading_rad) << '\n';
}

}  // namespace

world::WorldConfig follow_room(const Walk& walk, std::uint64_t seed) {
  Random random(seed, "follow room");
  world::WorldConfig room = *world::world_by_name("sala-1");
  const double half = kHalfRoom_m;
  room.bounds = {-half, -half, half, half};
  room.lines.clear();
  room.boxes.clear();
  room.cylinders.clear();
  room.people.clear();
  room.walls = {{{{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}},
                 2.4,
                 world::WallLook::paint,
                 {225, 218, 205}}};
  room.X_WR_start = {-1, 0, 0};
  world::PersonConfig person;
  // Comes toward the robot first, so that it sees a face.
  person.X_WP = {0.6, 0, rad(180)};
  person.height_m = random.uniform(0.9, 1.1);  // whose faces a camera 20 cm high can see at 1 m
  person.radius_m = 0.14;
  const world::Colour shirts[] = {
      {70, 110, 180}, {190, 60, 50}, {60, 140, 80}, {210, 160, 50}, {120, 70, 150}};
  person.shirt = shirts[static_cast<std::size_t>(random.integer(0, 4))];
  person.speed_mps = walk.speed_mps;
  person.watches_robot = walk.watches_robot;
  person.path_m = way_by_chance({0, 0}, random.uniform(-rad(70), rad(70)), random);
  person.path_m.insert(person.path_m.begin(), {0, 0});
  if (walk.pillar) {
    // Behind a pillar, some steps aside, and on.
    room.cylinders.push_back({{1.6, 0.9}, 0.22, 1.6, world::CylinderLook::plain, {150, 150, 160}});
    person.path_m = {{1.2, -0.4}, {2.6, 0.2}, {2.6, 1.6}, {1.0, 2.2}, {-0.5, 1.5}};
  }
  if (walk.poster) {
    room.boxes.push_back({{3.2, -1.5, rad(90)}, 0.5, 0.03, 1.25, world::BoxLook::poster, {225, 218, 205}});
    room.boxes.push_back({{-3, 1.8, 0}, 0.5, 0.03, 1.2, world::BoxLook::poster, {225, 218, 205}});
  }
  if (walk.learnt) {
    person.face = static_cast<int>(random.integer(1, 3));
    world::wear_own_colours(person);
    // Stands and looks until the lesson is over.
    person.X_WP = {-0.05, 0, rad(180)};
    person.path_m.insert(person.path_m.begin(), kLessonSteps, Vector2d(-0.05, 0));
  }
  room.people = {person};
  return room;
}

FollowRun run_follow(const Walk& walk, std::uint64_t seed, double seconds, double settle_s,
                     std::ostream* trace) {
  rig::LockstepOptions options;
  options.world = follow_room(walk, seed);
  options.robot = *robot_by_name("mirada-sim");
  options.seed = seed;
  options.seconds = seconds;
  FollowRun run;
  run.seed = seed;
  int steps = 0, in_view = 0, at_distance = 0, both = 0, too_near = 0;
  double out_s = 0;
  if (walk.learnt) {
    options.book = std::make_shared<vision::FaceBook>();
    (void)options.book->allow(true);
  }
  double poster_s = 0;
  const std::vector<world::BoxConfig> posters = options.world->boxes;
  const auto looks_at = [](const world::Truth& truth, double x_m, double y_m) {
    const double bearing = std::atan2(y_m - truth.X_WR.y_m, x_m - truth.X_WR.x_m);
    return std::abs(wrap_rad(bearing - truth.X_WR.heading_rad - truth.neck.pan_rad)) <= rad(10);
  };
  options.watch = [&](Micros t, const world::Truth& truth) {
    const Vector2d to(truth.people[0].x_m - truth.X_WR.x_m, truth.people[0].y_m - truth.X_WR.y_m);
    run.end_off_m = to.norm() - 1;
    if (trace != nullptr && t % (100 * kMillisecond) == 0) trace_line(*trace, t, truth);
    if (t < micros(settle_s)) return;
    const bool seen = looks_at(truth, truth.people[0].x_m, truth.people[0].y_m);
    const bool near = to.norm() >= 0.8 && to.norm() <= 1.2;
    const bool at_poster = !seen && std::any_of(posters.begin(), posters.end(), [&](const auto& box) {
      return looks_at(truth, box.X_WB.x_m, box.X_WB.y_m);
    });
    poster_s = at_poster ? poster_s + kStep_s : 0;
    run.longest_poster_s = std::max(run.longest_poster_s, poster_s);
    ++steps;
    in_view += seen;
    at_distance += near;
    both += seen && near;
    too_near += to.norm() < 0.8;
    out_s = seen ? 0 : out_s + kStep_s;
    run.longest_out_s = std::max(run.longest_out_s, out_s);
  };
  const session::RunReport report = rig::run_lockstep(follow_program(walk.learnt), options);
  const double all = std::max(steps, 1);
  run.in_view_share = in_view / all;
  run.at_distance_share = at_distance / all;
  run.both_share = both / all;
  run.too_near_share = too_near / all;
  run.too_far_share = 1 - run.at_distance_share - run.too_near_share;
  run.status = to_string(report.status);
  run.contacts = report.robot ? report.robot->contacts : 0;
  run.wall_s = report.wall_s;
  run.hash = report.hash;
  return run;
}

FollowRun run_oracle(const Walk& walk, std::uint64_t seed, double seconds, double delay_s, double settle_s) {
  rig::LockstepOptions options;
  options.world = follow_room(walk, seed);
  options.robot = *robot_by_name("mirada-sim");
  options.seed = seed;
  options.seconds = seconds;
  FollowOracle oracle(options.robot.drive, options.world->X_WR_start, 1, delay_s);
  Pose2 person = options.world->people[0].X_WP;
  FollowRun run;
  run.seed = seed;
  int steps = 0, at_distance = 0, both = 0, too_near = 0;
  options.carry = [&](Micros) { return std::optional(oracle.step(person, kStep_s)); };
  options.watch = [&](Micros t, const world::Truth& truth) {
    person = truth.people[0];
    run.contacts = truth.contacts;
    if (t < micros(settle_s)) return;
    const double away_m = std::hypot(person.x_m - truth.X_WR.x_m, person.y_m - truth.X_WR.y_m);
    const bool near = away_m >= 0.8 && away_m <= 1.2;
    ++steps;
    at_distance += near;
    both += near && oracle.sees();
    too_near += away_m < 0.8;
  };
  using namespace rig;
  const std::string wait = forever(block({"control_wait", "wait", number_input("DURATION", "1"), ""}));
  (void)rig::run_lockstep(program(flag(wait)), options);
  const double all = std::max(steps, 1);
  run.at_distance_share = at_distance / all;
  run.both_share = both / all;
  run.too_near_share = too_near / all;
  run.too_far_share = 1 - run.at_distance_share - run.too_near_share;
  return run;
}

}  // namespace mirada::scenarios
