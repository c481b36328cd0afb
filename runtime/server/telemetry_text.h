#pragma once
#include <string>

#include "session/station.h"

namespace mirada::server {

/// One moment of the session as the message `telemetry`, in parts that viewers with different panels share.
/// Written once a moment, not once a viewer.
class TelemetryText {
 public:
  explicit TelemetryText(const session::Telemetry& telemetry);

  /// The message for a viewer with these panels open; a panel that is closed, or has nothing yet, is null.
  /// `names`: who the faces are is told; it is for those who may drive.
  std::string assemble(const session::Wanted& panels, bool names) const;
  /// Everything but the time: equal means that nothing needs to be sent.
  bool same_content(const TelemetryText& other) const;

 private:
  std::string time_;
  std::string base_;
  std::string sonar_;
  std::string faces_;
  std::string nameless_faces_;
  bool lesson_ = false;  ///< goes on: shown whichever panels are open
  std::string scene_;
  std::string memory_;
};

/// A picture as the binary message: u32 length, JSON header, JPEG.
std::string picture_bytes(const session::Picture& picture);

}  // namespace mirada::server
