// What waiting costs and how exact it is on the live robot, in this process, on the wall clock; prints JSON.
//  wake_up: how much longer than asked a `wait` takes, by the program's own timer, alone and beside a script
//           that never waits.
//  beside_faces: how often obstacles are seen, and how long the loop of scripts and motors is silent, while
//  faces are
//           looked for as well and while they are not, turn by turn.
//  waiting: CPU time of the whole robot with 1,000 scripts that wait, less that of one without a program.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <optional>
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

/// Asks for obstacles, and for faces if wanted, and drives, as a child's program does.
std::string sees(bool faces) {
  const Json ask = set("cm", in(block("vision_obstacle_distance", {{"ANGLE", number(0)}})));
  std::vector<Json> tops{hat({forever(
      stack({ask, block("motion_set_speeds", {{"LEFT", number(5)}, {"RIGHT", number(-5)}}), wait(0.05)}))})};
  if (faces) tops.push_back(hat({forever(stack({set("people", in(block("people_count"))), wait(0.05)}))}));
  return program(std::move(tops), {"cm", "people"}).dump();
}

/// What the loop that serves scripts and motors brings, on the machine's clock: its snapshots come every 50
/// ms, so that no more than 20 answers a second are counted.
struct Seen {
  int faces = 0, sonar = 0;
  double silent_ms = 0;  ///< longest without a new snapshot
  double behind_ms = 0;  ///< most that the robot's clock has lost, at a new snapshot
};

Seen watch(session::Station& station, double seconds) {
  Seen seen;
  const SteadyClock wall;
  const auto first = station.telemetry();
  Micros sonar_at = 0, faces_at = 0, robot_at = first->t;
  const Micros begin = wall.now();
  Micros news = begin;
  std::optional<Micros> in_step;  // the clocks' difference at the first new snapshot
  while (mirada::seconds(wall.now() - begin) < seconds) {
    sleep_s(0.0005);
    const auto now = station.telemetry();
    if (now->percepts == nullptr || now->t == robot_at) continue;
    const Micros here = wall.now();
    robot_at = now->t;
    if (!in_step) in_step = here - now->t;
    seen.behind_ms = std::max(seen.behind_ms, static_cast<double>(here - now->t - *in_step) * 1e-3);
    seen.silent_ms = std::max(seen.silent_ms, static_cast<double>(here - news) * 1e-3);
    news = here;
    seen.sonar += now->percepts->sonar.t_exposure != sonar_at;
    seen.faces += now->percepts->faces.t_exposure != faces_at;
    sonar_at = now->percepts->sonar.t_exposure;
    faces_at = now->percepts->faces.t_exposure;
  }
  return seen;
}

Json looking(session::Station& station, bool faces) {
  constexpr double kSeconds = 20;
  if (!station.start(sees(faces))) return "not started";
  sleep_s(1);
  const Seen seen = watch(station, kSeconds);
  station.stop(session::StopReason::stop_button);
  return {{"sonar_per_s", seen.sonar / kSeconds},
          {"faces_per_s", seen.faces / kSeconds},
          {"longest_silence_ms", seen.silent_ms},
          {"clock_lost_ms", seen.behind_ms}};
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
