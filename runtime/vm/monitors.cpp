// What can be seen of a running program: values, running blocks, answers to clicks.
#include <algorithm>

#include "vm/digits.h"
#include "vm/machine_impl.h"
#include "vm/messages.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

constexpr std::size_t kMaxQuestions = 1'000;

MonitorValue shown(const Value& value, std::size_t letters) {
  MonitorValue out{.text = value.is_text() ? to_utf8(*value.text(), letters) : to_string(value)};
  out.is_number = value.is_number();
  out.number = to_number(value);
  if (value.is_number()) out.number = value.number();
  out.is_truth = value.is_truth();
  return out;
}

MonitorValue shown_number(double number, bool digits) {
  MonitorValue out = shown(Value(behind_digits(number)), SIZE_MAX);
  out.is_number = !digits && !is_digits(number);
  return out;
}

}  // namespace

std::map<std::string, MonitorValue> Machine::Impl::variables(MonitorRoom room) const {
  std::map<std::string, MonitorValue> out;
  for (const VariableInfo& info : code->variables) {
    if (!info.shown) continue;
    const auto place = static_cast<std::size_t>(info.place);
    const Slot& slot =
        info.own ? instances[static_cast<std::size_t>(info.sprite)]->slots[place] : globals[place];
    out[info.name] =
        info.kind == Kind::number ? shown_number(slot.n, info.digits) : shown(slot.v, room.letters);
  }
  return out;
}

std::map<std::string, std::vector<MonitorValue>> Machine::Impl::all_lists(MonitorRoom room) const {
  std::map<std::string, std::vector<MonitorValue>> out;
  for (std::size_t i = 0; i < code->lists.size(); ++i) {
    const List& list = lists[i];
    std::vector<MonitorValue>& items = out[code->lists[i].name];
    for (std::size_t k = 0; k < std::min(list.size(), room.items); ++k) {
      items.push_back(list.bare ? shown_number(list.numbers[k], list.digits)
                                : shown(list.values[k], room.letters));
    }
  }
  return out;
}

std::map<std::string, std::size_t> Machine::Impl::list_lengths() const {
  std::map<std::string, std::size_t> out;
  for (std::size_t i = 0; i < code->lists.size(); ++i) out[code->lists[i].name] = lists[i].size();
  return out;
}

std::shared_ptr<const std::vector<std::string>> Machine::Impl::running_blocks() const {
  constexpr int kMaxCalls = 32;
  std::vector<bool> seen(code->program.blocks.size(), false);
  const auto add = [&](BlockIndex block) {
    for (; block != kNone && !seen[static_cast<std::size_t>(block)];
         block = code->program.at(block).enclosing) {
      seen[static_cast<std::size_t>(block)] = true;
    }
  };
  for (const Thread* thread : threads) {
    if (thread->is_question || thread->state == ThreadState::done) continue;
    add(thread->here());
    int calls = 0;
    for (std::size_t i = thread->frames.size(); i-- > 1 && calls < kMaxCalls; ++calls) {
      const Function& caller = *thread->frames[i - 1].function;
      const auto place = static_cast<std::size_t>(thread->frames[i].back - caller.code.data());
      add(caller.block_of[place - 1]);
    }
  }
  if (running_ids && seen == running_seen) return running_ids;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i]) ids.push_back(code->program.blocks[i].id);
  }
  running_seen = std::move(seen);
  running_ids = std::make_shared<const std::vector<std::string>>(std::move(ids));
  return running_ids;
}

/// The function that answers one reporter's value: compiled when it is first asked for. Null: there is no
/// such reporter.
const Function* Machine::Impl::question(const std::string& block_id) {
  if (const auto it = questions.find(block_id); it != questions.end()) return it->second.get();
  const Program& program = code->program;
  const auto found = program.by_id.find(block_id);
  if (found == program.by_id.end() || questions.size() >= kMaxQuestions) return nullptr;
  const BlockDef* def = program.at(found->second).def;
  if (!def || (def->shape != Shape::reporter && def->shape != Shape::boolean)) return nullptr;
  CodeTables tables;
  Compiler compiler(program, code->runs, tables);
  compiler.compile_reporter(*code, found->second, global_kinds.size(),
                            code->natives.size() + question_natives.size());
  set_globals(tables.globals);
  for (NativeSite& site : tables.natives) question_natives.push_back(std::move(site));
  return questions.emplace(block_id, std::make_unique<Function>(std::move(tables.functions.back())))
      .first->second.get();
}

void Machine::Impl::evaluate(const std::string& block_id, std::uint64_t request) {
  const Function* function = question(block_id);
  if (!function) return refuse(request, make_fault(block_id, messages::no_such_reporter));
  const auto sprite = static_cast<std::size_t>(function->sprite);
  Thread& thread = *new_thread(*function, instances[sprite].get());
  thread.is_question = true;
  thread.is_answered = false;
  thread.request = request;
  thread.place = threads.size();
  threads.push_back(&thread);
  disturb();
}

void Machine::Impl::refuse(std::uint64_t request, Fault why) {
  Answer out;
  out.request = request;
  out.fault = std::move(why);
  answers.push_back(std::move(out));
}

void Machine::Impl::answer(Thread& thread, const Value& value) {
  if (!thread.is_question || thread.is_answered) return;
  Answer out;
  out.request = thread.request;
  out.ok = true;
  out.value = shown(value, MonitorRoom().letters);
  out.fault.message = &messages::no_such_reporter;
  answers.push_back(std::move(out));
  thread.is_answered = true;
}

void Machine::Impl::give_up(Thread& thread, const Message& why, MessageArgs args) {
  if (!thread.is_question || thread.is_answered) return;
  refuse(thread.request, make_fault(code->program.at(thread.here()).id, why, std::move(args)));
  thread.is_answered = true;
}

}  // namespace mirada::vm
