#include "session/calibration.h"

namespace mirada::session {

const char* to_string(Calibration::Phase phase) {
  switch (phase) {
    case Calibration::Phase::off:
      return "off";
    case Calibration::Phase::looking:
      return "looking";
    case Calibration::Phase::working:
      return "working";
    case Calibration::Phase::ready:
      return "ready";
    case Calibration::Phase::poor:
      return "poor";
    case Calibration::Phase::saved:
      return "saved";
  }
  return "off";
}

}  // namespace mirada::session
