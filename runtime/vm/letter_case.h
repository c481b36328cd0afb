#pragma once
#include <string>
#include <string_view>

namespace mirada::vm {

/// The lower-case form of one UTF-16 unit, for comparisons that ignore case. Units without one stay.
char16_t lower_case(char16_t unit);
/// Whether lower_case(unit) is all there is to it. Not so for the dotted capital I (it becomes two units),
/// the capital sigma (another letter at a word's end) and halves of capitals beyond the first 65,536 letters.
bool lowers_alone(char16_t unit);
/// A whole text as JavaScript's toLowerCase gives it.
std::u16string lower_case(std::u16string_view text);

}  // namespace mirada::vm
