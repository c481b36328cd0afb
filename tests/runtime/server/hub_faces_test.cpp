#include "hub_fixture.h"

namespace mirada::server {
namespace {

TEST_F(HubTest, only_with_the_teachers_code_may_faces_be_learnt_and_without_it_no_longer) {
  const Client child = join("child");
  EXPECT_EQ(child->last("known_faces")["allowed"], false);
  say(child, {{"type", "faces"}, {"action", "allow"}, {"on", true}});
  EXPECT_EQ(child->last("refused")["faults"][0]["code"], "teacher_code_needed");
  say(child, {{"type", "faces"}, {"action", "allow"}, {"on", true}, {"code", "WRONG1"}});
  EXPECT_EQ(child->last("refused")["faults"][0]["code"], "code_wrong");
  EXPECT_TRUE(jobs_.empty());
  say(child, {{"type", "faces"}, {"action", "allow"}, {"on", true}, {"code", "teach1"}});
  do_jobs();
  hub_->tick();
  EXPECT_EQ(child->last("known_faces")["allowed"], true);
  say(child, {{"type", "faces"}, {"action", "allow"}, {"on", false}});
  do_jobs();
  hub_->tick();
  EXPECT_EQ(child->last("known_faces")["allowed"], false);
}

TEST_F(HubTest, known_faces_are_renamed_and_forgotten_and_shown_only_to_those_who_may_drive) {
  hub_ = make("SECRET");
  const Client watcher = join("watcher", true);
  const Client driver = join("driver");
  EXPECT_THAT(watcher->of("known_faces"), IsEmpty());
  say(watcher, {{"type", "faces"}, {"action", "forget_all"}});
  EXPECT_EQ(watcher->last("refused")["faults"][0]["code"], "code_needed");
  station_.forget_calls();
  say(driver, {{"type", "faces"}, {"action", "rename"}, {"name", "Ana"}, {"to", "Eva"}});
  say(driver, {{"type", "faces"}, {"action", "forget"}, {"name", "nobody"}});
  do_jobs();
  hub_->tick();
  EXPECT_THAT(station_.calls(), Contains("faces rename Ana"));
  EXPECT_EQ(driver->last("refused")["to"], "faces");
  EXPECT_THAT(watcher->of("known_faces"), IsEmpty());
}

}  // namespace
}  // namespace mirada::server
