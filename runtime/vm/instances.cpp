// Sprites of imported projects and their clones. A program of ours has one nameless sprite that is never
// cloned.
#include <algorithm>
#include <cmath>

#include "vm/machine_impl.h"

namespace mirada::vm {
namespace {

constexpr std::size_t kMaxClones = 300;  // Scratch's; further ones are not made

}  // namespace

void Machine::Impl::make_instances() {
  for (std::size_t sprite = 0; sprite < code->program.sprites.size(); ++sprite) {
    order.push_back(make_instance(static_cast<std::int32_t>(sprite), nullptr));
  }
}

/// A sprite as it is loaded, or (original given) a clone with that one's values.
Instance* Machine::Impl::make_instance(std::int32_t sprite, const Instance* original) {
  Instance& instance = *instances.emplace_back(std::make_unique<Instance>());
  instance.sprite = sprite;
  instance.is_clone = original != nullptr;
  const std::vector<OwnVariable>& own = code->own[static_cast<std::size_t>(sprite)].variables;
  instance.slots = std::make_unique<Slot[]>(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!original) {
      set_slot(instance.slots[i], own[i].initial);
    } else if (own[i].kind == Kind::number) {
      instance.slots[i].n = original->slots[i].n;
    } else {
      instance.slots[i].v = original->slots[i].v;
    }
  }
  const std::vector<std::int32_t>& own_lists = code->own[static_cast<std::size_t>(sprite)].lists;
  for (std::size_t i = 0; i < own_lists.size(); ++i) {
    if (!original) {
      instance.lists.push_back(own_lists[i]);
      continue;
    }
    List copy = lists[static_cast<std::size_t>(original->lists[i])];
    list_bytes += copy.size() * sizeof(double);
    if (spare_lists.empty()) {
      spare_lists.push_back(static_cast<std::int32_t>(lists.size()));
      lists.emplace_back();
      turn.lists = lists.data();
    }
    instance.lists.push_back(spare_lists.back());
    lists[static_cast<std::size_t>(spare_lists.back())] = std::move(copy);
    spare_lists.pop_back();
  }
  return &instance;
}

void Machine::Impl::clone(Thread& thread, const Value& name) {
  const std::string wanted = to_string(name);
  Instance* original = nullptr;
  if (wanted == "_myself_") original = thread.instance;
  for (std::size_t sprite = 0; !original && sprite < code->program.sprites.size(); ++sprite) {
    const Sprite& candidate = code->program.sprites[sprite];
    if (!candidate.is_stage && candidate.name == wanted) original = instances[sprite].get();
  }
  const std::size_t originals = code->program.sprites.size();
  if (!original || code->program.sprites[static_cast<std::size_t>(original->sprite)].is_stage) return;
  if (instances.size() >= originals + kMaxClones || out_of_memory()) return;
  Instance* copy = make_instance(original->sprite, original);
  order.insert(std::find(order.begin(), order.end(), original), copy);
  for (const Script& script : code->scripts) {
    if (script.kind == HatKind::clone && script.sprite == copy->sprite) start_thread(script, copy, false);
  }
}

/// Up for positive numbers; the stage stays below all.
void Machine::Impl::move_by_layers(Instance& instance, double layers) {
  const bool stage = code->program.sprites[static_cast<std::size_t>(instance.sprite)].is_stage;
  if (stage || std::isnan(layers)) return;
  const auto it = std::find(order.begin(), order.end(), &instance);
  const double top = static_cast<double>(order.size()) - 1;
  const double place = std::clamp(static_cast<double>(it - order.begin()) + layers, 1.0, top);
  order.erase(it);
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(place), &instance);
}

void Machine::Impl::delete_clone(Thread& thread) {
  Instance* gone = thread.instance;
  for (const Script& script : code->scripts) {
    const auto it = running.find({&script, gone});
    if (it == running.end()) continue;
    for (Thread* other : it->second) end_thread(*other, ThreadEnd::killed);
    running.erase(it);
  }
  forget(*gone);
  const auto it =
      std::find_if(instances.begin(), instances.end(), [&](const auto& i) { return i.get() == gone; });
  instances.erase(it);
}

/// Gives a clone's values and lists back.
void Machine::Impl::forget(Instance& gone) {
  std::erase(order, &gone);
  for (const std::int32_t list : gone.lists) {
    list_bytes -= std::min(list_bytes, lists[static_cast<std::size_t>(list)].size() * sizeof(double));
    lists[static_cast<std::size_t>(list)] = List();
    spare_lists.push_back(list);
  }
  const std::vector<OwnVariable>& own = code->own[static_cast<std::size_t>(gone.sprite)].variables;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].kind == Kind::value) gone.slots[i].v = Value();
  }
}

void Machine::Impl::delete_clones() {
  while (instances.size() > code->program.sprites.size()) {
    forget(*instances.back());
    instances.pop_back();
  }
}

}  // namespace mirada::vm
