#include "hub_fixture.h"

namespace mirada::server {
namespace {

TEST_F(HubTest, hello_is_answered_with_all_a_client_needs) {
  const Client ann = join("ann");
  const json welcome = ann->last("welcome");
  EXPECT_EQ(welcome["version"], 1);
  EXPECT_EQ(welcome["setup"], (json{{"world", "room1"}, {"robot", "bot"}, {"seed", 1}, {"simulated", true}}));
  EXPECT_EQ(welcome["worlds"][0]["name"]["es"], "Sala 1");
  EXPECT_EQ(welcome["owner"], nullptr);
  EXPECT_EQ(welcome["you_drive"], false);
  EXPECT_EQ(welcome["may_drive"], true);
  EXPECT_EQ(ann->telemetry.back()["state"], "idle");
  EXPECT_EQ(ann->last("owner")["viewers"], 1);
}

TEST_F(HubTest, the_secret_of_a_client_reaches_nobody) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  run(ann);
  for (const json& message : bob->control) EXPECT_EQ(message.dump().find("client-"), std::string::npos);
  for (const json& message : ann->control) EXPECT_EQ(message.dump().find("client-"), std::string::npos);
}

TEST_F(HubTest, the_first_to_run_owns_the_robot_and_the_others_watch) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  run(ann);
  EXPECT_EQ(ann->last("started")["run"], 1);
  EXPECT_EQ(ann->last("owner")["you_drive"], true);
  EXPECT_EQ(bob->last("owner")["you_drive"], false);
  EXPECT_EQ(bob->last("owner")["owner"], ann->last("welcome")["you"]);
  station_.forget_calls();
  run(bob);
  EXPECT_EQ(code_of(bob->last("refused")), "robot_taken");
  EXPECT_EQ(bob->last("refused")["to"], "run");
  for (const char* verb : {"pause", "key", "choose", "put_back"}) {
    say(bob, {{"type", verb}, {"key", "a"}});
    EXPECT_EQ(bob->last("refused")["to"], verb);
  }
  do_jobs();
  EXPECT_THAT(station_.calls(), IsEmpty());
}

TEST_F(HubTest, a_program_with_faults_is_refused_with_them) {
  const Client ann = join("ann");
  say(ann, {{"type", "run"}, {"program", "bad"}});
  do_jobs();
  EXPECT_EQ(ann->last("refused")["faults"][0]["place"], "block-1");
}

TEST_F(HubTest, anyone_may_stop_before_hello_too) {
  const Client ann = join("ann");
  run(ann);
  Client stranger;
  stranger.id = hub_->join(stranger.link, true);
  say(stranger, {{"type", "stop"}});
  EXPECT_THAT(station_.calls(), Contains("stop stop_button"));
  EXPECT_EQ(stranger->of("stopped").size(), 1u);
  EXPECT_EQ(ann->of("stopped").size(), 1u);
  EXPECT_EQ(stranger->closed, 0);
}

TEST_F(HubTest, stop_is_done_while_the_background_is_busy_and_voids_the_start) {
  const Client ann = join("ann");
  say(ann, {{"type", "run"}, {"program", "p"}});
  say(ann, {{"type", "stop"}});
  EXPECT_EQ(station_.stops, 1);
  do_jobs();
  EXPECT_THAT(station_.calls(), testing::Not(Contains("start \"p\"")));
  EXPECT_EQ(code_of(ann->last("refused")), "start_stopped");
}

TEST_F(HubTest, stop_while_a_program_is_compiled_stops_it_when_it_would_run) {
  const Client ann = join("ann");
  station_.on_start = [&] { hub_->stop(); };
  run(ann);
  EXPECT_EQ(station_.telemetry()->state, session::RunState::idle);
  EXPECT_EQ(code_of(ann->last("refused")), "start_stopped");
  EXPECT_TRUE(ann->of("started").empty());
}

TEST_F(HubTest, a_silent_owner_loses_the_robot_after_two_seconds) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  run(ann);
  clock_.advance(kSecond);
  hub_->heard(ann.id);
  clock_.advance(2 * kSecond - 1);
  hub_->heard(bob.id);
  hub_->tick();
  EXPECT_EQ(station_.stops, 0);
  clock_.advance(1);
  hub_->tick();
  EXPECT_THAT(station_.calls(), Contains("stop owner_lost"));
  EXPECT_EQ(bob->last("notice")["code"], "owner_gone");
  EXPECT_EQ(bob->last("owner")["taken"], false);
  run(bob);
  EXPECT_EQ(bob->last("owner")["you_drive"], true);
}

TEST_F(HubTest, a_reload_keeps_the_robot) {
  Client ann = join("ann");
  const Client bob = join("bob");
  run(ann);
  hub_->leave(ann.id);
  EXPECT_EQ(bob->last("owner")["owner"], nullptr);
  EXPECT_EQ(bob->last("owner")["taken"], true);
  clock_.advance(1900 * kMillisecond);
  hub_->tick();
  ann = join("ann");
  EXPECT_EQ(ann->last("welcome")["you_drive"], true);
  clock_.advance(1900 * kMillisecond);
  hub_->tick();
  EXPECT_EQ(station_.stops, 0);
}

TEST_F(HubTest, an_owner_who_closes_loses_the_robot_even_when_nobody_is_left) {
  const Client ann = join("ann");
  run(ann);
  hub_->leave(ann.id);
  EXPECT_TRUE(hub_->busy());
  clock_.advance(2 * kSecond);
  hub_->tick();
  EXPECT_THAT(station_.calls(), Contains("stop owner_lost"));
  EXPECT_FALSE(hub_->busy());
}

TEST_F(HubTest, release_stops_and_frees) {
  const Client ann = join("ann");
  run(ann);
  say(ann, {{"type", "release"}});
  EXPECT_EQ(station_.stops, 1);
  EXPECT_EQ(ann->last("owner")["taken"], false);
}

TEST_F(HubTest, keys_go_up_when_their_owner_goes) {
  const Client ann = join("ann");
  run(ann);
  say(ann, {{"type", "key"}, {"key", "up arrow"}, {"down", true}});
  hub_->leave(ann.id);
  EXPECT_THAT(station_.calls(), Contains("key up arrow up"));
}

TEST_F(HubTest, too_many_messages_are_left_out_but_never_stop_and_never_a_key_going_up) {
  const Client ann = join("ann");
  run(ann);
  say(ann, {{"type", "key"}, {"key", "a"}, {"down", true}});
  station_.forget_calls();
  for (int i = 0; i < 200; ++i) say(ann, {{"type", "pause"}, {"on", true}});
  EXPECT_LE(station_.calls().size(), 50u);
  EXPECT_EQ(ann->of("notice").size(), 1u);
  station_.forget_calls();
  say(ann, {{"type", "key"}, {"key", "a"}, {"down", false}});
  say(ann, {{"type", "stop"}});
  EXPECT_THAT(station_.calls(), ElementsAre("key a up", "stop stop_button"));
  for (int i = 0; i < 2000; ++i) say(ann, {{"type", "pause"}});
  EXPECT_EQ(ann->closed, 1008);
}

TEST_F(HubTest, a_flood_of_stops_stops_and_does_not_flood_the_others) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  for (int i = 0; i < 500; ++i) say(ann, {{"type", "stop"}});
  EXPECT_EQ(station_.stops, 500);
  EXPECT_EQ(ann->of("stopped").size(), 500u);
  EXPECT_EQ(bob->of("stopped").size(), 20u);
}

TEST_F(HubTest, want_is_what_somebody_watches_and_nothing_when_nobody_does) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  say(ann, {{"type", "watch"}, {"camera", true}});
  say(bob, {{"type", "watch"}, {"camera", true}, {"room", true}});
  hub_->leave(bob.id);
  hub_->leave(ann.id);
  EXPECT_THAT(station_.calls(), ElementsAre("want camera", "want camera room", "want camera", "want"));
}

TEST_F(HubTest, pictures_and_telemetry_are_made_once_and_shared) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  const Client eve = join("eve");
  for (const Client& client : {ann, bob}) say(client, {{"type", "watch"}, {"camera", true}});
  station_.show({1, 2, 320, 240, "jpeg"});
  hub_->tick();
  hub_->tick();
  ASSERT_EQ(ann->pictures.size(), 1u);
  EXPECT_EQ(ann->pictures.back(), bob->pictures.back());
  EXPECT_TRUE(eve->pictures.empty());
}

TEST_F(HubTest, telemetry_fits_each_viewers_open_panels) {
  const Client all = join("all");
  const Client memory = join("memory");
  const Client none = join("none");
  say(all, {{"type", "watch"},
            {"camera", true},
            {"sonar", true},
            {"faces", true},
            {"room", true},
            {"memory", true}});
  say(memory, {{"type", "watch"}, {"memory", true}});
  station_.publish([&](session::Telemetry& t) {
    t.memory = std::make_shared<const memory::Snapshot>();
    t.scene_json = R"({"path_m":1})";
  });
  hub_->tick();
  ASSERT_FALSE(all->telemetry.empty());
  EXPECT_TRUE(all->telemetry.back()["memory"].is_object());
  EXPECT_FALSE(all->telemetry.back()["scene"].is_null());
  EXPECT_TRUE(memory->telemetry.back()["memory"].is_object());
  EXPECT_TRUE(memory->telemetry.back()["scene"].is_null());
  EXPECT_TRUE(none->telemetry.back()["memory"].is_null());
}

TEST_F(HubTest, telemetry_comes_at_most_twenty_times_a_second_and_only_with_news) {
  const Client ann = join("ann");
  hub_->tick();
  ann->telemetry.clear();
  for (int i = 0; i < 100; ++i) {
    station_.publish([&](session::Telemetry& t) { t.say = std::to_string(i); });
    clock_.advance(10 * kMillisecond);
    hub_->tick();
  }
  EXPECT_EQ(ann->telemetry.size(), 20u);
  ann->telemetry.clear();
  for (int i = 0; i < 100; ++i) {
    station_.publish([&](session::Telemetry& t) { t.t += 1; });
    clock_.advance(10 * kMillisecond);
    hub_->tick();
  }
  EXPECT_LE(ann->telemetry.size(), 1u);
}

TEST_F(HubTest, a_change_of_state_is_told_at_once) {
  const Client ann = join("ann");
  hub_->tick();
  ann->telemetry.clear();
  station_.publish([](session::Telemetry& t) { t.state = session::RunState::running; });
  hub_->tick();
  station_.publish([](session::Telemetry& t) { t.state = session::RunState::idle; });
  hub_->tick();
  EXPECT_EQ(ann->telemetry.size(), 2u);
}

TEST_F(HubTest, driving_from_afar_needs_the_code_and_watching_and_stop_do_not) {
  hub_ = make("AB2C3D");
  const Client ann = join("ann", true);
  EXPECT_EQ(ann->last("welcome")["may_drive"], false);
  for (const char* verb : {"run", "choose", "put_back", "evaluate"}) {
    say(ann, {{"type", verb}, {"program", 1}, {"request", 1}, {"block", "b"}});
    EXPECT_EQ(code_of(ann->last("refused")), "code_needed") << verb;
  }
  say(ann, {{"type", "stop"}});
  EXPECT_EQ(station_.stops, 1);
  greet(ann, "ann", "XXXXXX");
  EXPECT_EQ(ann->last("notice")["code"], "code_wrong");
  greet(ann, "ann", "ab2c3d");
  EXPECT_EQ(ann->last("welcome")["may_drive"], true);
  run(ann);
  EXPECT_EQ(ann->of("started").size(), 1u);
  const Client here = join("here", false);
  EXPECT_EQ(here->last("welcome")["may_drive"], true);
}

TEST_F(HubTest, five_tries_a_minute_for_a_code) {
  hub_ = make("AB2C3D");
  const Client ann = join("ann", true, "000000");
  for (int i = 0; i < 4; ++i) greet(ann, "ann", "000000");
  greet(ann, "ann", "AB2C3D");
  EXPECT_EQ(ann->last("notice")["code"], "code_wait");
  EXPECT_EQ(ann->last("welcome")["may_drive"], false);
  clock_.advance(60 * kSecond);
  greet(ann, "ann", "AB2C3D");
  EXPECT_EQ(ann->last("welcome")["may_drive"], true);
}

TEST_F(HubTest, knowing_the_owners_id_is_not_enough_to_drive_without_the_code) {
  hub_ = make("AB2C3D");
  const Client ann = join("ann", true, "AB2C3D");
  run(ann);
  const Client thief = join("ann", true);
  EXPECT_EQ(thief->last("welcome")["you_drive"], false);
  say(thief, {{"type", "pause"}});
  EXPECT_EQ(thief->last("refused")["to"], "pause");
}

TEST_F(HubTest, evaluate_answers_with_a_value_or_a_fault) {
  const Client ann = join("ann");
  for (int request : {7, 8}) {
    say(ann, {{"type", "evaluate"}, {"request", request}, {"program", "p"}, {"block", "b"}});
    do_jobs();
    station_.answer_all(request == 7 ? Result<vm::MonitorValue>(vm::MonitorValue{"3", true, 3, false})
                                     : make_fault("b", messages::field_missing, {{"field", "x"}}));
  }
  EXPECT_EQ(ann->of("value")[0], (json{{"type", "value"}, {"request", 7}, {"value", 3.0}}));
  EXPECT_EQ(ann->of("value")[1]["fault"]["place"], "b");
}

TEST_F(HubTest, an_answer_for_a_viewer_who_left_is_dropped) {
  const Client ann = join("ann");
  say(ann, {{"type", "evaluate"}, {"request", 1}, {"program", "p"}, {"block", "b"}});
  do_jobs();
  hub_->leave(ann.id);
  station_.answer_all(vm::MonitorValue{});
  EXPECT_TRUE(ann->of("value").empty());
}

TEST_F(HubTest, what_one_viewer_may_have_in_the_background_is_bounded) {
  const Client ann = join("ann");
  for (int i = 0; i < 10; ++i)
    say(ann, {{"type", "evaluate"}, {"request", i}, {"program", "p"}, {"block", "b"}});
  EXPECT_EQ(jobs_.size(), 4u);
  EXPECT_EQ(code_of(ann->last("refused")), "robot_busy");
}

TEST_F(HubTest, choose_keeps_what_is_not_named_and_tells_everybody) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  say(ann, {{"type", "choose"}, {"seed", 9}});
  do_jobs();
  EXPECT_EQ(bob->last("setup")["setup"]["seed"], 9);
  EXPECT_EQ(bob->last("setup")["setup"]["world"], "room1");
  say(ann, {{"type", "choose"}, {"world", "nowhere"}});
  do_jobs();
  EXPECT_EQ(ann->last("refused")["to"], "choose");
}

TEST_F(HubTest, garbage_is_refused_kindly_and_before_hello_closes) {
  const Client ann = join("ann");
  hub_->receive(ann.id, "{\"type\":\"run\"");
  EXPECT_EQ(code_of(ann->last("refused")), "message_broken");
  hub_->receive(ann.id, "{\"type\":\"key\",\"key\":\"" + std::string(70'000, 'x') + "\"}");
  EXPECT_EQ(code_of(ann->last("refused")), "message_too_large");
  Client stranger;
  stranger.id = hub_->join(stranger.link, false);
  say(stranger, {{"type", "run"}, {"program", 1}});
  EXPECT_EQ(stranger->closed, 1008);
}

TEST_F(HubTest, only_the_owner_calibrates_and_sees_how_it_goes) {
  const Client ann = join("ann");
  const Client bob = join("bob");
  say(ann, {{"type", "calibrate"}, {"action", "begin"}, {"size", "7x5"}});
  EXPECT_EQ(ann->last("owner")["you_drive"], true);
  do_jobs();
  hub_->tick();
  EXPECT_THAT(station_.calls(), Contains("calibrate begin 7x5"));
  EXPECT_EQ(ann->last("calibration")["phase"], "looking");
  EXPECT_THAT(bob->of("calibration"), IsEmpty());
  station_.forget_calls();
  for (const char* action : {"begin", "take", "finish", "save", "cancel"}) {
    say(bob, {{"type", "calibrate"}, {"action", action}});
    EXPECT_EQ(bob->last("refused")["to"], "calibrate");
  }
  do_jobs();
  EXPECT_THAT(station_.calls(), IsEmpty());
}

TEST_F(HubTest, a_calibration_ends_with_its_owner) {
  const Client ann = join("ann");
  say(ann, {{"type", "calibrate"}, {"action", "begin"}});
  do_jobs();
  hub_->leave(ann.id);
  clock_.advance(3 * kSecond);
  hub_->tick();
  EXPECT_THAT(station_.calls(), Contains("calibrate cancel"));
}

TEST_F(HubTest, a_reloaded_page_goes_on_calibrating) {
  const Client ann = join("ann");
  say(ann, {{"type", "calibrate"}, {"action", "begin"}});
  do_jobs();
  hub_->tick();
  hub_->leave(ann.id);
  const Client again = join("ann");
  EXPECT_EQ(again->last("calibration")["phase"], "looking");
}

TEST_F(HubTest, a_refused_calibration_says_why) {
  const Client ann = join("ann");
  say(ann, {{"type", "calibrate"}, {"action", "dance"}});
  EXPECT_EQ(ann->last("refused")["to"], "calibrate");
  say(ann, {{"type", "calibrate"}, {"action", "begin"}, {"size", "0x0"}});
  do_jobs();
  EXPECT_EQ(ann->last("refused")["faults"][0]["place"], "size");
}

TEST_F(HubTest, what_is_known_of_the_camera_reaches_those_who_come_later_too) {
  const Client ann = join("ann");
  hub_->tick();
  EXPECT_THAT(ann->of("notice"), IsEmpty());
  station_.say_of_camera(make_fault("", messages::field_missing, {{"field", "x"}}, Severity::warning));
  hub_->tick();
  hub_->tick();
  EXPECT_EQ(ann->of("notice").size(), 1u);
  const Client bob = join("bob");
  EXPECT_EQ(bob->last("notice")["code"], "field_missing");
}

}  // namespace
}  // namespace mirada::server
