#include "see_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "see_messages.h"

namespace mirada {
namespace {

double rounded(double value, double step) { return std::round(value / step) * step; }

nlohmann::json metres(double value_m) {
  if (!std::isfinite(value_m)) return nullptr;
  return std::round(value_m * 1e4) / 1e4;
}

nlohmann::json reading_json(const SonarReading& reading) {
  return {{"bearing_deg", rounded(deg(reading.bearing_rad), 1)},
          {"answer", to_string(reading.answer)},
          {"distance_m", metres(reading.distance_m)},
          {"sigma_m", metres(reading.sigma_m)}};
}

nlohmann::json face_json(const FacePercept& face, const std::string& detector) {
  const auto tenth = [](double value) { return std::round(value * 10) / 10; };
  return {{"x", tenth(face.x_px)},
          {"y", tenth(face.y_px)},
          {"w", tenth(face.w_px)},
          {"h", tenth(face.h_px)},
          {"score", metres(face.score)},
          {"detector", detector},
          {"bearing_deg", tenth(deg(face.bearing_rad))},
          {"distance_m", metres(face.distance_m)},
          {"sigma_m", metres(face.sigma_m)},
          {"id", face.id},
          {"name", face.name},
          {"who", to_string(face.familiar)},
          {"state", face.predicted ? "predicted" : "seen"}};
}

}  // namespace

nlohmann::json see_report(const SeenPicture& seen) {
  nlohmann::json out{{"version", 1},
                     {"image", seen.image},
                     {"width", seen.width_px},
                     {"height", seen.height_px},
                     {"robot", seen.robot},
                     {"pan_deg", metres(deg(seen.sonar.neck.pan_rad))},
                     {"tilt_deg", metres(deg(seen.sonar.neck.tilt_rad))},
                     {"floor_trusted", seen.sonar.floor_model_trusted},
                     {"sonar", nlohmann::json::array()},
                     {"faces", nlohmann::json::array()}};
  if (seen.frame >= 0) out["frame"] = seen.frame;
  for (const SonarReading& reading : seen.sonar.readings) out["sonar"].push_back(reading_json(reading));
  for (const FacePercept& face : seen.faces.faces)
    out["faces"].push_back(face_json(face, seen.faces.detector));
  return out;
}

std::string see_words(const SeenPicture& seen, Lang lang) {
  const std::string image = seen.frame < 0 ? seen.image : seen.image + " #" + std::to_string(seen.frame);
  const SonarReading* nearest = nullptr;
  for (const SonarReading& reading : seen.sonar.readings) {
    if (reading.answer == Answer::blocked && (!nearest || reading.distance_m < nearest->distance_m))
      nearest = &reading;
  }
  std::string out;
  if (!seen.sonar.floor_model_trusted) {
    out = format(messages::see_no_floor, {{"image", image}}, lang);
  } else if (!nearest) {
    out = format(messages::see_free, {{"image", image}}, lang);
  } else {
    const double bearing_deg = deg(nearest->bearing_rad);
    const bool left = bearing_deg > 0;
    const std::string side = lang == Lang::es ? (left ? "izquierda" : "derecha") : (left ? "left" : "right");
    const Message& message = std::abs(bearing_deg) < 0.5 ? messages::see_ahead : messages::see_nearest;
    out = format(message,
                 {{"image", image},
                  {"cm", number_text(nearest->distance_m * 100, 0)},
                  {"degrees", number_text(std::abs(bearing_deg), 0)},
                  {"side", side}},
                 lang);
  }
  if (seen.faces.faces.empty()) return out;
  return out + "\n" +
         format(messages::see_faces, {{"image", image}, {"count", std::to_string(seen.faces.faces.size())}},
                lang);
}

nlohmann::json fault_report(const Faults& faults) {
  nlohmann::json out{{"version", 1}, {"faults", nlohmann::json::array()}};
  for (const Fault& fault : faults) {
    out["faults"].push_back({{"place", fault.place},
                             {"code", std::string(fault.code())},
                             {"severity", fault.severity == Severity::error ? "error" : "warning"},
                             {"message", {{"en", fault.text(Lang::en)}, {"es", fault.text(Lang::es)}}}});
  }
  return out;
}

}  // namespace mirada
