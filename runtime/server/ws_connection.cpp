#include <chrono>
#include <string>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>

#include "server/connections.h"

namespace mirada::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

constexpr std::chrono::milliseconds kPingPeriod{500};
constexpr std::chrono::seconds kHandshakeTime{5};
constexpr std::chrono::seconds kHelloTime{5};
constexpr Micros kSilence = 10 * kSecond;          ///< a viewer that nothing comes from any more
constexpr Micros kCongested = 300 * kMillisecond;  ///< a ping unanswered for so long holds pictures back
/// Small, so that little stands between a picture and the next ping on a slow line.
constexpr int kSendBufferBytes = 32 << 10;
constexpr std::size_t kReadBytes = 16u << 10;
constexpr std::size_t kKeepBytes = 256u << 10;

/// One viewer's socket: reads whole messages for the hub, sends from its outbox, pings.
class WsConnection : public ViewerLink, public std::enable_shared_from_this<WsConnection> {
 public:
  WsConnection(asio::ip::tcp::socket socket, Switchboard& board, std::unique_ptr<ConnectionSlot> slot)
      : ws_(std::move(socket)), timer_(ws_.get_executor()), board_(board), slot_(std::move(slot)) {}

  void accept(http::request<http::string_body> handshake) {
    handshake_ = std::move(handshake);
    prepare();
    ws_.async_accept(handshake_, [self = shared_from_this()](beast::error_code error) {
      if (!error) self->begin();
    });
  }

  void send_control(std::string text) override {
    if (!outbox_.push_control(std::move(text))) return close(websocket::close_code::policy_error, "too slow");
    write_next();
  }
  void offer_telemetry(SharedBytes text) override {
    outbox_.offer_telemetry(std::move(text));
    write_next();
  }
  void offer_picture(SharedBytes bytes) override {
    outbox_.offer_picture(std::move(bytes));
    write_next();
  }

  void close(std::uint16_t code, const char* reason) override {
    if (closing_) return;
    closing_ = true;
    // Whoever does not even take the close frame is cut off.
    timer_.expires_after(std::chrono::seconds(2));
    timer_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (!error) self->cut();
    });
    ws_.async_close(websocket::close_reason(static_cast<websocket::close_code>(code), reason),
                    [self = shared_from_this()](beast::error_code) { self->cut(); });
  }

 private:
  void prepare() {
    beast::error_code ignored;
    auto& socket = beast::get_lowest_layer(ws_).socket();
    socket.set_option(asio::ip::tcp::no_delay(true), ignored);
    socket.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = kHandshakeTime;
    timeout.idle_timeout = websocket::stream_base::none();
    timeout.keep_alive_pings = false;
    ws_.set_option(timeout);
    ws_.auto_fragment(false);
    ws_.read_message_max(0);  // limits depend on what the viewer may send: see on_read
    ws_.text(true);
  }

  void begin() {
    handshake_ = {};
    beast::error_code error;
    const auto remote = beast::get_lowest_layer(ws_).socket().remote_endpoint(error);
    id_ = board_.hub.join(shared_from_this(), error || !remote.address().is_loopback());
    joined_ = true;
    heard_ = board_.clock.now();
    ws_.control_callback([this](websocket::frame_type, beast::string_view payload) { on_control(payload); });
    board_.wake();
    read();
    ping_later();
  }

  void read() {
    ws_.async_read_some(in_, kReadBytes, [self = shared_from_this()](beast::error_code error, std::size_t) {
      error ? self->cut() : self->on_read();
    });
  }

  void on_read() {
    if (ws_.got_binary()) return refuse_input(websocket::close_code::unknown_data, "text only");
    const std::size_t limit = greeted_ ? kMaxProgramMessageBytes : kMaxMessageBytes;
    if (in_.size() > limit) return refuse_input(websocket::close_code::too_big, "too large");
    if (ws_.is_message_done()) {
      heard_ = board_.clock.now();
      greeted_ = true;
      board_.hub.receive(id_, {static_cast<const char*>(in_.data().data()), in_.size()});
      in_.consume(in_.size());
      if (in_.capacity() > kKeepBytes) in_.shrink_to_fit();
    }
    if (!closing_) read();
  }

  void refuse_input(websocket::close_code code, const char* reason) {
    close(code, reason);
    in_ = {};
  }

  void on_control(beast::string_view payload) {
    heard_ = board_.clock.now();
    board_.hub.heard(id_);
    if (payload == beast::string_view(ping_payload_)) ping_sent_.reset();
    write_next();
  }

  void ping_later() {
    timer_.expires_after(kPingPeriod);
    timer_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (!error && !self->closing_) self->on_ping_time();
    });
  }

  void on_ping_time() {
    const Micros now = board_.clock.now();
    if (now - heard_ > kSilence) return cut();
    if (!pinging_) send_ping(now);
    ping_later();
  }

  void send_ping(Micros now) {
    // While one is unanswered the next carries the same number: the age of the oldest counts.
    if (!ping_sent_) {
      ping_sent_ = now;
      ping_payload_ = std::to_string(++pings_);
    }
    pinging_ = true;
    ws_.async_ping(websocket::ping_data(ping_payload_.c_str()),
                   [self = shared_from_this()](beast::error_code error) {
                     self->pinging_ = false;
                     if (error) self->cut();
                   });
  }

  bool congested() const { return ping_sent_ && board_.clock.now() - *ping_sent_ > kCongested; }

  void write_next() {
    if (writing_ || closing_ || !joined_) return;
    auto item = outbox_.pop(congested());
    if (!item) return;
    writing_ = true;
    current_ = std::move(*item);
    ws_.binary(current_.binary);
    ws_.async_write(asio::buffer(*current_.bytes),
                    [self = shared_from_this()](beast::error_code error, std::size_t) {
                      self->writing_ = false;
                      self->current_ = {};
                      error ? self->cut() : self->write_next();
                    });
  }

  /// Ends everything that is pending on the socket, and tells the hub once.
  void cut() {
    closing_ = true;
    beast::get_lowest_layer(ws_).close();
    timer_.cancel();
    if (!joined_) return;
    joined_ = false;
    // The hub may be in the middle of talking to all of its viewers.
    asio::post(ws_.get_executor(), [self = shared_from_this()] { self->board_.hub.leave(self->id_); });
  }

  websocket::stream<beast::tcp_stream> ws_;
  asio::steady_timer timer_;
  Switchboard& board_;
  std::unique_ptr<ConnectionSlot> slot_;
  http::request<http::string_body> handshake_;
  beast::flat_buffer in_;
  Outbox outbox_;
  Outbox::Item current_;
  Hub::ViewerId id_ = 0;
  bool joined_ = false;
  bool greeted_ = false;
  bool writing_ = false;
  bool closing_ = false;
  bool pinging_ = false;
  Micros heard_ = 0;
  std::optional<Micros> ping_sent_;
  std::string ping_payload_;
  std::uint64_t pings_ = 0;
};

}  // namespace

void serve_websocket(asio::ip::tcp::socket socket, http::request<http::string_body> handshake,
                     Switchboard& board, std::unique_ptr<ConnectionSlot> slot) {
  std::make_shared<WsConnection>(std::move(socket), board, std::move(slot))->accept(std::move(handshake));
}

}  // namespace mirada::server
