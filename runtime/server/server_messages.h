#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/fault.h"
#include "session/station.h"

namespace mirada::server {

// The texts that the server sends (docs/protocol.md). Bytes that are no UTF-8 become U+FFFD.

/// What everybody may know of who drives and who watches.
struct Seats {
  std::string owner;  ///< the public name of the viewer who drives, "" = nobody (or away for a moment)
  bool taken = false;
  std::size_t viewers = 0;
};

/// What a viewer learns about itself.
struct Seat {
  std::string you;  ///< public name
  bool you_drive = false;
  bool may_drive = true;  ///< no code is needed, or it was right
};

std::string faults_json(const Faults& faults);
std::string setup_json(const session::Setup& setup);
std::string options_json(const std::vector<session::Option>& options);

std::string welcome_text(const Seat& seat, const Seats& seats, const session::Station& station,
                         Micros robot_clock);
std::string owner_text(const Seat& seat, const Seats& seats);
std::string notice_text(const Message& message, Severity severity = Severity::warning,
                        const MessageArgs& args = {});
std::string started_text(std::uint64_t run, const Faults& warnings);
/// `to` is the type of the message that was refused.
std::string refused_text(std::string_view to, const Faults& faults);
std::string stopped_text();
std::string setup_text(const session::Setup& setup);
std::string value_text(std::uint64_t request, const Result<vm::MonitorValue>& answer);
std::string calibration_text(const session::Calibration& state);
std::string known_faces_text(const session::KnownFaces& faces);
std::string camera_words_text(const Fault& words);
std::string check_json(const Faults& faults);

}  // namespace mirada::server
