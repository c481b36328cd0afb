#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace mirada::server {

/// Text or bytes shared by all viewers who get the same.
using SharedBytes = std::shared_ptr<const std::string>;

/// What waits to be sent to one viewer. Control messages keep their order and are never dropped: when they
/// would need more than the bound, push_control() says so and the connection has to be closed. Of telemetry
/// and pictures only the newest waits. Not thread-safe.
class Outbox {
 public:
  static constexpr std::size_t kMaxControlBytes = 1u << 20;
  static constexpr std::size_t kMaxControlMessages = 256;

  struct Item {
    SharedBytes bytes;
    bool binary = false;
  };

  /// False when the viewer takes nothing any more.
  bool push_control(std::string text);
  void offer_telemetry(SharedBytes text) { telemetry_ = std::move(text); }
  void offer_picture(SharedBytes bytes) { picture_ = std::move(bytes); }

  /// The next to send: control first, then telemetry and pictures in turn. `control_only` leaves the latter
  /// waiting (the line is congested).
  std::optional<Item> pop(bool control_only);

 private:
  std::deque<SharedBytes> control_;
  std::size_t control_bytes_ = 0;
  SharedBytes telemetry_;
  SharedBytes picture_;
  bool picture_next_ = false;
};

}  // namespace mirada::server
