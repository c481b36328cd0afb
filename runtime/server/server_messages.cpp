#include "server/server_messages.h"

#include <nlohmann/json.hpp>

#include "server/json_text.h"

namespace mirada::server {
namespace {

using nlohmann::json;

json faults_to_json(const Faults& faults) {
  json out = json::array();
  for (const Fault& fault : faults) out.push_back(fault_to_json(fault));
  return out;
}

json setup_to_json(const session::Setup& setup) {
  return {
      {"world", setup.world}, {"robot", setup.robot}, {"seed", setup.seed}, {"simulated", setup.simulated}};
}

json options_to_json(const std::vector<session::Option>& options) {
  json out = json::array();
  for (const session::Option& option : options) {
    out.push_back({{"id", option.id}, {"name", {{"en", option.name_en}, {"es", option.name_es}}}});
  }
  return out;
}

void put_seats(json& out, const Seat& seat, const Seats& seats) {
  out["owner"] = seats.owner.empty() ? json(nullptr) : json(seats.owner);
  out["taken"] = seats.taken;
  out["viewers"] = seats.viewers;
  out["you"] = seat.you;
  out["you_drive"] = seat.you_drive;
  out["may_drive"] = seat.may_drive;
}

}  // namespace

std::string faults_json(const Faults& faults) { return dump(faults_to_json(faults)); }
std::string setup_json(const session::Setup& setup) { return dump(setup_to_json(setup)); }
std::string options_json(const std::vector<session::Option>& options) {
  return dump(options_to_json(options));
}

std::string welcome_text(const Seat& seat, const Seats& seats, const session::Station& station,
                         Micros robot_clock) {
  json out{{"type", "welcome"},
           {"version", 1},
           {"setup", setup_to_json(station.setup())},
           {"worlds", options_to_json(station.worlds())},
           {"robots", options_to_json(station.robots())},
           {"robot_clock_us", robot_clock}};
  put_seats(out, seat, seats);
  return dump(out);
}

std::string owner_text(const Seat& seat, const Seats& seats) {
  json out{{"type", "owner"}};
  put_seats(out, seat, seats);
  return dump(out);
}

std::string notice_text(const Message& message, Severity severity, const MessageArgs& args) {
  return dump({{"type", "notice"},
               {"code", std::string(message.code)},
               {"severity", severity == Severity::error ? "error" : "warning"},
               {"message", both_languages(message, args)}});
}

std::string started_text(std::uint64_t run, const Faults& warnings) {
  return dump({{"type", "started"}, {"run", run}, {"warnings", faults_to_json(warnings)}});
}

std::string refused_text(std::string_view to, const Faults& faults) {
  return dump({{"type", "refused"}, {"to", std::string(to)}, {"faults", faults_to_json(faults)}});
}

std::string stopped_text() { return R"({"type":"stopped"})"; }

std::string setup_text(const session::Setup& setup) {
  return dump({{"type", "setup"}, {"setup", setup_to_json(setup)}});
}

std::string value_text(std::uint64_t request, const Result<vm::MonitorValue>& answer) {
  json out{{"type", "value"}, {"request", request}};
  if (answer.ok()) {
    out["value"] = monitor_to_json(answer.value());
  } else {
    out["fault"] = fault_to_json(answer.faults().front());
  }
  return dump(out);
}

std::string calibration_text(const session::Calibration& state) {
  const auto words = [](const std::optional<Fault>& fault) {
    return fault ? both_languages(*fault->message, fault->args) : json(nullptr);
  };
  return dump({{"type", "calibration"},
               {"phase", session::to_string(state.phase)},
               {"room_holds", state.room_holds},
               {"frame", state.frame},
               {"width", state.width_px},
               {"height", state.height_px},
               {"corners", state.corners},
               {"taken", state.taken},
               {"target", state.target},
               {"next", words(state.next)},
               {"now", words(state.now)},
               {"views", state.views},
               {"views_needed", state.views_needed},
               {"views_good", state.views_good},
               {"coverage", state.coverage},
               {"tilt_deg", state.tilt_deg},
               {"rms_px", state.rms_px},
               {"hfov_deg", state.hfov_deg},
               {"vfov_deg", state.vfov_deg},
               {"view_rms_px", state.view_rms_px},
               {"words", faults_to_json(state.words)}});
}

std::string known_faces_text(const session::KnownFaces& faces) {
  json people = json::array();
  for (const session::KnownFaces::Person& person : faces.people)
    people.push_back({{"name", person.name}, {"looks", person.looks}});
  return dump({{"type", "known_faces"}, {"allowed", faces.allowed}, {"people", std::move(people)}});
}

std::string camera_words_text(const Fault& words) {
  return notice_text(*words.message, words.severity, words.args);
}

std::string check_json(const Faults& faults) {
  return dump({{"ok", !has_errors(faults)}, {"faults", faults_to_json(faults)}});
}

}  // namespace mirada::server
