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

}  // namespace mirada
