#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/message.h"
#include "server/static_files.h"
#include "session/station.h"

namespace mirada::server {

/// What counts of a request's header. The views live as long as the request.
struct HttpRequest {
  std::string_view method;
  std::string_view target;
  std::vector<std::string_view> hosts;            ///< every Host line
  std::optional<std::string_view> origin;         ///< nothing = the line is absent
  std::vector<std::string_view> content_lengths;  ///< every Content-Length line
  bool transfer_encoding = false;
  bool upgrade = false;  ///< a WebSocket handshake
  std::string_view accept_encoding;
  std::string_view if_none_match;

  std::string_view path() const { return target.substr(0, target.find('?')); }
};

struct HttpReply {
  unsigned status = 200;
  std::string type;
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
};

/// What the routes need; all of it outlives the server's threads.
struct RouterData {
  const session::Station& station;
  StaticFiles files;
  std::string packs_json;
  std::string examples_json;
  Lang lang = Lang::en;
  std::string machine_name;
};

/// Why this request must not go on: ambiguous length, missing or foreign Host, foreign Origin. Nothing = it
/// may.
std::optional<HttpReply> refuse(const HttpRequest& request, std::string_view local_address,
                                std::string_view machine_name);

bool is_stop(const HttpRequest& request);
bool is_check(const HttpRequest& request);
/// A Scratch file to be turned into a program of the editor's.
bool is_scratch(const HttpRequest& request);

/// The most bytes that the body of this request may have.
std::uint64_t body_limit(const HttpRequest& request);

/// Answers GET and HEAD, and what nobody answers. Reads files; takes no other time.
HttpReply answer(const HttpRequest& request, const RouterData& data);

/// A page, or JSON below /api/, that says what is wrong.
HttpReply refusal(unsigned status, const Message& message, std::string_view target,
                  const MessageArgs& args = {});

/// Sent with every answer: no foreign content, no guessing of types, no leaving of addresses.
const std::vector<std::pair<std::string_view, std::string_view>>& security_headers();

}  // namespace mirada::server
