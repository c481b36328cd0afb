// What waiting costs and how exact it is on the live robot, in this process, on the wall clock; prints JSON.
//  wake_up: how much longer than asked a `wait` takes, by the program's own timer, alone and beside a script
//  that
//           never waits.
//  waiting: CPU time of the whole robot with 1,000 scripts that wait, less that of one without a program.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <thread>

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
Json forever(Json body) { return block("control_forever", {{"SUBSTACK", in(std::move(body))}}); }
Json wait(double seconds) { return block("control_wait", {{"DURATION", number(seconds)}}); }

/// Notes by how many seconds each wait was too long.
std::string waits(bool beside_a_busy_script) {
  const Json start = block("data_setvariableto", {{"VALUE", timer()}}, {{"VARIABLE", named("start")}});
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
                    {"waiting", waiting(*station)}}
                   .dump(1)
            << "\n";
  return 0;
}
