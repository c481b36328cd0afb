#include "base/fault.h"

#include <algorithm>

namespace mirada {

bool has_errors(const Faults& faults) {
  return std::any_of(faults.begin(), faults.end(),
                     [](const Fault& f) { return f.severity == Severity::error; });
}

std::string to_text(const Faults& faults, Lang lang) {
  std::string out;
  for (const Fault& fault : faults) {
    if (!out.empty()) out += '\n';
    if (!fault.place.empty()) out += fault.place + ": ";
    out += fault.text(lang);
  }
  return out;
}

}  // namespace mirada
