// A tree walker with explicit frames, so that scripts can take turns: docs/scratch-rules.md, rules 13 to 22.
#include "fuzz/reference/evaluate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace mirada::vm::reference {
namespace {

constexpr int kMostSteps = 4'000;
constexpr std::size_t kMostItems = 500;
constexpr std::size_t kMostLetters = 4'000;

struct TooMuch {};

using Params = std::vector<Value>;

/// A list of blocks that is being gone through; that of a loop also says which.
struct Frame {
  const std::vector<Node>* blocks = nullptr;
  std::size_t at = 0;
  bool warp = false;
  bool is_call = false;
  const Node* loop = nullptr;
  bool looks_next = false;  ///< of a loop: its turn is over, next it looks whether it goes on
  double count = 0;
  std::shared_ptr<const Params> params{};
};

struct Thread {
  const Script* script = nullptr;
  std::vector<Frame> frames{};
  std::vector<std::shared_ptr<Thread>> waits_for{};
  bool dozes = false;  ///< waits for others, and looks again in the next tick only
  int dozes_since = 0;
  Value returned = std::string();
};
using Threads = std::vector<std::shared_ptr<Thread>>;

double rounded(double x) {
  if (!std::isfinite(x)) return x;
  const double down = std::floor(x);
  const double out = x - down >= 0.5 ? down + 1 : down;
  return out == 0 ? std::copysign(0.0, x) : out;
}

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

class Evaluator {
 public:
  explicit Evaluator(const Tree& tree) : tree_(tree), variables_(kVariables, Value(0.0)), lists_(kLists) {}

  Outcome run() {
    for (const Script& script : tree_.scripts) {
      if (script.message < 0) start(script);
    }
    while (!threads_.empty()) {
      // Scripts that start in this round run in it, too.
      for (std::size_t i = 0; i < threads_.size(); ++i) {
        step();
        const std::shared_ptr<Thread> thread = threads_[i];
        if (!is_waiting(*thread)) turn(*thread);
      }
      std::erase_if(threads_, [](const auto& thread) { return thread->frames.empty(); });
      if (std::all_of(threads_.begin(), threads_.end(), [](const auto& thread) { return thread->dozes; }))
        ++tick_;
    }
    return {variables_, lists_};
  }

 private:
  void step() {
    if (++steps_ > kMostSteps) throw TooMuch();
  }

  std::shared_ptr<Thread> start(const Script& script) {
    auto fresh = std::make_shared<Thread>();
    fresh->script = &script;
    fresh->frames.push_back({.blocks = &script.body});
    for (std::shared_ptr<Thread>& old : threads_) {
      if (old->script != &script) continue;
      old = fresh;
      return fresh;
    }
    threads_.push_back(fresh);
    return fresh;
  }

  bool is_listed(const std::shared_ptr<Thread>& thread) const {
    return std::find(threads_.begin(), threads_.end(), thread) != threads_.end();
  }

  /// Broadcast and wait: nobody in the list, it goes on; nobody who does anything, it looks in the next tick.
  bool is_waiting(Thread& thread) {
    if (thread.dozes && thread.dozes_since == tick_) return true;
    const auto& others = thread.waits_for;
    const bool waiting =
        std::any_of(others.begin(), others.end(), [&](const auto& other) { return is_listed(other); });
    thread.dozes = waiting && std::none_of(others.begin(), others.end(), [&](const auto& other) {
                     return is_listed(other) && !other->frames.empty() && !other->dozes;
                   });
    thread.dozes_since = tick_;
    if (!waiting) thread.waits_for.clear();
    return waiting;
  }

  /// Runs until the script lets others run, or ends.
  void turn(Thread& thread) {
    while (!thread.frames.empty()) {
      step();
      Frame& top = thread.frames.back();
      if (top.at < top.blocks->size()) {
        const Node& node = (*top.blocks)[top.at++];
        if (statement(thread, node)) return;
      } else if (top.loop) {
        // The end of a loop's turn: others run, then it looks whether it goes on.
        if (!top.warp && !std::exchange(top.looks_next, true)) return;
        top.looks_next = false;
        look_again(thread);
      } else {
        thread.frames.pop_back();
      }
    }
  }

  /// Whether a loop goes round once more; its frame ends when it does not.
  void look_again(Thread& thread) {
    const std::size_t depth = thread.frames.size();
    const Node& loop = *thread.frames.back().loop;
    const bool goes_on = turns(thread.frames.back(), loop);
    Frame& frame = thread.frames[depth - 1];
    frame.at = 0;
    if (!goes_on) thread.frames.pop_back();
  }

  bool turns(Frame& frame, const Node& loop) {
    if (loop.opcode == "control_repeat") return --frame.count >= 0;
    if (loop.opcode == "control_repeat_until") return !to_truth(value(loop.inputs[0], frame));
    if (loop.opcode == "control_while") return to_truth(value(loop.inputs[0], frame));
    const bool over_list = loop.opcode == "data_for_each_item";
    std::vector<Value>* list = over_list ? &lists_[static_cast<std::size_t>(std::stoi(loop.text))] : nullptr;
    const double limit =
        over_list ? static_cast<double>(list->size()) : to_number(value(loop.inputs[0], frame));
    if (!(frame.count < limit)) return false;
    frame.count += 1;
    variables_[static_cast<std::size_t>(loop.name)] =
        over_list ? (*list)[static_cast<std::size_t>(frame.count) - 1] : Value(frame.count);
    return true;
  }

  void enter(Thread& thread, const std::vector<Node>& blocks, bool warp = false) {
    const Frame& around = thread.frames.back();
    thread.frames.push_back({.blocks = &blocks, .warp = around.warp || warp, .params = around.params});
  }

  void leave_block(Thread& thread) {
    while (!thread.frames.empty()) {
      const bool call = thread.frames.back().is_call;
      thread.frames.pop_back();
      if (call) return;
    }
  }

  void call(Thread& thread, const Node& node) {
    const MyBlock& block = tree_.blocks[static_cast<std::size_t>(node.name)];
    auto params = std::make_shared<Params>();
    const Frame around = thread.frames.back();
    for (std::size_t i = 0; i < block.params.size(); ++i) {
      const Value given = value(node.inputs[i], around);
      params->push_back(block.params[i] == 'n'   ? Value(to_number(given))
                        : block.params[i] == 'b' ? Value(to_truth(given))
                                                 : given);
    }
    thread.frames.push_back(
        {.blocks = &block.body, .warp = around.warp || block.warp, .is_call = true, .params = params});
  }

  /// One statement. True: the script's turn is over.
  bool statement(Thread& thread, const Node& node) {
    const std::string& op = node.opcode;
    Frame& frame = thread.frames.back();
    if (op == "control_if" || op == "control_if_else") {
      enter(thread, to_truth(value(node.inputs[0], frame)) ? node.first : node.second);
    } else if (op == "control_all_at_once") {
      enter(thread, node.first, true);
    } else if (op.starts_with("control_") && op != "control_stop") {
      loop(thread, node);
    } else if (op == "data_for_each_item") {
      loop(thread, node);
    } else if (op == "control_stop") {
      leave_block(thread);
    } else if (op == "procedures_return") {
      thread.returned = value(node.inputs[0], frame);
      leave_block(thread);
    } else if (op == "procedures_call") {
      call(thread, node);
    } else if (op.starts_with("event_")) {
      return broadcast(thread, node);
    } else {
      data(frame, node);
    }
    return false;
  }

  void loop(Thread& thread, const Node& node) {
    const double count =
        node.opcode == "control_repeat" ? rounded(to_number(value(node.inputs[0], thread.frames.back()))) : 0;
    enter(thread, node.first);
    thread.frames.back().loop = &node;
    thread.frames.back().count = count;
    look_again(thread);
  }

  bool broadcast(Thread& thread, const Node& node) {
    std::vector<std::shared_ptr<Thread>> started;
    for (const Script& script : tree_.scripts) {
      if (script.message == node.name) started.push_back(start(script));
    }
    if (node.opcode == "event_broadcast" || started.empty()) return false;
    thread.waits_for = std::move(started);
    return true;
  }

  void data(const Frame& frame, const Node& node) {
    const std::string& op = node.opcode;
    const auto which = static_cast<std::size_t>(node.name);
    if (op == "data_setvariableto") {
      const Value fresh = value(node.inputs[0], frame);
      variables_[which] = fresh;
    } else if (op == "data_changevariableby") {
      const double by = to_number(value(node.inputs[0], frame));
      variables_[which] = to_number(variables_[which]) + by;
    } else {
      change_list(frame, node);
    }
  }

  void change_list(const Frame& frame, const Node& node) {
    const std::string& op = node.opcode;
    std::vector<Value>& list = lists_[static_cast<std::size_t>(node.name)];
    if (op == "data_deletealloflist") return list.clear();
    const Value first = value(node.inputs[0], frame);
    if (op == "data_addtolist") return grow(list, list.size(), first);
    if (op == "data_deleteoflist") {
      if (first == Value(std::string("all"))) return list.clear();
      const std::size_t place = place_in(first, list.size());
      if (place > 0) list.erase(list.begin() + static_cast<std::ptrdiff_t>(place) - 1);
      return;
    }
    const Value item = value(node.inputs[1], frame);
    const bool insert = op == "data_insertatlist";
    const std::size_t place = place_in(first, list.size() + (insert ? 1 : 0));
    if (place == 0) return;
    insert ? grow(list, place - 1, item) : void(list[place - 1] = item);
  }

  static void grow(std::vector<Value>& list, std::size_t at, const Value& item) {
    if (list.size() >= kMostItems) throw TooMuch();
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), item);
  }

  /// 1-based; 0 where there is none.
  static std::size_t place_in(const Value& index, std::size_t length) {
    if (index == Value(std::string("last"))) return length;
    const double place = std::floor(to_number(index));
    return place >= 1 && place <= static_cast<double>(length) ? static_cast<std::size_t>(place) : 0;
  }

  Value value(const Node& node, const Frame& frame) {
    step();
    const std::string& op = node.opcode;
    if (op == "text") return node.text;
    if (op == "number") return node.number;
    if (op == "param") return (*frame.params)[static_cast<std::size_t>(node.name)];
    if (op == "data_variable") return variables_[static_cast<std::size_t>(node.name)];
    if (op == "procedures_call_value") return called(node, frame);
    std::vector<Value> in;
    for (const Node& input : node.inputs) in.push_back(value(input, frame));
    return op.starts_with("data_") ? list_value(node, in) : operation(node, in);
  }

  /// A my-block that gives a value never yields: it runs to its end here.
  Value called(const Node& node, const Frame& frame) {
    Thread inner;
    inner.frames.push_back(frame);
    inner.frames.back().loop = nullptr;
    inner.frames.back().is_call = true;
    static const std::vector<Node> kNothing;
    inner.frames.back().blocks = &kNothing;
    inner.frames.back().at = 0;
    call(inner, node);
    turn(inner);
    return inner.returned;
  }

  Value list_value(const Node& node, const std::vector<Value>& in) {
    const std::vector<Value>& list = lists_[static_cast<std::size_t>(node.name)];
    const std::string& op = node.opcode;
    if (op == "data_lengthoflist") return static_cast<double>(list.size());
    if (op == "data_listcontents") return contents(list);
    if (op == "data_itemoflist") {
      const std::size_t place = place_in(in[0], list.size());
      return place > 0 ? list[place - 1] : Value(std::string());
    }
    std::size_t i = 0;
    while (i < list.size() && compare(list[i], in[0]) != 0) ++i;
    if (op == "data_listcontainsitem") return i < list.size();
    return i < list.size() ? static_cast<double>(i + 1) : 0.0;
  }

  static Value contents(const std::vector<Value>& list) {
    const bool letters = std::all_of(list.begin(), list.end(), [](const Value& item) {
      const auto* text = std::get_if<std::string>(&item);
      return text && text->size() == 1;
    });
    std::string out;
    for (std::size_t i = 0; i < list.size(); ++i) out += (i > 0 && !letters ? " " : "") + to_text(list[i]);
    if (out.size() > kMostLetters) throw TooMuch();
    return out;
  }

  static Value operation(const Node& node, const std::vector<Value>& in) {
    const std::string op = node.opcode.substr(std::string("operator_").size());
    if (op == "and") return to_truth(in[0]) && to_truth(in[1]);
    if (op == "or") return to_truth(in[0]) || to_truth(in[1]);
    if (op == "not") return !to_truth(in[0]);
    if (op == "lt") return compare(in[0], in[1]) < 0;
    if (op == "gt") return compare(in[0], in[1]) > 0;
    if (op == "equals") return compare(in[0], in[1]) == 0;
    if (op == "length") return static_cast<double>(to_text(in[0]).size());
    if (op == "contains") return lowered(to_text(in[0])).find(lowered(to_text(in[1]))) != std::string::npos;
    if (op == "join") {
      std::string out = to_text(in[0]) + to_text(in[1]);
      if (out.size() > kMostLetters) throw TooMuch();
      return out;
    }
    if (op == "letter_of") {
      const std::string text = to_text(in[1]);
      const double at = to_number(in[0]) - 1;
      const bool there = at >= 0 && at < static_cast<double>(text.size());
      return there ? text.substr(static_cast<std::size_t>(at), 1) : std::string();
    }
    return arithmetic(op, node.text, to_number(in[0]), in.size() > 1 ? to_number(in[1]) : 0);
  }

  static double arithmetic(const std::string& op, const std::string& function, double a, double b) {
    if (op == "add") return a + b;
    if (op == "subtract") return a - b;
    if (op == "multiply") return a * b;
    if (op == "divide") return a / b;
    if (op == "round") return rounded(a);
    if (op == "mod") {
      const double r = std::fmod(a, b);
      return r / b < 0 ? r + b : r;
    }
    if (function == "abs") return std::fabs(a);
    if (function == "floor") return std::floor(a);
    return function == "ceiling" ? std::ceil(a) : std::sqrt(a);
  }

  const Tree& tree_;
  std::vector<Value> variables_;
  std::vector<std::vector<Value>> lists_;
  Threads threads_;
  int steps_ = 0;
  int tick_ = 0;
};

}  // namespace

std::optional<Outcome> evaluate(const Tree& tree) {
  try {
    return Evaluator(tree).run();
  } catch (const TooMuch&) {
    return std::nullopt;
  }
}

}  // namespace mirada::vm::reference
