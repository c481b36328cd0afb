#pragma once
#include <string>
#include <vector>

#include "base/message.h"

namespace mirada {

enum class Severity { warning, error };

/// One thing that is wrong with something people sent or with the world. `place` says where: a block's id, a
/// path inside a file ("/camera/fx_px"), a file's name. Every fault of an input is reported at once.
struct Fault {
  std::string place;
  const Message* message;  ///< never null; points at a constexpr Message
  MessageArgs args;
  Severity severity = Severity::error;

  std::string_view code() const { return message->code; }
  std::string text(Lang lang) const { return format(*message, args, lang); }
};

using Faults = std::vector<Fault>;

inline Fault make_fault(std::string place, const Message& message, MessageArgs args = {},
                        Severity severity = Severity::error) {
  return Fault{std::move(place), &message, std::move(args), severity};
}

bool has_errors(const Faults& faults);

/// All faults as lines "place: sentence", for a terminal.
std::string to_text(const Faults& faults, Lang lang);

}  // namespace mirada
