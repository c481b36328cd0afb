#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "vm/code.h"
#include "vm/host.h"
#include "vm/list.h"
#include "vm/native.h"

namespace mirada::vm {

/// One register: a bare number, or a value. Which of the two never changes during a function.
union Slot {
  double n;
  Value v;
  Slot() : n(0) {}
  ~Slot() {}
};
static_assert(sizeof(Slot) == 8);

/// One call in progress. The script itself is the first.
struct Frame {
  const Function* function = nullptr;
  const Instr* back = nullptr;  ///< where the caller goes on
  std::uint32_t base = 0;       ///< of its registers in the thread's stack
  std::int32_t depth = 0;       ///< how many C-blocks stood around the call
  std::int32_t warp_before = 0;
  std::int32_t up = 0;  ///< how far below its registers the caller's begin
};

/// The calls in progress of one script. Pushing onto a full one makes room; calls that must not take the time
/// ask first.
class FrameStack {
 public:
  bool full() const { return end_ == limit_; }
  bool empty() const { return end_ == begin_.get(); }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_.get()); }
  Frame& back() { return end_[-1]; }
  const Frame& back() const { return end_[-1]; }
  const Frame& operator[](std::size_t i) const { return begin_[i]; }
  const Frame* begin() const { return begin_.get(); }
  const Frame* end() const { return end_; }
  void push(const Frame& frame) { *end_++ = frame; }  ///< it must not be full
  void push_back(const Frame& frame) {
    if (full()) grow();
    push(frame);
  }
  void pop_back() { --end_; }

 private:
  void grow() {
    const std::size_t count = size();
    auto larger = std::make_unique<Frame[]>(2 * count + 4);
    std::copy(begin_.get(), end_, larger.get());
    begin_ = std::move(larger);
    end_ = begin_.get() + count;
    limit_ = begin_.get() + 2 * count + 4;
  }

  std::unique_ptr<Frame[]> begin_;
  Frame* end_ = nullptr;
  Frame* limit_ = nullptr;
};

/// What a sprite or one of its clones has of its own.
struct Instance {
  std::int32_t sprite = 0;
  bool is_clone = false;
  std::unique_ptr<Slot[]> slots;    ///< by VariableInfo::place
  std::vector<std::int32_t> lists;  ///< by own list of the sprite: index into the machine's lists
};

enum class ThreadState : std::uint8_t {
  ready,
  sleeping,  ///< until `wake`
  polling,   ///< wait until: looks again when something may have changed
  joining,   ///< until the scripts that it started have ended
  done
};

/// One run of one script.
struct Thread {
  std::uint64_t serial = 0;  ///< never used again; the ThreadId
  const Script* script = nullptr;
  ThreadState state = ThreadState::done;
  ThreadEnd end = ThreadEnd::finished;
  bool is_question = false;   ///< somebody clicked a reporter
  bool is_answered = false;   ///< a question that has its answer
  bool is_condition = false;  ///< an edge hat's, never in the list
  std::uint64_t request = 0;
  std::uint64_t visible_tick = 0;  ///< the tick in which it has done something visible
  const Instr* at = nullptr;       ///< where it goes on
  const Instr* shown = nullptr;    ///< in the innermost function: the block that it is at, for highlights
  std::int32_t warp = 0;           ///< how many "all at once" it is in
  Micros warp_since = 0;
  std::uint64_t turn_executions = 0;
  Micros wake = 0;
  std::uint64_t earliest_tick = 0;  ///< sleeping: not before this tick
  std::size_t place = 0;            ///< in the list of threads
  std::size_t pending = 0;          ///< scripts that it waits for and that are listed
  std::size_t active = 0;           ///< of those: neither ended nor dozing
  bool dozes = false;               ///< waits for others, and looks no sooner than in the next tick
  std::vector<std::pair<Thread*, std::uint64_t>> waiters;  ///< who waits for this one, with their serials
  std::unique_ptr<NativeState> native_state;
  Instance* instance = nullptr;

  FrameStack frames;
  std::unique_ptr<Slot[]> stack;
  std::uint32_t capacity = 0;

  Slot* frame() { return stack.get() + frames.back().base; }
  BlockIndex block_at(const Instr* instr) const;
  /// The block that it is at.
  BlockIndex here() const { return block_at(shown); }
};

}  // namespace mirada::vm
