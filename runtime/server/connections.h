#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "base/clock.h"
#include "packs/packs.h"
#include "server/http_router.h"
#include "server/hub.h"

namespace mirada::server {

/// A connection that waits for its next request and may be closed to make room for another.
class IdleConnection {
 public:
  virtual ~IdleConnection() = default;
  virtual void make_room() = 0;
};

/// What all connections of one server share. Everything on the io thread but the two wiring functions.
struct Switchboard {
  static constexpr std::size_t kMaxConnections = 64;
  /// Beyond the limit some more are taken that may only ask for Stop.
  static constexpr std::size_t kStopReserve = 8;

  Hub& hub;
  const Clock& clock;
  RouterData router;
  const packs::PackSet& packs;
  std::function<void(Job)> in_background;  ///< files and checks, on two threads
  std::function<void(Job)> on_io;          ///< from any thread
  std::function<void()> wake;              ///< the hub has become busy
  std::size_t open{0};
  std::set<IdleConnection*> idle{};
};

/// Counts one connection as long as it lives.
class ConnectionSlot {
 public:
  explicit ConnectionSlot(Switchboard& board) : board_(board) { ++board_.open; }
  ~ConnectionSlot() { --board_.open; }
  ConnectionSlot(const ConnectionSlot&) = delete;
  ConnectionSlot& operator=(const ConnectionSlot&) = delete;

 private:
  Switchboard& board_;
};

/// Serves HTTP on this socket until it closes. `stop_only`: one request, and only Stop is answered.
void serve_http(boost::asio::ip::tcp::socket socket, Switchboard& board, bool stop_only);

/// Goes on as a WebSocket; the handshake's request has been checked.
void serve_websocket(boost::asio::ip::tcp::socket socket,
                     boost::beast::http::request<boost::beast::http::string_body> handshake,
                     Switchboard& board, std::unique_ptr<ConnectionSlot> slot);

}  // namespace mirada::server
