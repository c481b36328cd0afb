#pragma once
#include <string>

#include "base/units.h"

namespace mirada::server {

/// Who drives. The first who takes it has it until they give it back or are not heard of for `kSilence`: a
/// reload of the page takes less. Clients are known by the secret id that their browser keeps. Not
/// thread-safe.
class OwnerLease {
 public:
  static constexpr Micros kSilence = 2 * kSecond;

  bool free() const { return client_.empty(); }
  bool held_by(const std::string& client) const { return !client.empty() && client_ == client; }
  const std::string& client() const { return client_; }

  /// True when `client` has the robot now (it was free, or theirs already).
  bool take(const std::string& client, Micros now);
  /// A sign of life of any client; only the owner's counts.
  void heard(const std::string& client, Micros now);
  /// Ends the lease when its owner was silent for too long: true once.
  bool expire(Micros now);
  void release() { client_.clear(); }

 private:
  std::string client_;  ///< "" = nobody
  Micros heard_ = 0;
};

}  // namespace mirada::server
