#pragma once
#include <string>

#include "vm/handlers.h"

namespace mirada::vm {

/// One execution of a native block, over the registers that hold its arguments.
class NativeCallOf final : public NativeCall {
 public:
  NativeCallOf(const NativeSite& site, Thread& thread, const Host& host, const std::string& block,
               Slot* frame, Slot* globals)
      : site_(site), thread_(thread), host_(host), block_(block), frame_(frame), globals_(globals) {}

  double number(std::size_t arg) const override { return to_number(value(arg)); }
  std::string text(std::size_t arg) const override { return to_string(value(arg)); }
  bool truth(std::size_t arg) const override { return to_truth(value(arg)); }
  ThreadId thread() const override { return ThreadId{thread_.serial}; }
  const std::string& block() const override { return block_; }
  Micros now() const override { return host_.now(); }
  std::unique_ptr<NativeState>& state() override { return thread_.native_state; }

 private:
  const Value& value(std::size_t arg) const { return any_reg(frame_, globals_, site_.args[arg]).v; }

  const NativeSite& site_;
  Thread& thread_;
  const Host& host_;
  const std::string& block_;
  Slot* frame_;
  Slot* globals_;
};

}  // namespace mirada::vm
