#pragma once
#include <string_view>

#include "programs/support.h"

namespace mirada::vm::fuzz {

/// Reads bytes as a program, and runs what can be run for a few small ticks: whatever they are, the process
/// lives on and Stop stops.
inline void run_some(std::string_view bytes) {
  const Result<LoadedProgram> loaded = load_program(bytes, test::core_catalog());
  if (!loaded) {
    if (loaded.faults().empty()) std::abort();  // refused without a word
    return;
  }
  test::NotingHost host;
  Limits limits;
  limits.executions_per_tick = 2'000;
  limits.warp_executions = 4'000;
  limits.max_text_bytes = 1u << 16;
  limits.max_total_bytes = 16u << 20;
  limits.max_depth = 2'000;
  Machine machine(loaded->code, test::core_catalog(), host, limits);
  machine.flag();
  machine.key("space", true);
  for (int i = 0; i < 3; ++i) {
    machine.tick(i % 2 == 0);
    host.clock.advance(kSecond);
    (void)machine.running_blocks();
  }
  (void)machine.variables();
  (void)machine.lists();
  machine.stop();
  if (machine.any_script_alive()) std::abort();
}

}  // namespace mirada::vm::fuzz
