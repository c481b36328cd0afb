#include "vm/function_builder.h"

#include <algorithm>
#include <cassert>

namespace mirada::vm {

std::int32_t FunctionBuilder::new_register(Kind kind) {
  std::vector<std::int32_t>& spare = free_[static_cast<std::size_t>(kind)];
  if (!spare.empty()) {
    const std::int32_t reg = spare.back();
    spare.pop_back();
    return reg;
  }
  kinds_.push_back(kind);
  return static_cast<std::int32_t>(kinds_.size()) - 1;
}

Operand FunctionBuilder::temporary(Kind kind, Types types) { return {new_register(kind), kind, types, true}; }

void FunctionBuilder::free(const Operand& operand) {
  if (operand.temporary) free_[static_cast<std::size_t>(operand.kind)].push_back(operand.reg);
}

std::size_t FunctionBuilder::emit(Op op, std::int32_t a, std::int32_t b, std::int32_t c) {
  out_.code.push_back({.a = a, .b = b, .c = c, .op = op});
  out_.block_of.push_back(block_);
  label_here_ = false;
  return out_.code.size() - 1;
}

std::size_t FunctionBuilder::emit_end(Op op, std::int32_t a, std::int32_t b, std::int32_t c) {
  while (pending_ > 0xFFFF) {
    const std::size_t extra = emit(Op::count);
    out_.code[extra].executions = 0xFFFF;
    pending_ -= 0xFFFF;
  }
  const std::size_t at = emit(op, a, b, c);
  out_.code[at].executions = static_cast<std::uint16_t>(pending_);
  pending_ = 0;
  return at;
}

void FunctionBuilder::flush_count() {
  if (pending_ > 0) emit_end(Op::count);
}

void FunctionBuilder::jump(Op op, Label& to, std::int32_t a, std::int32_t b) {
  const std::size_t at = emit_end(op, a, b);
  if (to.at >= 0) {
    out_.code[at].c = to.at - static_cast<std::int32_t>(at);
  } else {
    to.waiting.push_back(at);
  }
}

void FunctionBuilder::bind(Label& label) {
  flush_count();
  label.at = static_cast<std::int32_t>(out_.code.size());
  for (const std::size_t at : label.waiting) out_.code[at].c = label.at - static_cast<std::int32_t>(at);
  label.waiting.clear();
  label_here_ = true;
}

bool FunctionBuilder::retarget(const Operand& temporary, std::int32_t wanted) {
  if (!temporary.temporary || out_.code.empty() || label_here_) return false;
  Instr& last = out_.code.back();
  const char writes = row_of(last.op).a;
  if ((writes != 'N' && writes != 'V') || last.a != temporary.reg) return false;
  last.a = wanted;
  return true;
}

std::int32_t FunctionBuilder::outgoing(std::size_t i) {
  outgoing_ = std::max(outgoing_, static_cast<std::uint32_t>(i) + 1);
  return kOutgoing + static_cast<std::int32_t>(i);
}

void FunctionBuilder::settle(std::int32_t& operand) const {
  if (operand >= kOutgoing) operand += static_cast<std::int32_t>(kinds_.size()) - kOutgoing;
}

/// A jump to where the function ends is that end.
void FunctionBuilder::shorten_ways_out() {
  for (std::size_t i = 0; i < out_.code.size(); ++i) {
    Instr& instr = out_.code[i];
    if (instr.op != Op::jump) continue;
    const Instr& there = out_.code[i + static_cast<std::size_t>(instr.c)];
    const unsigned executions = unsigned{instr.executions} + there.executions;
    if (there.op == Op::ret && executions <= 0xFFFF)
      instr = {.executions = static_cast<std::uint16_t>(executions), .op = Op::ret};
  }
}

void FunctionBuilder::finish() {
  assert(pending_ == 0);
  shorten_ways_out();
  for (Instr& instr : out_.code) {
    settle(instr.a);
    if (instr.op == Op::call) instr.c = static_cast<std::int32_t>(kinds_.size());
    instr.run = handler_of(instr);
  }
  out_.frame_size = static_cast<std::uint32_t>(kinds_.size());
  out_.reserve = out_.frame_size + outgoing_;
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i] == Kind::value) out_.value_slots.push_back(static_cast<std::uint16_t>(i));
  }
}

}  // namespace mirada::vm
