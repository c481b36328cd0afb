#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/fault.h"
#include "model/percepts.h"

namespace mirada {

/// One picture's see report (docs/schema/see.schema.json).
struct SeenPicture {
  std::string image;
  int frame = -1;  ///< of a video, from 0; -1: a single picture
  int width_px = 0;
  int height_px = 0;
  std::string robot;
  SonarPercept sonar;
  FacesPercept faces;
};

nlohmann::json see_report(const SeenPicture& seen);
/// What is said to people, one or two lines.
std::string see_words(const SeenPicture& seen, Lang lang);
/// The report of an input that cannot be looked at.
nlohmann::json fault_report(const Faults& faults);

}  // namespace mirada
