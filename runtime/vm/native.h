#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "base/fault.h"
#include "base/units.h"

namespace mirada::vm {

/// One run of one script. Never reused for another run.
struct ThreadId {
  std::uint64_t value = 0;
  auto operator<=>(const ThreadId&) const = default;
};

/// What a native block keeps between the turns of one execution; destroyed when the block ends or its script
/// is killed.
struct NativeState {
  virtual ~NativeState() = default;
};

/// One execution of a native block, as the block's code sees it. Arguments count from 0 in the order of
/// pack.json (menus and other fields included) and are cast by Scratch's rules.
class NativeCall {
 public:
  virtual ~NativeCall() = default;
  virtual double number(std::size_t arg) const = 0;
  virtual std::string text(std::size_t arg) const = 0;
  virtual bool truth(std::size_t arg) const = 0;
  virtual ThreadId thread() const = 0;
  virtual const std::string& block() const = 0;
  /// The program's clock: it stands still while the program is paused.
  virtual Micros now() const = 0;
  /// Null in the block's first turn unless the block has put something there.
  virtual std::unique_ptr<NativeState>& state() = 0;
};

/// What a native block answers. `again` lets other scripts run and calls the block again in a later tick, not
/// before the time given (0: the next tick).
struct NativeResult {
  enum class Kind { done, number, text, truth, again, fault };
  Kind kind = Kind::done;
  double number = 0;
  std::string text;
  bool truth = false;
  Micros not_before = 0;
  const Message* message = nullptr;
  MessageArgs args;

  static NativeResult finished() { return {}; }
  static NativeResult of(double value) {
    return {.kind = Kind::number, .number = value, .text = {}, .args = {}};
  }
  static NativeResult of(std::string value) {
    return {.kind = Kind::text, .text = std::move(value), .args = {}};
  }
  static NativeResult of(bool value) { return {.kind = Kind::truth, .text = {}, .truth = value, .args = {}}; }
  static NativeResult again_at(Micros t = 0) {
    return {.kind = Kind::again, .text = {}, .not_before = t, .args = {}};
  }
  static NativeResult failed(const Message& why, MessageArgs with = {}) {
    return {.kind = Kind::fault, .text = {}, .message = &why, .args = std::move(with)};
  }
};

/// A native block's meaning. Called on the VM's thread; must not block. A hat's native gives a truth: the hat
/// fires when it turns from false to true, looked at once a tick.
using NativeFn = std::function<NativeResult(NativeCall&)>;
using NativeTable = std::map<std::string, NativeFn, std::less<>>;

}  // namespace mirada::vm
