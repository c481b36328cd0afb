// Runs program files on the machine alone (no robot, no room), ticks back to back, and prints a line of JSON
// for each: block executions per CPU-second.  bench_vm [--ticks N: stop each after N ticks] FILE...
#include <cstring>
#include <ctime>
#include <iostream>

#include "base/files.h"
#include "programs/support.h"

namespace {

using namespace mirada;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

nlohmann::json measure(const std::string& file, std::uint64_t most_ticks) {
  const std::string text = read_file(file).value();
  const double start = cpu_s();
  vm::test::Running run{std::string_view(text)};
  const double before = cpu_s();
  for (std::uint64_t tick = 0; run.machine->any_script_alive() && tick < most_ticks; ++tick) {
    run.machine->tick(true);
    run.host.clock.advance(20 * kMillisecond);
  }
  const double used = cpu_s() - before;
  nlohmann::json variables;
  for (const auto& [name, value] : run.machine->variables()) variables[name] = value.text;
  const std::uint64_t blocks = run.machine->block_executions();
  return {{"program", file},
          {"mblocks_per_cpu_s", static_cast<double>(blocks) / used * 1e-6},
          {"blocks", blocks},
          {"cpu_s", used},
          {"load_ms", (before - start) * 1e3},
          {"variables", variables}};
}

}  // namespace

int main(int count, char** words) {
  std::uint64_t ticks = UINT64_MAX;
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(words[i], "--ticks") == 0 && i + 1 < count) {
      ticks = std::stoull(words[++i]);
    } else {
      std::cout << measure(words[i], ticks).dump() << std::endl;
    }
  }
  return 0;
}
