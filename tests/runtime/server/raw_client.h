#pragma once
#include <arpa/inet.h>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

namespace mirada::server {

/// A client that may misbehave: bytes out, bytes in, on loopback. Every wait ends after ten seconds at most.
class RawClient {
 public:
  struct Frame {
    int opcode = -1;  ///< -1 = the connection is gone
    std::string payload;

    /// The code of a close frame, else 0.
    int close_code() const {
      if (opcode != 8 || payload.size() < 2) return 0;
      return static_cast<unsigned char>(payload[0]) << 8 | static_cast<unsigned char>(payload[1]);
    }
  };

  explicit RawClient(std::uint16_t port, int receive_buffer_bytes = 0)
      : fd_(::socket(AF_INET, SOCK_STREAM, 0)), port_(port) {
    if (receive_buffer_bytes > 0) {
      ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes, sizeof receive_buffer_bytes);
    }
    timeval time{10, 0};
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
    ::setsockopt(fd_, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  RawClient(RawClient&& other) noexcept
      : fd_(std::exchange(other.fd_, -1)),
        port_(other.port_),
        connected_(other.connected_),
        in_(std::move(other.in_)) {}
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  RawClient& operator=(RawClient&&) = delete;
  ~RawClient() {
    if (fd_ >= 0) ::close(fd_);
  }

  bool connected() const { return connected_; }

  /// False when the other side is gone.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  void finish_sending() { ::shutdown(fd_, SHUT_WR); }

  /// All until the other side closes.
  std::string read_all() {
    while (more()) {
    }
    return std::exchange(in_, {});
  }
  /// Until the text ends with an HTTP header and `body` bytes after it.
  std::string read_header() {
    std::size_t end = in_.find("\r\n\r\n");
    while (end == std::string::npos && more()) end = in_.find("\r\n\r\n");
    if (end == std::string::npos) return std::exchange(in_, {});
    std::string header = in_.substr(0, end + 4);
    in_.erase(0, end + 4);
    return header;
  }
  std::string read_bytes(std::size_t n) {
    while (in_.size() < n && more()) {
    }
    std::string out = in_.substr(0, n);
    in_.erase(0, out.size());
    return out;
  }

  std::string host() const { return "localhost:" + std::to_string(port_); }
  /// One request; the whole answer, header and body.
  std::string ask(const std::string& method, const std::string& target, const std::string& more_headers = "",
                  const std::string& body = "") {
    send(method + " " + target + " HTTP/1.1\r\nHost: " + host() + "\r\n" + more_headers +
         (body.empty() ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n") + "\r\n" + body);
    std::string header = read_header();
    return header + read_bytes(content_length(header));
  }
  static std::size_t content_length(const std::string& header) {
    const std::size_t at = header.find("Content-Length: ");
    return at == std::string::npos ? 0 : std::stoul(header.substr(at + 16));
  }
  static int status(const std::string& answer) {
    return answer.size() < 12 ? 0 : std::stoi(answer.substr(9, 3));
  }

  /// The WebSocket handshake; true when the server agrees.
  bool upgrade(const std::string& origin = "") {
    const std::string from = origin.empty() ? "http://" + host() : origin;
    send("GET /ws HTTP/1.1\r\nHost: " + host() + "\r\nOrigin: " + from +
         "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    return status(read_header()) == 101;
  }
  bool hello(const std::string& name, const std::string& more = "") {
    return upgrade() && text(R"({"type":"hello","version":1,"client":"client-)" + name + "\"" + more + "}");
  }
  bool text(std::string_view payload) { return send(frame(1, payload)); }

  /// A client's frame; `first` is the first byte (FIN, reserved bits and opcode).
  static std::string frame(int opcode, std::string_view payload, bool fin = true, bool mask = true) {
    std::string out;
    out += static_cast<char>((fin ? 0x80 : 0) | opcode);
    const auto bit = static_cast<unsigned char>(mask ? 0x80 : 0);
    if (payload.size() < 126) {
      out += static_cast<char>(bit | payload.size());
    } else if (payload.size() < 65536) {
      out += static_cast<char>(bit | 126);
      for (int shift = 8; shift >= 0; shift -= 8) out += static_cast<char>(payload.size() >> shift);
    } else {
      out += static_cast<char>(bit | 127);
      for (int shift = 56; shift >= 0; shift -= 8) out += static_cast<char>(payload.size() >> shift);
    }
    if (mask) out += std::string(4, '\0');  // masked with zero: the payload as it is
    return out + std::string(payload);
  }

  /// The next frame as it comes.
  Frame read_frame() {
    const std::string head = read_bytes(2);
    if (head.size() < 2) return {};
    std::uint64_t size = static_cast<unsigned char>(head[1]) & 0x7f;
    if (size >= 126) {
      const std::string length = read_bytes(size == 126 ? 2 : 8);
      size = 0;
      for (const char c : length) size = size << 8 | static_cast<unsigned char>(c);
    }
    return {head[0] & 0x0f, read_bytes(size)};
  }
  /// The next that is neither ping nor pong; pings are answered.
  Frame next() {
    for (;;) {
      Frame got = read_frame();
      if (got.opcode == 9) send(frame(10, got.payload));
      if (got.opcode != 9 && got.opcode != 10) return got;
    }
  }
  /// The next text message of this type; null when the connection ends first.
  nlohmann::json wait_for(const std::string& type) {
    for (;;) {
      const Frame got = next();
      if (got.opcode < 0 || got.opcode == 8) return nullptr;
      if (got.opcode != 1) continue;
      nlohmann::json message = nlohmann::json::parse(got.payload);
      if (message["type"] == type) return message;
    }
  }
  /// The code with which the server closes; 0 when it cuts the line.
  int wait_for_close() {
    for (;;) {
      const Frame got = next();
      if (got.opcode < 0) return 0;
      if (got.opcode == 8) return got.close_code();
    }
  }

 private:
  bool more() {
    char chunk[65536];
    const ssize_t n = ::recv(fd_, chunk, sizeof chunk, 0);
    if (n <= 0) return false;
    in_.append(chunk, static_cast<std::size_t>(n));
    return true;
  }

  int fd_;
  std::uint16_t port_;
  bool connected_ = false;
  std::string in_;
};

}  // namespace mirada::server
