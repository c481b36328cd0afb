#include "server/client_message.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/messages.h"
#include "server/message_scan.h"
#include "server/messages.h"

namespace mirada::server {
namespace {

using nlohmann::json;

constexpr std::array<std::pair<std::string_view, ClientVerb>, 12> kVerbs{{
    {"hello", ClientVerb::hello},
    {"run", ClientVerb::run},
    {"stop", ClientVerb::stop},
    {"pause", ClientVerb::pause},
    {"key", ClientVerb::key},
    {"evaluate", ClientVerb::evaluate},
    {"choose", ClientVerb::choose},
    {"put_back", ClientVerb::put_back},
    {"watch", ClientVerb::watch},
    {"release", ClientVerb::release},
    {"calibrate", ClientVerb::calibrate},
    {"faces", ClientVerb::faces},
}};
constexpr std::size_t kMaxFieldBytes = 4096;
constexpr std::size_t kLongestName = 40;          // characters, as the book of faces keeps them
constexpr double kMaxWhole = 9007199254740991.0;  // 2^53 - 1: what JSON numbers hold exactly everywhere

Fault too_long(std::string_view field, const std::string& path) {
  if (field == "name" || field == "to")
    return make_fault(path, messages::name_too_long,
                      {{"field", path}, {"max", std::to_string(kLongestName)}});
  return make_fault(path, messages::text_too_long,
                    {{"field", path}, {"max", std::to_string(kMaxFieldBytes)}});
}

/// The members but the program as a tree; those that cannot be parsed become faults.
json small_fields(const ScannedObject& scanned, Faults& faults) {
  json fields = json::object();
  for (const auto& [name, text] : scanned.members) {
    if (name == "program") continue;
    const std::string path = fmt::format("/{}", std::string_view(name).substr(0, 40));
    if (text.size() > kMaxFieldBytes) {
      faults.push_back(too_long(name, path));
      if (text.front() == '"') fields[name] = "";  // it is there
      continue;
    }
    json value = json::parse(text, nullptr, false);
    if (value.is_discarded()) {
      faults.push_back(make_fault(path, mirada::messages::json_broken, {{"byte", "0"}}));
    } else {
      fields[name] = std::move(value);
    }
  }
  return fields;
}

bool is_client_id(std::string_view id) {
  return id.size() >= 8 && id.size() <= 64 && std::all_of(id.begin(), id.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                  c == '_';
         });
}

void read_hello(JsonReader& in, ClientMessage& out, Faults& faults) {
  if (in.number("version", 1, 1e6) > 1) faults.push_back(make_fault("/version", messages::version_unknown));
  const bool there = in.has("client");
  out.client = in.text("client");
  if (there && !is_client_id(out.client)) {
    faults.push_back(make_fault("/client", messages::client_needed, {{"field", "client"}}));
  }
  out.code = in.text_or("code", "");
}

void read_program(const ScannedObject& scanned, ClientMessage& out, Faults& faults) {
  const auto program = scanned.members.find("program");
  if (program == scanned.members.end()) {
    faults.push_back(make_fault("/program", mirada::messages::field_missing, {{"field", "program"}}));
  } else if (program->second.size() > kMaxProgramBytes) {
    faults.push_back(make_fault("/program", messages::message_too_large,
                                {{"limit_kib", std::to_string(kMaxProgramBytes >> 10)}}));
  } else {
    out.program = std::string(program->second);
  }
}

void read_choose(JsonReader& in, ClientMessage& out) {
  if (in.has("world")) out.world = in.text("world");
  if (in.has("robot")) out.robot = in.text("robot");
  if (in.has("seed")) out.seed = static_cast<std::uint64_t>(in.number("seed", 0, kMaxWhole));
}

constexpr std::array<std::pair<std::string_view, session::CalibrationStep::Action>, 5> kSteps{{
    {"begin", session::CalibrationStep::Action::begin},
    {"take", session::CalibrationStep::Action::take},
    {"finish", session::CalibrationStep::Action::finish},
    {"save", session::CalibrationStep::Action::save},
    {"cancel", session::CalibrationStep::Action::cancel},
}};

void read_calibrate(JsonReader& in, session::CalibrationStep& out) {
  const std::string action = in.choice("action", {"begin", "take", "finish", "save", "cancel"});
  for (const auto& [name, step] : kSteps) {
    if (name == action) out.action = step;
  }
  if (out.action != session::CalibrationStep::Action::begin || action.empty()) return;
  session::CalibrationPlan& plan = out.plan;
  plan.charuco = in.has("board") && in.choice("board", {"chessboard", "charuco"}) == "charuco";
  plan.size = in.text_or("size", plan.size);
  plan.square_mm = in.number_or("square_mm", 0, 1e6, plan.square_mm);
  plan.marker_mm = in.number_or("marker_mm", 0, 1e6, plan.marker_mm);
  plan.dictionary = in.text_or("dictionary", plan.dictionary);
  plan.camera = in.text_or("camera", plan.camera);
}

void read_faces(JsonReader& in, session::FacesStep& out) {
  using Action = session::FacesStep::Action;
  const std::string action = in.choice("action", {"forget_all", "forget", "rename", "allow"});
  if (action == "allow") {
    out.action = Action::allow;
    out.on = in.truth("on");
    out.code = in.text_or("code", "");
    return;
  }
  if (action == "forget_all") return;
  out.action = action == "rename" ? Action::rename : Action::forget;
  out.name = in.text("name");
  if (action == "rename") out.to = in.text("to");
}

void read_fields(const ScannedObject& scanned, JsonReader& in, ReadMessage& out) {
  ClientMessage& message = out.message;
  switch (message.verb) {
    case ClientVerb::hello:
      return read_hello(in, message, out.faults);
    case ClientVerb::run:
      return read_program(scanned, message, out.faults);
    case ClientVerb::pause:
      message.on = in.truth_or("on", true);
      return;
    case ClientVerb::key:
      message.key = in.text("key");
      message.down = in.truth_or("down", true);
      return;
    case ClientVerb::evaluate:
      out.request = message.request = static_cast<std::uint64_t>(in.number("request", 0, kMaxWhole));
      message.block = in.text("block");
      return read_program(scanned, message, out.faults);
    case ClientVerb::choose:
      return read_choose(in, message);
    case ClientVerb::watch:
      message.wanted = {in.truth_or("camera", false), in.truth_or("sonar", false),
                        in.truth_or("faces", false), in.truth_or("room", false),
                        in.truth_or("memory", false)};
      return;
    case ClientVerb::calibrate:
      return read_calibrate(in, message.calibration);
    case ClientVerb::faces:
      return read_faces(in, message.faces);
    case ClientVerb::stop:
    case ClientVerb::put_back:
    case ClientVerb::release:
      return;
  }
}

std::string known_types() {
  std::string known;
  for (const auto& [name, verb] : kVerbs) known += (known.empty() ? "" : ", ") + std::string(name);
  return known;
}

}  // namespace

ReadMessage read_client_message(std::string_view text) {
  ReadMessage out;
  const ScannedObject scanned = scan_object(text);
  if (scanned.broken_at) {
    out.faults.push_back(
        make_fault("", messages::message_broken, {{"byte", std::to_string(*scanned.broken_at)}}));
    return out;
  }
  const json fields = small_fields(scanned, out.faults);
  JsonReader in(fields, "", out.faults);
  const std::string type = in.text("type");
  out.type = type.substr(0, 40);
  if (type.empty()) return out;
  const auto* verb =
      std::find_if(kVerbs.begin(), kVerbs.end(), [&](const auto& row) { return row.first == type; });
  if (verb == kVerbs.end()) {
    out.faults.push_back(
        make_fault("/type", messages::message_unknown, {{"value", out.type}, {"known", known_types()}}));
    return out;
  }
  out.message.verb = verb->second;
  read_fields(scanned, in, out);
  return out;
}

}  // namespace mirada::server
