#include <utility>

#include "server/hub.h"
#include "server/messages.h"
#include "server/viewer.h"

namespace mirada::server {
namespace {

constexpr std::uint16_t kPolicyViolation = 1008;
constexpr std::size_t kMaxLeftOut = 1000;
constexpr std::size_t kMaxJobs = 32;

bool carries_program(const ReadMessage& read) { return read.type == "run" || read.type == "evaluate"; }

}  // namespace

void Hub::receive(ViewerId id, std::string_view text) {
  Viewer* viewer = find(id);
  if (!viewer) return;
  heard(id);
  const ReadMessage read = read_client_message(text);
  if (read.faults.empty() && read.message.verb == ClientVerb::stop) {
    const bool told = stop() && viewer->greeted();
    if (!told) viewer->link->send_control(stopped_text());
    return;
  }
  if (!within_rate(*viewer, read)) return;
  if (!viewer->greeted() && read.type != "hello") {
    viewer->link->close(kPolicyViolation, "say hello first");
  } else if (text.size() > kMaxMessageBytes && !carries_program(read)) {
    const MessageArgs limit{{"limit_kib", std::to_string(kMaxMessageBytes >> 10)}};
    viewer->link->send_control(refused_text(read.type, {make_fault("", messages::message_too_large, limit)}));
  } else if (!read.faults.empty()) {
    viewer->link->send_control(refused_text(read.type, read.faults));
  } else {
    handle(*viewer, read);
  }
}

bool Hub::within_rate(Viewer& viewer, const ReadMessage& read) {
  // A key that was let down must come up, or the robot would go on as if it were held.
  const bool key_up = read.message.verb == ClientVerb::key && viewer.keys_down.contains(read.message.key) &&
                      !read.message.down;
  if (viewer.bucket.take(wiring_.clock.now()) || key_up) {
    viewer.left_out = 0;
    return true;
  }
  if (viewer.left_out++ == 0) viewer.link->send_control(notice_text(messages::too_fast));
  if (viewer.left_out == kMaxLeftOut) viewer.link->close(kPolicyViolation, "too many messages");
  return false;
}

void Hub::handle(Viewer& viewer, const ReadMessage& read) {
  const ClientMessage& message = read.message;
  switch (message.verb) {
    case ClientVerb::hello:
      return hello(viewer, message);
    case ClientVerb::run:
      return run(viewer, message.program);
    case ClientVerb::pause:
      if (!drives(viewer)) return refuse(viewer, "pause", messages::not_driving);
      return wiring_.station.pause(message.on);
    case ClientVerb::key:
      return key(viewer, message);
    case ClientVerb::evaluate:
      return evaluate(viewer, message);
    case ClientVerb::choose:
      return choose(viewer, message);
    case ClientVerb::put_back:
      return put_back(viewer);
    case ClientVerb::watch:
      return watch(viewer, message.wanted);
    case ClientVerb::release:
      return release(viewer);
    case ClientVerb::calibrate:
      return calibrate(viewer, message.calibration);
    case ClientVerb::faces:
      return change_faces(viewer, message.faces);
    case ClientVerb::stop:
      return;
  }
}

void Hub::hello(Viewer& viewer, const ClientMessage& message) {
  viewer.client = message.client;
  lease_.heard(viewer.client, wiring_.clock.now());
  if (!viewer.may_drive && !message.code.empty()) check_code(viewer, message.code);
  const auto telemetry = wiring_.station.telemetry();
  viewer.link->send_control(
      welcome_text(seat(viewer), seats(), wiring_.station, telemetry ? telemetry->t : 0));
  give_current(viewer);
  if (!camera_words_.empty()) viewer.link->send_control(camera_words_);
  if (viewer.may_drive) viewer.link->send_control(known_faces_text(wiring_.station.known_faces()));
  const auto calibration = wiring_.station.calibration();
  const bool shown = calibration && calibration->phase != session::Calibration::Phase::off;
  if (shown && drives(viewer)) viewer.link->send_control(calibration_text(*calibration));
  tell_owner();
}

void Hub::check_code(Viewer& viewer, const std::string& code) {
  const Message* trouble = code_trouble(code, wiring_.join_code, viewer.code_tries, wrong_codes_);
  viewer.may_drive = trouble == nullptr;
  if (trouble != nullptr) viewer.link->send_control(notice_text(*trouble));
}

const Message* Hub::code_trouble(const std::string& typed, const std::string& code, TryLimit& own,
                                 TryLimit& all) {
  const Micros now = wiring_.clock.now();
  if (!own.allows(now) || !all.allows(now)) return &messages::code_wait;
  own.count(now);
  if (same_code(typed, code)) return nullptr;
  all.count(now);
  return &messages::code_wrong;
}

bool Hub::may_drive(Viewer& viewer, std::string_view verb) {
  if (!viewer.may_drive) {
    refuse(viewer, verb, messages::code_needed);
    return false;
  }
  if (!lease_.free() && !drives(viewer)) {
    refuse(viewer, verb, messages::robot_taken);
    return false;
  }
  return true;
}

bool Hub::begin_job(Viewer& viewer, std::string_view verb) {
  if (viewer.jobs >= Viewer::kMaxJobs || jobs_ >= kMaxJobs) {
    refuse(viewer, verb, messages::robot_busy);
    return false;
  }
  ++viewer.jobs;
  ++jobs_;
  return true;
}

void Hub::end_job(ViewerId id) {
  --jobs_;
  if (Viewer* viewer = find(id)) --viewer->jobs;
}

void Hub::run(Viewer& viewer, const std::string& program) {
  if (!may_drive(viewer, "run") || !begin_job(viewer, "run")) return;
  const bool new_owner = lease_.free();
  lease_.take(viewer.client, wiring_.clock.now());
  if (new_owner) tell_owner();
  start_in_background(viewer.id, program);
}

void Hub::start_in_background(ViewerId id, std::string program) {
  const std::uint64_t stops_before = stops_.load();
  wiring_.background([this, id, stops_before, program = std::move(program)] {
    const auto stopped = [&] { return stops_.load() != stops_before; };
    Result<session::Started> started = make_fault("", messages::start_stopped);
    if (!stopped()) started = wiring_.station.start(program);
    if (started.ok() && stopped()) {
      // A Stop came while the program was compiled, before it ran.
      wiring_.station.stop(session::StopReason::stop_button);
      started = make_fault("", messages::start_stopped);
    }
    const std::string answer =
        started.ok() ? started_text(started->run, started->warnings) : refused_text("run", started.faults());
    wiring_.on_hub([this, id, answer] {
      end_job(id);
      send(id, answer);
    });
  });
}

void Hub::evaluate(Viewer& viewer, const ClientMessage& message) {
  if (!viewer.may_drive) return refuse(viewer, "evaluate", messages::code_needed);
  if (!begin_job(viewer, "evaluate")) return;
  const ViewerId id = viewer.id;
  const std::uint64_t request = message.request;
  wiring_.background([this, id, request, program = message.program, block = message.block] {
    // The answer may come long after this server is gone: it takes only what outlives it.
    const auto answer = [this, id, on_hub = wiring_.on_hub, request](Result<vm::MonitorValue> value) {
      on_hub([this, id, text = value_text(request, value)] {
        end_job(id);
        send(id, text);
      });
    };
    wiring_.station.evaluate(program, block, answer);
  });
}

void Hub::choose(Viewer& viewer, const ClientMessage& message) {
  if (!may_drive(viewer, "choose") || !begin_job(viewer, "choose")) return;
  wiring_.background([this, id = viewer.id, message] {
    session::Setup setup = wiring_.station.setup();
    setup.world = message.world.value_or(setup.world);
    setup.robot = message.robot.value_or(setup.robot);
    setup.seed = message.seed.value_or(setup.seed);
    const Status chosen = wiring_.station.choose(setup);
    const std::string text =
        chosen.ok() ? setup_text(wiring_.station.setup()) : refused_text("choose", chosen.faults());
    wiring_.on_hub([this, id, text, ok = chosen.ok()] {
      end_job(id);
      return ok ? broadcast(text) : send(id, text);
    });
  });
}

void Hub::put_back(Viewer& viewer) {
  if (!may_drive(viewer, "put_back") || !begin_job(viewer, "put_back")) return;
  wiring_.background([this, id = viewer.id] {
    const Status done = wiring_.station.put_back();
    wiring_.on_hub([this, id, done] {
      end_job(id);
      if (!done.ok()) send(id, refused_text("put_back", done.faults()));
    });
  });
}

void Hub::calibrate(Viewer& viewer, const session::CalibrationStep& step) {
  if (step.action == session::CalibrationStep::Action::begin) {
    if (!may_drive(viewer, "calibrate") || !begin_job(viewer, "calibrate")) return;
    const bool new_owner = lease_.free();
    lease_.take(viewer.client, wiring_.clock.now());
    if (new_owner) tell_owner();
  } else {
    if (!drives(viewer)) return refuse(viewer, "calibrate", messages::not_driving);
    if (!begin_job(viewer, "calibrate")) return;
  }
  wiring_.background([this, id = viewer.id, step] {
    const Status done = wiring_.station.calibrate(step);
    wiring_.on_hub([this, id, done] {
      end_job(id);
      if (!done.ok()) send(id, refused_text("calibrate", done.faults()));
    });
  });
}

void Hub::change_faces(Viewer& viewer, const session::FacesStep& step) {
  if (!viewer.may_drive) return refuse(viewer, "faces", messages::code_needed);
  // To switch it off needs no code.
  const bool guarded = step.action == session::FacesStep::Action::allow && step.on;
  if (guarded && !wiring_.teacher_code.empty()) {
    if (step.code.empty()) return refuse(viewer, "faces", messages::teacher_code_needed);
    const Message* trouble =
        code_trouble(step.code, wiring_.teacher_code, viewer.teacher_tries, wrong_teacher_codes_);
    if (trouble != nullptr) return refuse(viewer, "faces", *trouble);
  }
  if (!begin_job(viewer, "faces")) return;
  wiring_.background([this, id = viewer.id, step] {
    const Status done = wiring_.station.change_faces(step);
    wiring_.on_hub([this, id, done] {
      end_job(id);
      if (!done.ok()) send(id, refused_text("faces", done.faults()));
    });
  });
}

void Hub::key(Viewer& viewer, const ClientMessage& message) {
  constexpr std::size_t kMaxKeyBytes = 32;
  constexpr std::size_t kMaxKeysDown = 64;
  if (!drives(viewer)) return refuse(viewer, "key", messages::not_driving);
  if (message.key.size() > kMaxKeyBytes) return refuse(viewer, "key", messages::key_unknown);
  if (message.down && viewer.keys_down.size() < kMaxKeysDown) viewer.keys_down.insert(message.key);
  if (!message.down) viewer.keys_down.erase(message.key);
  wiring_.station.key(message.key, message.down);
}

void Hub::watch(Viewer& viewer, const session::Wanted& wanted) {
  viewer.wanted = wanted;
  update_wanted();
  give_current(viewer);
}

void Hub::release(Viewer& viewer) {
  if (!drives(viewer)) return;
  release_keys(viewer);
  end_calibration();
  stop();
  lease_.release();
  tell_owner();
}

void Hub::refuse(Viewer& viewer, std::string_view verb, const Message& message) {
  viewer.link->send_control(refused_text(verb, {make_fault("", message)}));
}

}  // namespace mirada::server
