#pragma once
#include <vector>

#include "vm/code.h"
#include "vm/types.h"

namespace mirada::vm {

/// A register with what is known of its content. Truths in number registers are 0 or 1, with types ==
/// type::truth.
struct Operand {
  std::int32_t reg = 0;
  Kind kind = Kind::number;
  Types types = type::number;
  bool temporary = false;
};

/// A place in the code that jumps can name before it is known.
struct Label {
  std::int32_t at = -1;
  std::vector<std::size_t> waiting{};
};

/// Puts the instructions of one function together: registers, jumps, and the count of block executions that
/// each straight piece carries in the instruction that ends it.
class FunctionBuilder {
 public:
  explicit FunctionBuilder(Function& out) : out_(out) {}

  void set_block(BlockIndex block) { block_ = block; }
  BlockIndex block() const { return block_; }

  /// A register of its own; a freed one of the same kind if there is one. A register never changes its kind.
  std::int32_t new_register(Kind kind);
  Operand temporary(Kind kind, Types types);
  void free(const Operand& operand);

  void executed(unsigned blocks) { pending_ += blocks; }
  std::size_t emit(Op op, std::int32_t a = 0, std::int32_t b = 0, std::int32_t c = 0);
  /// An instruction that ends a straight piece: takes the executions that have gathered.
  std::size_t emit_end(Op op, std::int32_t a = 0, std::int32_t b = 0, std::int32_t c = 0);
  void jump(Op op, Label& to, std::int32_t a = 0, std::int32_t b = 0);
  void bind(Label& label);
  /// Lets the last instruction write to `wanted` instead of the temporary that it wrote; false when it did
  /// not write it.
  bool retarget(const Operand& temporary, std::int32_t wanted);

  /// The place of argument i of a call that this function makes; settled by finish().
  std::int32_t outgoing(std::size_t i);
  void finish();

 private:
  static constexpr std::int32_t kOutgoing = 1 << 24;
  void flush_count();
  void shorten_ways_out();
  void settle(std::int32_t& operand) const;

  Function& out_;
  BlockIndex block_ = kNone;
  std::vector<Kind> kinds_{};
  std::vector<std::int32_t> free_[2];
  std::uint32_t outgoing_ = 0;
  unsigned pending_ = 0;
  bool label_here_ = false;
};

}  // namespace mirada::vm
