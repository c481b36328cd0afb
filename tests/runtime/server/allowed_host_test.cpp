#include "server/allowed_host.h"

#include <gtest/gtest.h>

namespace mirada::server {
namespace {

TEST(AllowedHost, loopback_names_count_only_on_loopback) {
  for (const char* host : {"localhost", "localhost:8080", "LOCALHOST:1", "127.0.0.1:8080", "127.0.0.1"}) {
    EXPECT_TRUE(host_allowed(host, "127.0.0.1", "robot")) << host;
    EXPECT_FALSE(host_allowed(host, "192.168.1.7", "robot")) << host;
  }
  EXPECT_TRUE(host_allowed("[::1]:8080", "::1", "robot"));
  EXPECT_TRUE(host_allowed("[::1]", "::1", "robot"));
}

TEST(AllowedHost, the_address_and_the_names_of_the_machine_count) {
  for (const char* host :
       {"192.168.1.7:8080", "192.168.1.7", "robot:8080", "Robot.local:8080", "robot.local"}) {
    EXPECT_TRUE(host_allowed(host, "192.168.1.7", "robot")) << host;
  }
  EXPECT_FALSE(host_allowed(".local", "192.168.1.7", ""));
}

TEST(AllowedHost, foreign_and_broken_names_do_not_count) {
  for (const char* host : {"evil.example", "evil.example:8080", "127.0.0.1.evil.example", "127.evil.example",
                           "localhost.evil.example", "192.168.1.8", "", ":8080",
                           "localhost:", "localhost:80a", "localhost:999999", "[::1", "[::1]x", "[]",
                           "robot.local.evil.example", "localhost@evil.example", " localhost"}) {
    EXPECT_FALSE(host_allowed(host, "127.0.0.1", "robot")) << host;
  }
}

TEST(AllowedOrigin, only_the_host_itself_over_http) {
  EXPECT_TRUE(origin_allowed("http://localhost:8080", "localhost:8080"));
  EXPECT_TRUE(origin_allowed("http://LocalHost:8080", "localhost:8080"));
  EXPECT_TRUE(origin_allowed("http://robot.local", "robot.local:80"));
  for (const char* origin : {"null", "", "http://", "https://localhost:8080", "http://localhost",
                             "http://localhost:8081", "http://localhost:8080.evil.example",
                             "http://evil.example:8080", "localhost:8080", "http://localhost:8080/x"}) {
    EXPECT_FALSE(origin_allowed(origin, "localhost:8080")) << origin;
  }
}

}  // namespace
}  // namespace mirada::server
