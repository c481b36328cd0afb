#include "server/outbox.h"

#include <utility>

namespace mirada::server {

bool Outbox::push_control(std::string text) {
  const bool fits = control_.size() < kMaxControlMessages && control_bytes_ + text.size() <= kMaxControlBytes;
  // One answer larger than the bound must still arrive.
  if (!fits && !control_.empty()) return false;
  control_bytes_ += text.size();
  control_.push_back(std::make_shared<const std::string>(std::move(text)));
  return true;
}

std::optional<Outbox::Item> Outbox::pop(bool control_only) {
  if (!control_.empty()) {
    SharedBytes text = std::move(control_.front());
    control_.pop_front();
    control_bytes_ -= text->size();
    return Item{std::move(text), false};
  }
  if (control_only) return std::nullopt;
  const bool picture = picture_ && (picture_next_ || !telemetry_);
  if (!picture && !telemetry_) return std::nullopt;
  picture_next_ = !picture;
  if (picture) return Item{std::exchange(picture_, nullptr), true};
  return Item{std::exchange(telemetry_, nullptr), false};
}

}  // namespace mirada::server
