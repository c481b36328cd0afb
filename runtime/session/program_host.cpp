#include "session/program_host.h"

namespace mirada::session {
namespace {
constexpr std::size_t kKeptLines = 100;
}

ProgramHost::ProgramHost(robot::Motion& motion, std::uint64_t seed)
    : motion_(&motion), seed_(seed), random_(seed, "program") {}

void ProgramHost::begin_run() {
  random_ = Random(seed_, "program");
  now_ = 0;
  bubble_.clear();
  said_.clear();
}

void ProgramHost::say(vm::ThreadId thread, const std::string&, const std::string& text) {
  if (text.empty() && thread != speaker_) return;  // only who speaks may end it
  speaker_ = thread;
  bubble_ = text;
  if (text.empty()) return;
  const SaidText line{now_, text};
  said_.push_back(line);
  if (said_.size() > kKeptLines) said_.pop_front();
  if (listener_) listener_(line);
}

void ProgramHost::thread_ended(vm::ThreadId thread, vm::ThreadEnd why) {
  // A script that came to its end leaves set speeds going while others run (DESIGN section 8).
  if (why != vm::ThreadEnd::finished) motion_->script_ended(thread.value);
}

}  // namespace mirada::session
