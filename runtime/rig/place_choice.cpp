#include "rig/place_choice.h"

namespace mirada::rig {

Result<std::optional<Place>> choose_place(const std::string& asked) {
  if (asked.empty()) return std::optional<Place>();
  Result<Place> place = place_by_name(asked);
  if (!place) return place.faults();
  return std::optional<Place>(std::move(*place));
}

}  // namespace mirada::rig
