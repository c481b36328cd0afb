// How long a live machine goes on after Stop, for programs that make it hard; prints JSON. From the call of
// interrupt() until the tick has returned: no instruction runs after that. CPU time of the machine's thread,
// so that other work on the computer does not count; each program is stopped many times.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <thread>

#include <pthread.h>

#include "programs/support.h"

namespace {

using namespace mirada;
using namespace mirada::vm::test;

constexpr int kTimes = 40;

Json set(const std::string& name, Json value) {
  return block("data_setvariableto", {{"VALUE", std::move(value)}}, {{"VARIABLE", named(name)}});
}
Json change(const std::string& name) {
  return block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named(name)}});
}
Json add(Json item) { return block("data_addtolist", {{"ITEM", std::move(item)}}, {{"LIST", named("L")}}); }
Json join(Json a, Json b) {
  return block("operator_join", {{"STRING1", std::move(a)}, {"STRING2", std::move(b)}});
}
Json forever(std::vector<Json> body) {
  return block("control_forever", {{"SUBSTACK", in(stack(std::move(body)))}});
}
Json repeat(double times, std::vector<Json> body) {
  return block("control_repeat", {{"TIMES", number(times)}, {"SUBSTACK", in(stack(std::move(body)))}});
}
Json operation(const std::string& opcode, const char* a, const char* b, Json x, Json y) {
  return block(opcode, {{a, std::move(x)}, {b, std::move(y)}});
}
/// `first`, then `body` for ever, all at once.
Json hard(std::vector<Json> first, std::vector<Json> body) {
  first.push_back(forever(std::move(body)));
  Json all = stack(std::move(first));
  return program({hat({block("control_all_at_once", {{"SUBSTACK", in(std::move(all))}})})}, {"i", "s", "t"},
                 {"L"});
}

/// "s" becomes `seed` doubled so many times.
std::vector<Json> grown(const std::string& seed, double doublings) {
  return {set("s", text(seed)), repeat(doublings, {set("s", in(join(in(var("s")), in(var("s")))))})};
}
/// "s" and "t" become long texts that are the same but for their case.
std::vector<Json> great_and_small(const std::string& great, const std::string& small) {
  std::vector<Json> blocks = grown(great, 17);
  blocks.push_back(set("t", in(var("s"))));
  for (Json& one : grown(small, 17)) blocks.push_back(std::move(one));
  return blocks;
}
std::vector<Json> numbers_in_list() { return {repeat(200'000, {add(in(var("i"))), change("i")})}; }
std::vector<Json> texts_in_list() {
  return {repeat(200'000, {add(in(join(text("n"), in(var("i"))))), change("i")})};
}

std::vector<std::pair<std::string, Json>> hard_programs() {
  const Json s = in(var("s"));
  const auto contents = [] { return block("data_listcontents", Json::object(), {{"LIST", named("L")}}); };
  const auto place_of = [](Json item) {
    return block("data_itemnumoflist", {{"ITEM", std::move(item)}}, {{"LIST", named("L")}});
  };
  const Json compare_them =
      set("i", in(operation("operator_equals", "OPERAND1", "OPERAND2", s, in(var("t")))));
  const Json insert_first =
      block("data_insertatlist", {{"INDEX", number(1)}, {"ITEM", text("x")}}, {{"LIST", named("L")}});
  return {
      {"count", hard({}, {change("i")})},
      {"sine",
       hard({}, {set("t", in(block("operator_mathop", {{"NUM", in(var("i"))}}, {{"OPERATOR", "sin"}}))),
                 change("i")})},
      {"join 1 MiB", hard(grown("abcdefgh", 17), {set("t", in(join(s, text("x"))))})},
      {"compare 1 MiB",
       hard(grown("abcdefgh", 17),
            {set("t", in(operation("operator_equals", "OPERAND1", "OPERAND2", s, in(join(s, text(""))))))})},
      {"compare 2 MiB of Greek, great and small",
       hard(great_and_small("\u0393\u0395\u0399\u0391 \u03a3\u039f\u03a5",
                            "\u03b3\u03b5\u03b9\u03b1 \u03c3\u03bf\u03c5"),
            {compare_them})},
      {"compare 2 MiB of letters of two units",
       hard(great_and_small("\U00010400\U00010401\U00010402\u0130", "\U00010428\U00010429\U0001042ai\u0307"),
            {compare_them})},
      {"number of 2 MiB of Greek",
       hard(grown("\u0393\u03b5\u03b9\u03ac \u03c3\u03bf\u03c5", 17),
            {set("t", in(operation("operator_add", "NUM1", "NUM2", s, number(1))))})},
      {"number of 2 MiB",
       hard(grown("12345678", 18), {set("t", in(operation("operator_add", "NUM1", "NUM2", s, number(1))))})},
      {"contains in 2 MiB",
       hard(grown("aaaaaaaa", 18), {set("t", in(operation("operator_contains", "STRING1", "STRING2", s,
                                                          text("aaaaaaaaaaaaaaaaaaaaaaab"))))})},
      {"find in 200,000 numbers", hard(numbers_in_list(), {set("t", in(place_of(number(-1))))})},
      {"find in 200,000 texts", hard(texts_in_list(), {set("t", in(place_of(text("none"))))})},
      {"insert in 200,000", hard(texts_in_list(), {insert_first})},
      {"text of 200,000", hard(texts_in_list(), {set("t", in(contents()))})},
      {"numbers of 200,000", hard(numbers_in_list(), {set("t", in(contents()))})},
  };
}

double thread_cpu_ms(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// CPU time that the tick's thread uses from interrupt(), called when `nap` is over, until the tick has
/// returned.
double stop_once(Running& run, std::chrono::microseconds nap) {
  clockid_t ticking{};
  pthread_getcpuclockid(pthread_self(), &ticking);
  double called_ms = 0;
  std::thread other([&] {
    std::this_thread::sleep_for(nap);
    called_ms = thread_cpu_ms(ticking);
    run.machine->interrupt();
  });
  run.machine->tick();
  const double ended_ms = thread_cpu_ms(ticking);
  other.join();
  return ended_ms - called_ms;
}

Json measure(const std::string& name, const Json& json) {
  const SteadyClock wall;
  vm::Limits limits = vm::live_limits(wall);
  limits.tick_time = 3600 * kSecond;  // only the interrupt ends a tick
  Running run(json, limits);
  for (int i = 0; i < 4; ++i) stop_once(run, std::chrono::milliseconds(200));  // past what it does first
  std::vector<double> values;
  for (int i = 0; i < kTimes; ++i)
    values.push_back(stop_once(run, std::chrono::microseconds(2000 + 497 * i)));
  std::ranges::sort(values);
  return {{"program", name},
          {"stop_p50_cpu_ms", values[values.size() / 2]},
          {"stop_max_cpu_ms", values.back()},
          {"faults", run.machine->take_faults().size()},
          {"alive", run.machine->any_script_alive()}};
}

}  // namespace

int main() {
  Json runs = Json::array();
  for (const auto& [name, json] : hard_programs()) runs.push_back(measure(name, json));
  std::cout << Json{{"bench", "stop"}, {"runs", runs}}.dump(1) << "\n";
  return 0;
}
