#pragma once

namespace mirada::vm {

/// The lower-case form of one UTF-16 unit, for comparisons that ignore case. Units without one stay.
char16_t lower_case(char16_t unit);

}  // namespace mirada::vm
