#pragma once
#include <atomic>
#include <cstddef>
#include <optional>

#include "vm/value.h"

namespace mirada::vm {

std::size_t joined_bytes(const Text& a, const Text& b);
Value joined(Heap& heap, const Text& a, const Text& b);
/// The letter at a 0-based place (UTF-16 units); an empty text outside.
Value letter_of(Heap& heap, const Text& text, double place);
/// Whether `whole` holds `part`, in whatever case. Linear in their lengths. No answer when `give_up` has
/// become true meanwhile.
std::optional<bool> contains_text(const Text& whole, const Text& part, const std::atomic<bool>& give_up);

}  // namespace mirada::vm
