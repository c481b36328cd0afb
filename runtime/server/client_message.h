#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "session/station.h"

namespace mirada::server {

enum class ClientVerb {
  hello,
  run,
  stop,
  pause,
  key,
  evaluate,
  choose,
  put_back,
  watch,
  release,
  calibrate,
  faces
};

/// One message of docs/protocol.md from a client. Which fields mean something depends on the verb.
struct ClientMessage {
  ClientVerb verb = ClientVerb::stop;
  std::string client;  ///< hello: the secret id that survives a reload
  std::string code;    ///< hello: the join code, "" = none was typed
  std::string program;
  std::string block;
  std::uint64_t request = 0;
  std::string key;
  bool on = false;    ///< pause
  bool down = false;  ///< key
  std::optional<std::string> world, robot;
  std::optional<std::uint64_t> seed;
  session::Wanted wanted;
  session::CalibrationStep calibration;
  session::FacesStep faces;
};

/// What was sent, or all that is wrong with it.
struct ReadMessage {
  std::string type;           ///< as sent, cut to 40 bytes; "" when there is none
  std::uint64_t request = 0;  ///< of `evaluate`, to answer it with
  ClientMessage message;
  Faults faults;
};

constexpr std::size_t kMaxProgramBytes = 4u << 20;
/// A message that carries a program, and any other.
constexpr std::size_t kMaxProgramMessageBytes = kMaxProgramBytes + (64u << 10);
constexpr std::size_t kMaxMessageBytes = 64u << 10;

ReadMessage read_client_message(std::string_view text);

}  // namespace mirada::server
