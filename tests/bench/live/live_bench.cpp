// What waiting costs and how exact it is on the live robot, in this process, on the wall clock; prints JSON.
//  wake_up: how much longer than asked a `wait` takes, by the program's own timer, alone and beside a script
//           that never waits.
//  beside_faces: how often obstacles are seen, and how late scripts and motors are served, while faces are
//           looked for as well and while they are not, turn by turn.
//  waiting: CPU time of the whole robot with 1,000 scripts that wait, less that of one without a program.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <thread>

#include "base/clock.h"
#include "programs/support.h"
#include "rig/station_factory.h"

namespace {

using namespace mirada;
using namespace mirada::vm::test;

constexpr double kWait_s = 0.0137;
constexpr int kWaits = 200;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

Json timer() { return in(block("sensing_timer")); }
Json minus(Json a, Json b) {
  return in(block("operator_subtract", {{"NUM1", std::move(a)}, {"NUM2", std::move(b)}}));
}
Json set(const std::string& name, Json value) {
  return block("data_setvariableto", {{"VALUE", std::move(value)}}, {{"VARIABLE", named(name)}});
}
Json forever(Json body) { return block("control_forever", {{"SUBSTACK", in(std::move(body))}}); }
Json wait(double seconds) { return block("control_wait", {{"DURATION", number(seconds)}}); }

/// Notes by how many seconds each wait was too long.
std::string waits(bool beside_a_busy_script) {
  const Json start = set("start", timer());
  const Json over = minus(minus(timer(), in(var("start"))), number(kWait_s));
  const Json note = block("data_addtolist", {{"ITEM", over}}, {{"LIST", named("over")}});
  std::vector<Json> tops{
      hat({block("control_repeat",
                 {{"TIMES", number(kWaits)}, {"SUBSTACK", in(stack({start, wait(kWait_s), note}))}})})};
  if (beside_a_busy_script) {
    tops.push_back(hat(
        {forever(block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named("busy")}}))}));
  }
  return program(std::move(tops), {"start", "busy"}, {"over"}).dump();
}

Json wake_up(session::Station& station, bool busy) {
  if (!station.start(waits(busy))) return "not started";
  sleep_s(kWaits * (kWait_s + 0.02) + 0.5);
  const auto telemetry = station.telemetry();
  station.stop(session::StopReason::stop_button);
  std::vector<double> values_ms;
  for (const vm::MonitorValue& item : telemetry->lists.at("over")) values_ms.push_back(item.number * 1e3);
  if (values_ms.size() < 10) return "too few";
  std::ranges::sort(values_ms);
  return {{"waits", values_ms.size()},
          {"p50_ms", values_ms[values_ms.size() / 2]},
          {"p99_ms", values_ms[values_ms.size() * 99 / 100]},
          {"max_ms", values_ms.back()}};
}

/// A script that never waits notes the longest time in which it had no turn: script and motors are served by
/// one loop. Others ask for obstacles, and for faces if wanted, as a child's program does.
std::string sees(bool faces) {
  const Json gap = minus(in(var("now")), in(var("last")));
  const Json longest =
      block("control_if",
            {{"CONDITION", in(block("operator_gt", {{"OPERAND1", gap}, {"OPERAND2", in(var("longest"))}}))},
             {"SUBSTACK", in(set("longest", gap))}});
  const Json ask = set("cm", in(block("vision_obstacle_distance", {{"ANGLE", number(0)}})));
  std::vector<Json> tops{
      hat({set("last", timer()),
           forever(stack({set("now", timer()), longest, set("last", in(var("now")))}))}),
      hat({forever(stack(
          {ask, block("motion_set_speeds", {{"LEFT", number(5)}, {"RIGHT", number(-5)}}), wait(0.05)}))})};
  if (faces) tops.push_back(hat({forever(stack({set("people", in(block("people_count"))), wait(0.05)}))}));
  return program(std::move(tops), {"now", "last", "longest", "cm", "people"}).dump();
}

struct Seen {
  int faces = 0;         ///< answers
  int sonar = 0;         ///< answers
  double widest_ms = 0;  ///< between two of the sonar's pictures
  double oldest_ms = 0;  ///< the sonar's answer, when it came
  double behind_ms = 0;  ///< the robot's clock, the most, on the machine's
};

Seen watch(session::Station& station, double seconds) {
  Seen seen;
  Micros sonar_at = 0, faces_at = 0;
  const SteadyClock wall;
  const Micros begin = wall.now(), robot_begin = station.telemetry()->t;
  while (mirada::seconds(wall.now() - begin) < seconds) {
    sleep_s(0.001);
    const auto now = station.telemetry();
    if (now->percepts == nullptr) continue;
    const Micros behind = (wall.now() - begin) - (now->t - robot_begin);
    seen.behind_ms = std::max(seen.behind_ms, static_cast<double>(behind) * 1e-3);
    const Micros sonar = now->percepts->sonar.t_exposure, faces = now->percepts->faces.t_exposure;
    if (faces != faces_at) ++seen.faces;
    if (sonar != sonar_at) {
      if (sonar_at != 0)
        seen.widest_ms = std::max(seen.widest_ms, static_cast<double>(sonar - sonar_at) * 1e-3);
      seen.oldest_ms = std::max(seen.oldest_ms, static_cast<double>(now->t - sonar) * 1e-3);
      ++seen.sonar;
    }
    sonar_at = sonar;
    faces_at = faces;
  }
  return seen;
}

Json looking(session::Station& station, bool faces) {
  constexpr double kSeconds = 20;
  if (!station.start(sees(faces))) return "not started";
  sleep_s(1);
  const Seen seen = watch(station, kSeconds);
  const auto last = station.telemetry();
  station.stop(session::StopReason::stop_button);
  return {{"sonar_per_s", seen.sonar / kSeconds},
          {"faces_per_s", seen.faces / kSeconds},
          {"sonar_widest_gap_ms", seen.widest_ms},
          {"sonar_oldest_ms", seen.oldest_ms},
          {"clock_most_behind_ms", seen.behind_ms},
          {"longest_without_a_turn_ms", last->variables.at("longest").number * 1e3}};
}

Json beside_faces(session::Station& station) {
  Json with = Json::array(), without = Json::array();
  for (int round = 0; round < 3; ++round) {
    without.push_back(looking(station, false));
    with.push_back(looking(station, true));
  }
  return {{"without_faces", without}, {"with_faces", with}};
}

double core_percent(double seconds) {
  const double before = cpu_s();
  sleep_s(seconds);
  return (cpu_s() - before) / seconds * 100;
}

Json waiting(session::Station& station) {
  std::vector<Json> tops;
  for (int i = 0; i < 1000; ++i) tops.push_back(hat({forever(wait(1 + 0.01 * (i % 50)))}));
  const std::string text = program(std::move(tops), {}).dump();
  sleep_s(0.5);
  const double without = core_percent(5);
  if (!station.start(text)) return "not started";
  sleep_s(0.5);
  const double with = core_percent(5);
  station.stop(session::StopReason::stop_button);
  return {{"without_program_core_percent", without},
          {"with_core_percent", with},
          {"scripts_core_percent", with - without}};
}

}  // namespace

int main() {
  rig::StationOptions options;
  options.packs = rig::load_shipped_packs();
  const auto station = std::move(rig::make_station(options).value());
  std::cout << Json{{"bench", "live"},
                    {"wake_up",
                     {{"alone", wake_up(*station, false)}, {"beside_busy", wake_up(*station, true)}}},
                    {"beside_faces", beside_faces(*station)},
                    {"waiting", waiting(*station)}}
                   .dump(1)
            << "\n";
  return 0;
}
