#pragma once
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "fake_station.h"
#include "raw_client.h"
#include "server/server.h"

namespace mirada::server {

/// A server on a free port with a fake station behind it.
class ServerTest : public testing::Test {
 protected:
  void SetUp() override {
    ServerOptions options;
    options.port = 0;
    options.ui_folder = "/nowhere";
    auto opened = Server::open(options, station_, packs_, {}, clock_);
    ASSERT_TRUE(opened.ok());
    server_ = std::move(opened).value();
  }
  RawClient connect(int receive_buffer_bytes = 0) { return RawClient(server_->port(), receive_buffer_bytes); }
  /// Whether the server still answers.
  bool alive() { return RawClient::status(connect().ask("GET", "/api/setup")) == 200; }

  FakeStation station_;
  packs::PackSet packs_;
  ManualClock clock_;  ///< stands still: nobody is silent for too long on a slow machine
  std::unique_ptr<Server> server_;
};

}  // namespace mirada::server
