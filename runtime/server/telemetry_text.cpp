#include "server/telemetry_text.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/percepts.h"
#include "server/json_text.h"
#include "server/memory_text.h"

namespace mirada::server {
namespace {

using nlohmann::json;

/// JSON has no NaN: what is not known is null.
void put_number(std::string& out, double value, int digits) {
  if (std::isfinite(value)) {
    fmt::format_to(std::back_inserter(out), "{:.{}f}", value, digits);
  } else {
    out += "null";
  }
}

std::string sonar_text(const SonarPercept& sonar) {
  if (sonar.frame == 0) return "null";
  std::string out = fmt::format(R"({{"frame":{},"t_us":{},"pan_deg":)", sonar.frame, sonar.t_exposure);
  put_number(out, deg(sonar.neck.pan_rad), 2);
  out += sonar.floor_model_trusted ? R"(,"trusted":true,"readings":[)" : R"(,"trusted":false,"readings":[)";
  for (const SonarReading& reading : sonar.readings) {
    out += out.back() == '[' ? "[" : ",[";
    put_number(out, deg(reading.bearing_rad), 2);
    fmt::format_to(std::back_inserter(out), ",\"{}\",", to_string(reading.answer));
    put_number(out, reading.distance_m, 4);
    out += ',';
    put_number(out, reading.sigma_m, 4);
    out += ']';
  }
  out += R"(],"boundary":[)";
  for (const BoundaryPixel& pixel : sonar.boundary) {
    out += out.back() == '[' ? "[" : ",[";
    put_number(out, pixel.u_px, 1);
    out += ',';
    put_number(out, pixel.v_px, 1);
    fmt::format_to(std::back_inserter(out), ",\"{}\"]", to_string(pixel.answer));
  }
  return out + "]}";
}

json lesson_json(const std::optional<LessonPercept>& lesson) {
  if (!lesson) return nullptr;
  return {{"name", lesson->name},
          {"looks", lesson->looks},
          {"needed", lesson->needed},
          {"hint", lesson->hint == nullptr ? json(nullptr) : both_languages(*lesson->hint, {})}};
}

json face_json(const FacePercept& face, bool names) {
  return {{"id", face.id},
          {"x", face.x_px},
          {"y", face.y_px},
          {"w", face.w_px},
          {"h", face.h_px},
          {"score", face.score},
          {"bearing_deg", deg(face.bearing_rad)},
          {"distance_m", face.distance_m},
          {"sigma_m", face.sigma_m},
          {"predicted", face.predicted},
          {"name", names ? face.name : std::string()},
          {"who", to_string(names ? face.familiar : Familiar::unsure)}};
}

std::string faces_text(const session::Telemetry& telemetry, bool names) {
  if (!telemetry.percepts) return "null";
  const FacesPercept& percept = telemetry.percepts->faces;
  if (percept.frame == 0) return "null";
  json faces = json::array();
  json bodies = json::array();
  for (const FacePercept& face : percept.faces) faces.push_back(face_json(face, names));
  for (const FacePercept& body : percept.bodies) bodies.push_back(face_json(body, names));
  return dump({{"frame", percept.frame},
               {"t_us", percept.t_exposure},
               {"width", percept.picture_width_px},
               {"height", percept.picture_height_px},
               {"detector", percept.detector},
               {"faces", faces},
               {"bodies", bodies},
               {"lesson", names ? lesson_json(percept.lesson) : json(nullptr)},
               {"follow", {{"state", telemetry.follow_state}, {"id", telemetry.follow_id}}}});
}

json lists_to_json(const std::map<std::string, std::vector<vm::MonitorValue>>& lists) {
  json out = json::object();
  for (const auto& [name, values] : lists) {
    json items = json::array();
    for (const vm::MonitorValue& value : values) items.push_back(monitor_to_json(value));
    out[name] = std::move(items);
  }
  return out;
}

json variables_to_json(const std::map<std::string, vm::MonitorValue>& variables) {
  json out = json::object();
  for (const auto& [name, value] : variables) out[name] = monitor_to_json(value);
  return out;
}

json said_to_json(const std::vector<session::SaidText>& log) {
  json out = json::array();
  for (const session::SaidText& said : log) out.push_back({{"t_s", seconds(said.t)}, {"text", said.text}});
  return out;
}

json faults_to_json(const std::vector<vm::BlockFault>& faults) {
  json out = json::array();
  for (const vm::BlockFault& fault : faults) {
    json row = fault_to_json(fault.fault);
    row["place"] = fault.block;
    out.push_back(std::move(row));
  }
  return out;
}

std::string base_text(const session::Telemetry& telemetry) {
  const json out{
      {"run", telemetry.run},
      {"state", to_string(telemetry.state)},
      {"stop_reason", to_string(telemetry.stop_reason)},
      {"blocks", telemetry.running_blocks ? json(*telemetry.running_blocks) : json::array()},
      {"variables", variables_to_json(telemetry.variables)},
      {"lists", lists_to_json(telemetry.lists)},
      {"list_lengths", telemetry.list_lengths},
      {"say", telemetry.say},
      {"say_log", said_to_json(telemetry.say_log)},
      {"faults", faults_to_json(telemetry.faults)},
      {"odometry",
       {{"x_m", telemetry.X_OR.x_m},
        {"y_m", telemetry.X_OR.y_m},
        {"heading_deg", deg(telemetry.X_OR.heading_rad)}}},
      {"neck", {{"pan_deg", deg(telemetry.neck.pan_rad)}, {"tilt_deg", deg(telemetry.neck.tilt_rad)}}},
      {"wheels", {{"left_mps", telemetry.left_mps}, {"right_mps", telemetry.right_mps}}},
      {"camera_trouble", telemetry.camera_trouble_code}};
  std::string text = dump(out);
  text.pop_back();  // more members follow
  return text;
}

}  // namespace

TelemetryText::TelemetryText(const session::Telemetry& telemetry)
    : time_(std::to_string(telemetry.t)),
      base_(base_text(telemetry)),
      sonar_(telemetry.percepts ? sonar_text(telemetry.percepts->sonar) : "null"),
      faces_(faces_text(telemetry, true)),
      nameless_faces_(faces_text(telemetry, false)),
      lesson_(telemetry.percepts && telemetry.percepts->faces.lesson),
      scene_(telemetry.scene_json.empty() ? "null" : telemetry.scene_json),
      memory_(telemetry.memory ? memory_text(*telemetry.memory) : "null") {}

std::string TelemetryText::assemble(const session::Wanted& panels, bool names) const {
  std::string out = base_;
  const auto part = [&out](const char* name, bool open, const std::string& text) {
    out += std::string(",\"") + name + "\":" + (open ? text : "null");
  };
  part("sonar", panels.sonar, sonar_);
  part("faces", panels.faces || (names && lesson_), names ? faces_ : nameless_faces_);
  part("scene", panels.room, scene_);
  part("memory", panels.memory, memory_);
  return out + ",\"type\":\"telemetry\",\"t_us\":" + time_ + "}";
}

bool TelemetryText::same_content(const TelemetryText& other) const {
  return base_ == other.base_ && sonar_ == other.sonar_ && faces_ == other.faces_ && scene_ == other.scene_ &&
         memory_ == other.memory_;
}

std::string picture_bytes(const session::Picture& picture) {
  const std::string header = fmt::format(R"({{"frame":{},"t_us":{},"width":{},"height":{}}})", picture.frame,
                                         picture.t_exposure, picture.width_px, picture.height_px);
  std::string out;
  out.reserve(4 + header.size() + picture.jpeg.size());
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((header.size() >> shift) & 0xff);
  return out + header + picture.jpeg;
}

}  // namespace mirada::server
