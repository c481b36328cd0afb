#pragma once
#include <string>

#include "base/random.h"
#include "vm/native.h"

namespace mirada::vm {

enum class ThreadEnd { finished, killed, faulted };

/// What a program needs from whoever runs it. Called on the VM's thread.
class Host {
 public:
  virtual ~Host() = default;
  /// The program's clock.
  virtual Micros now() const = 0;
  virtual Random& random() = 0;
  /// `say` and `think`; "" clears the bubble.
  virtual void say(ThreadId thread, const std::string& block, const std::string& text) = 0;
  /// A script has ended; motion that it started must end too.
  virtual void thread_ended(ThreadId thread, ThreadEnd why) = 0;
};

}  // namespace mirada::vm
