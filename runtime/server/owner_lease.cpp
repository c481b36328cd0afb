#include "server/owner_lease.h"

#include <algorithm>

namespace mirada::server {

bool OwnerLease::take(const std::string& client, Micros now) {
  if (client.empty() || (!free() && client_ != client)) return false;
  client_ = client;
  heard_ = now;
  return true;
}

void OwnerLease::heard(const std::string& client, Micros now) {
  if (held_by(client)) heard_ = std::max(heard_, now);
}

bool OwnerLease::expire(Micros now) {
  if (free() || now - heard_ < kSilence) return false;
  release();
  return true;
}

}  // namespace mirada::server
