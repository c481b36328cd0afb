#include "session/run_hash.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mirada::session {
namespace {

/// The hash of a small run; `change` may spoil it.
template <class Change>
std::string hash_with(Change change) {
  RunHash hash;
  hash.tick(20'000, {1, 2, 0.5}, {0.1, 0}, {0.2, 0.2});
  Percepts percepts;
  percepts.sonar.frame = 1;
  percepts.sonar.readings = {{0.1, Answer::blocked, 0.5, 0.01}};
  change(hash, percepts);
  hash.percepts(percepts);
  hash.say(20'000, "hello");
  return hash.finish();
}

std::string plain() {
  return hash_with([](RunHash&, Percepts&) {});
}

TEST(RunHash, OfNothingIsSha256OfNothing) {
  EXPECT_EQ(RunHash().finish(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(RunHash, IsTheSameForTheSame) { EXPECT_EQ(plain(), plain()); }

TEST(RunHash, ChangesWithEachPart) {
  EXPECT_NE(plain(), hash_with([](RunHash& hash, Percepts&) { hash.tick(40'000, {}, {}, {}); }));
  EXPECT_NE(plain(), hash_with([](RunHash& hash, Percepts&) { hash.say(0, ""); }));
  EXPECT_NE(plain(), hash_with([](RunHash&, Percepts& seen) { seen.sonar.readings[0].distance_m += 0.001; }));
  EXPECT_NE(plain(),
            hash_with([](RunHash&, Percepts& seen) { seen.sonar.readings[0].answer = Answer::clear; }));
  EXPECT_NE(plain(), hash_with([](RunHash&, Percepts& seen) { seen.faces.frame = 3; }));
}

TEST(RunHash, DoesNotChangeBelowTheQuantum) {
  EXPECT_EQ(plain(), hash_with([](RunHash&, Percepts& seen) { seen.sonar.readings[0].distance_m += 1e-9; }));
}

TEST(RunHash, TakesAPerceptOnce) {
  EXPECT_EQ(plain(), hash_with([](RunHash& hash, Percepts& seen) { hash.percepts(seen); }));
}

TEST(RunHash, HoldsWhatIsNotSeen) {
  EXPECT_NE(plain(),
            hash_with([](RunHash&, Percepts& seen) { seen.sonar.readings[0].distance_m = std::nan(""); }));
}

}  // namespace
}  // namespace mirada::session
