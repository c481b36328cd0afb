#include <algorithm>

#include "blocks/native_blocks.h"

namespace mirada::blocks {
namespace {

using vm::NativeCall;
using vm::NativeResult;

constexpr double kLongest_s = 3'600;

/// Until when the bubble stays.
struct Speaking final : vm::NativeState {
  Micros until = 0;
};

void speak(const Link& link, const NativeCall& call, const std::string& text) {
  if (link.host != nullptr) link.host->say(call.thread(), call.block(), text);
}

NativeResult say(const Link& link, const NativeCall& call) {
  speak(link, call, call.text(0));
  return NativeResult::finished();
}

NativeResult say_for_seconds(const Link& link, NativeCall& call) {
  if (!call.state()) {
    speak(link, call, call.text(0));
    const double asked_s = call.number(1);
    auto speaking = std::make_unique<Speaking>();
    speaking->until = call.now() + micros(asked_s > 0 ? std::min(asked_s, kLongest_s) : 0);
    const Micros until = speaking->until;
    call.state() = std::move(speaking);
    return NativeResult::again_at(until);
  }
  const Micros until = static_cast<const Speaking&>(*call.state()).until;
  if (call.now() < until) return NativeResult::again_at(until);
  speak(link, call, "");
  return NativeResult::finished();
}

}  // namespace

void add_say_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["looks_say"] = [link](NativeCall& call) { return say(*link, call); };
  table["looks_sayforsecs"] = [link](NativeCall& call) { return say_for_seconds(*link, call); };
}

}  // namespace mirada::blocks
