#pragma once
#include <string>

namespace mirada::rig {

// Workspace JSON of small programs, put together from text. `next` is a whole block or "".

inline std::string number_input(const std::string& name, const std::string& value) {
  return '"' + name + R"(": {"shadow": {"type": "math_number", "fields": {"NUM": ")" + value + R"("}}})";
}

inline std::string text_input(const std::string& name, const std::string& value) {
  return '"' + name + R"(": {"shadow": {"type": "text", "fields": {"TEXT": ")" + value + R"("}}})";
}

inline std::string block_input(const std::string& name, const std::string& block) {
  return '"' + name + R"(": {"block": )" + block + "}";
}

/// An id that no other block has; it begins with `stem`.
inline std::string fresh_id(const std::string& stem) {
  static int count = 0;
  return stem + "#" + std::to_string(++count);
}

struct BlockText {
  std::string type;
  std::string stem;    ///< of its id
  std::string inputs;  ///< without braces
  std::string fields;  ///< without braces
};

inline std::string block(const BlockText& of, const std::string& next = "") {
  std::string out = R"({"type": ")" + of.type + R"(", "id": ")" + fresh_id(of.stem) + "\"";
  if (!of.inputs.empty()) out += R"(, "inputs": {)" + of.inputs + "}";
  if (!of.fields.empty()) out += R"(, "fields": {)" + of.fields + "}";
  if (!next.empty()) out += R"(, "next": {"block": )" + next + "}";
  return out + "}";
}

inline std::string program(const std::string& blocks) {
  return R"({"blocks": {"languageVersion": 0, "blocks": [)" + blocks + R"(]}, "variables": []})";
}

inline std::string flag(const std::string& next) {
  return block({"event_whenflagclicked", "flag", "", ""}, next);
}

inline std::string forever(const std::string& body) {
  return block({"control_forever", "forever", block_input("SUBSTACK", body), ""});
}

inline std::string set_speeds(const std::string& left, const std::string& right,
                              const std::string& next = "") {
  return block(
      {"motion_set_speeds", "speeds", number_input("LEFT", left) + ", " + number_input("RIGHT", right), ""},
      next);
}

inline std::string drive(const std::string& way, const std::string& cm, const std::string& next = "") {
  return block({"motion_drive", "drive", number_input("DISTANCE", cm), R"("WAY": ")" + way + "\""}, next);
}

inline std::string turn(const std::string& side, const std::string& degrees, const std::string& next = "") {
  return block({"motion_turn", "turn", number_input("ANGLE", degrees), R"("SIDE": ")" + side + "\""}, next);
}

inline std::string wait(const std::string& time_s, const std::string& next = "") {
  return block({"control_wait", "wait", number_input("DURATION", time_s), ""}, next);
}

inline std::string say(const std::string& text, const std::string& next = "") {
  return block({"looks_say", "say", text_input("MESSAGE", text), ""}, next);
}

}  // namespace mirada::rig
