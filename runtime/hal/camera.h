#pragma once
#include <optional>

#include "base/result.h"
#include "model/frame.h"

namespace mirada::hal {

/// Where pictures come from. One thread calls poll(); no call blocks longer than one picture takes to copy.
class Camera {
 public:
  virtual ~Camera() = default;
  /// The newest picture that poll() has not given yet, or nothing. Older unread pictures are dropped.
  virtual std::optional<Frame> poll() = 0;
  /// Whether pictures can still come; says in words what is wrong otherwise. A camera that was pulled out and
  /// put back heals by itself.
  virtual Status health() const = 0;
  /// Pictures are wanted (or not): a camera that nobody looks through costs nothing. Opening leaves it off.
  virtual void enable(bool on) = 0;
};

}  // namespace mirada::hal
