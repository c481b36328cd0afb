#include "model/percepts.h"

namespace mirada {

const char* to_string(Answer answer) {
  switch (answer) {
    case Answer::blocked:
      return "blocked";
    case Answer::clear:
      return "clear";
    case Answer::not_seen:
      return "not_seen";
    case Answer::above_horizon:
      return "above_horizon";
  }
  return "not_seen";
}

const char* to_string(Familiar familiar) {
  switch (familiar) {
    case Familiar::known:
      return "known";
    case Familiar::stranger:
      return "stranger";
    case Familiar::unsure:
      break;
  }
  return "unsure";
}

}  // namespace mirada
