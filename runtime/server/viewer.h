#pragma once
#include <memory>
#include <set>
#include <string>

#include "server/hub.h"

namespace mirada::server {

/// What the hub knows of one connection.
struct Hub::Viewer {
  static constexpr double kMessagesPerSecond = 50;
  static constexpr std::size_t kMaxJobs = 4;
  static constexpr std::size_t kCodeTries = 5;

  ViewerId id = 0;
  std::shared_ptr<ViewerLink> link;
  std::string name;    ///< public
  std::string client;  ///< secret; "" until hello
  bool may_drive = false;
  session::Wanted wanted;
  std::set<std::string> keys_down;
  TokenBucket bucket{kMessagesPerSecond, kMessagesPerSecond};
  TryLimit code_tries{kCodeTries, 60 * kSecond};
  TryLimit teacher_tries{kCodeTries, 60 * kSecond};
  std::size_t left_out = 0;  ///< messages over the rate, in a row
  std::size_t jobs = 0;

  bool greeted() const { return !client.empty(); }
};

}  // namespace mirada::server
