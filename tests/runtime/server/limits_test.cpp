#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "server/join_code.h"
#include "server/outbox.h"
#include "server/owner_lease.h"
#include "server/token_bucket.h"

namespace mirada::server {
namespace {

TEST(TokenBucket, lets_the_rate_through_and_no_more) {
  TokenBucket bucket(50, 50);
  int through = 0;
  for (int i = 0; i < 1000; ++i) through += bucket.take(0) ? 1 : 0;
  EXPECT_EQ(through, 50);
  for (Micros t = 0; t <= kSecond; t += kMillisecond) through += bucket.take(t) ? 1 : 0;
  EXPECT_EQ(through, 100);
}

TEST(OwnerLease, first_come_first_served) {
  OwnerLease lease;
  EXPECT_TRUE(lease.take("ann", 0));
  EXPECT_TRUE(lease.take("ann", 1));
  EXPECT_FALSE(lease.take("bob", 2));
  lease.release();
  EXPECT_TRUE(lease.take("bob", 3));
  EXPECT_FALSE(lease.held_by(""));
}

TEST(OwnerLease, ends_after_two_silent_seconds_and_once) {
  OwnerLease lease;
  lease.take("ann", 0);
  lease.heard("ann", kSecond);
  lease.heard("bob", 10 * kSecond);
  EXPECT_FALSE(lease.expire(3 * kSecond - 1));
  EXPECT_TRUE(lease.expire(3 * kSecond));
  EXPECT_FALSE(lease.expire(4 * kSecond));
  EXPECT_TRUE(lease.free());
}

TEST(JoinCode, is_six_plain_symbols_and_never_the_same) {
  std::set<std::string> codes;
  for (int i = 0; i < 200; ++i) {
    const std::string code = make_join_code();
    EXPECT_EQ(code.size(), 6u);
    EXPECT_EQ(code.find_first_of("01IO"), std::string::npos) << code;
    codes.insert(code);
  }
  EXPECT_GT(codes.size(), 198u);
}

TEST(JoinCode, forgives_how_it_is_typed_and_nothing_else) {
  EXPECT_TRUE(same_code("ab2-c3d", "AB2C3D"));
  EXPECT_TRUE(same_code(" AB2 C3D ", "AB2C3D"));
  for (const char* typed : {"", "AB2C3", "AB2C3DE", "AB2C3E", "XB2C3D"})
    EXPECT_FALSE(same_code(typed, "AB2C3D"));
  EXPECT_FALSE(same_code("", ""));
}

TEST(TryLimit, counts_within_its_window) {
  TryLimit limit(5, 60 * kSecond);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(limit.allows(i * kSecond));
    limit.count(i * kSecond);
  }
  EXPECT_FALSE(limit.allows(59 * kSecond));
  EXPECT_TRUE(limit.allows(60 * kSecond));
}

TEST(Outbox, keeps_control_in_order_and_before_all_else) {
  Outbox outbox;
  outbox.offer_picture(std::make_shared<const std::string>("picture"));
  outbox.offer_telemetry(std::make_shared<const std::string>("telemetry"));
  EXPECT_TRUE(outbox.push_control("one"));
  EXPECT_TRUE(outbox.push_control("two"));
  EXPECT_EQ(*outbox.pop(false)->bytes, "one");
  EXPECT_EQ(*outbox.pop(false)->bytes, "two");
  EXPECT_FALSE(outbox.pop(true));
  EXPECT_EQ(*outbox.pop(false)->bytes, "telemetry");
  EXPECT_TRUE(outbox.pop(false)->binary);
  EXPECT_FALSE(outbox.pop(false));
}

TEST(Outbox, only_the_newest_picture_waits) {
  Outbox outbox;
  for (int i = 0; i < 1000; ++i) outbox.offer_picture(std::make_shared<const std::string>(std::to_string(i)));
  EXPECT_EQ(*outbox.pop(false)->bytes, "999");
  EXPECT_FALSE(outbox.pop(false));
}

TEST(Outbox, telemetry_and_pictures_take_turns) {
  Outbox outbox;
  std::string order;
  for (int i = 0; i < 6; ++i) {
    outbox.offer_telemetry(std::make_shared<const std::string>("t"));
    outbox.offer_picture(std::make_shared<const std::string>("p"));
    order += *outbox.pop(false)->bytes;
  }
  EXPECT_EQ(order, "tptptp");
}

TEST(Outbox, says_when_a_viewer_takes_nothing) {
  Outbox many;
  std::size_t taken = 0;
  while (taken < 10'000 && many.push_control("{}")) ++taken;
  EXPECT_EQ(taken, Outbox::kMaxControlMessages);
  Outbox large;
  EXPECT_TRUE(large.push_control(std::string(2u << 20, 'x')));
  EXPECT_FALSE(large.push_control("{}"));
}

}  // namespace
}  // namespace mirada::server
