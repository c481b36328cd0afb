#include <chrono>
#include <optional>

#include <boost/asio/dispatch.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "server/api.h"
#include "server/connections.h"
#include "server/messages.h"

namespace mirada::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Parser = http::request_parser<http::string_body>;
using Response = http::response<http::string_body>;

constexpr std::chrono::seconds kHeaderTime{5};
constexpr std::chrono::seconds kStopOnlyTime{1};
constexpr std::chrono::seconds kBodyTime{20};
constexpr std::chrono::seconds kWriteTime{30};
constexpr std::chrono::seconds kLingerTime{5};
constexpr std::uint32_t kHeaderBytes = 8u << 10;
constexpr std::size_t kBufferBytes = 64u << 10;
constexpr std::size_t kLingerBytes = 256u << 20;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// Without an IPv6 zone; an IPv4 address that came in as IPv6 in its own form.
std::string address_text(const asio::ip::address& address) {
  if (address.is_v6() && address.to_v6().is_v4_mapped()) {
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string();
  }
  std::string text = address.to_string();
  return text.substr(0, text.find('%'));
}

HttpRequest header_of(const Parser& parser) {
  const auto& message = parser.get();
  HttpRequest request;
  request.method = view(message.method_string());
  request.target = view(message.target());
  for (const auto& field : message) {
    if (field.name() == http::field::host) request.hosts.push_back(view(field.value()));
    if (field.name() == http::field::content_length) request.content_lengths.push_back(view(field.value()));
    if (field.name() == http::field::transfer_encoding) request.transfer_encoding = true;
    if (field.name() == http::field::origin) request.origin = view(field.value());
  }
  request.upgrade = beast::websocket::is_upgrade(message);
  request.accept_encoding = view(message[http::field::accept_encoding]);
  request.if_none_match = view(message[http::field::if_none_match]);
  return request;
}

/// One connection: reads a header, refuses or answers, and waits for the next.
class HttpConnection : public IdleConnection, public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(asio::ip::tcp::socket socket, Switchboard& board, bool stop_only)
      : stream_(std::move(socket)),
        board_(board),
        slot_(std::make_unique<ConnectionSlot>(board)),
        stop_only_(stop_only),
        buffer_(kBufferBytes) {}
  ~HttpConnection() override { board_.idle.erase(this); }

  void read_header() {
    parser_.emplace();
    parser_->header_limit(kHeaderBytes);
    parser_->body_limit(boost::none);  // checked by hand, before anything is read
    stream_.expires_after(stop_only_ ? kStopOnlyTime : kHeaderTime);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                              self->board_.idle.erase(self.get());
                              self->on_header(error);
                            });
  }

  void make_room() override {
    slot_.reset();  // counts at once; the aborted read comes later
    close();
  }

 private:
  void on_header(beast::error_code error) {
    if (error == http::error::header_limit) return last(refusal(431, messages::header_too_large, ""));
    if (error && error.category() == http::make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message) {
      return last(refusal(400, messages::request_broken, ""));
    }
    if (error) return close();
    const HttpRequest request = header_of(*parser_);
    if (auto refused = refuse(request, local_address(), board_.router.machine_name))
      return last(std::move(*refused));
    if (is_stop(request)) return stop();
    if (stop_only_) return last(refusal(503, messages::server_full, request.target));
    const std::uint64_t limit = body_limit(request);
    if (parser_->content_length_remaining().value_or(0) > limit) {
      return last(refusal(413, messages::body_too_large, request.target,
                          {{"limit_kib", std::to_string(limit >> 10)}}));
    }
    if (request.upgrade) return upgrade(request);
    if (parser_->is_done()) return route(request);
    read_body();
  }

  /// Stop acts on the header alone: no body can delay it.
  void stop() {
    board_.hub.stop();
    const bool more = !parser_->is_done();
    HttpReply reply{204, "", "", {{"Cache-Control", "no-store"}}};
    more || stop_only_ ? last(std::move(reply)) : write(std::move(reply), keep_alive());
  }

  void upgrade(const HttpRequest& request) {
    if (request.path() != "/ws") return last(refusal(404, messages::page_missing, request.target));
    stream_.expires_never();
    serve_websocket(stream_.release_socket(), parser_->release(), board_, std::move(slot_));
  }

  void read_body() {
    stream_.expires_after(kBodyTime);
    if (beast::iequals(parser_->get()[http::field::expect], "100-continue")) return send_continue();
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       error ? self->close() : self->route(header_of(*self->parser_));
                     });
  }

  void send_continue() {
    static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    parser_->get().erase(http::field::expect);
    asio::async_write(stream_, asio::buffer(kContinue),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        error ? self->close() : self->read_body();
                      });
  }

  void route(const HttpRequest& request) {
    if (is_check(request)) return work(check_program);
    if (is_scratch(request)) return work(open_scratch);
    if (request.target.starts_with("/api/")) return write(answer(request, board_.router), keep_alive());
    in_background([request](Switchboard& board, const Parser&) { return answer(request, board.router); });
  }

  void work(std::string (*answer)(const std::string& body, const packs::PackSet& packs)) {
    in_background([answer](Switchboard& board, const Parser& parser) {
      return HttpReply{
          200, "application/json", answer(parser.get().body(), board.packs), {{"Cache-Control", "no-store"}}};
    });
  }

  /// Makes the reply off the io thread, which must be free for Stop: files and programs take their time. The
  /// connection is handed on, never shared with the other thread: it must end on this one.
  template <class Make>
  void in_background(Make make) {
    stream_.expires_never();
    board_.in_background([self = shared_from_this(), &board = board_, make]() mutable {
      HttpReply reply = make(board, *self->parser_);
      board.on_io([self = std::move(self), reply = std::move(reply)]() mutable {
        self->write(std::move(reply), self->keep_alive());
      });
    });
  }

  bool keep_alive() const { return parser_->get().keep_alive(); }

  /// The last answer on this connection.
  void last(HttpReply reply) { write(std::move(reply), false); }

  void write(HttpReply reply, bool keep_alive) {
    response_ = Response{};
    response_.version(11);
    response_.result(reply.status);
    if (!reply.type.empty()) response_.set(http::field::content_type, reply.type);
    for (const auto& [name, value] : security_headers()) response_.set(to_beast(name), to_beast(value));
    for (const auto& [name, value] : reply.headers) response_.set(name, value);
    response_.keep_alive(keep_alive);
    if (reply.status != 204 && reply.status != 304) response_.content_length(reply.body.size());
    if (parser_->get().method() != http::verb::head) response_.body() = std::move(reply.body);
    stream_.expires_after(kWriteTime);
    http::async_write(stream_, response_,
                      [self = shared_from_this(), keep_alive](beast::error_code error, std::size_t) {
                        if (error) return self->close();
                        keep_alive ? self->next() : self->linger();
                      });
  }

  static beast::string_view to_beast(std::string_view text) { return {text.data(), text.size()}; }

  void next() {
    board_.idle.insert(this);
    read_header();
  }

  /// Reads what the other side still sends for a while: closing at once would take the answer from it.
  void linger() {
    beast::error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    stream_.expires_after(kLingerTime);
    scrap_.resize(kBufferBytes);
    discard();
  }

  void discard() {
    stream_.async_read_some(asio::buffer(scrap_),
                            [self = shared_from_this()](beast::error_code error, std::size_t n) {
                              self->discarded_ += n;
                              error || self->discarded_ > kLingerBytes ? self->close() : self->discard();
                            });
  }

  std::string local_address() {
    beast::error_code error;
    const auto endpoint = stream_.socket().local_endpoint(error);
    return error ? "" : address_text(endpoint.address());
  }

  void close() { stream_.close(); }

  beast::tcp_stream stream_;
  Switchboard& board_;
  std::unique_ptr<ConnectionSlot> slot_;
  bool stop_only_;
  beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
  Response response_;
  std::string scrap_;
  std::size_t discarded_ = 0;
};

}  // namespace

void serve_http(asio::ip::tcp::socket socket, Switchboard& board, bool stop_only) {
  std::make_shared<HttpConnection>(std::move(socket), board, stop_only)->read_header();
}

}  // namespace mirada::server
