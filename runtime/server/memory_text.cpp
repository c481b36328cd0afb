#include "server/memory_text.h"

#include <iterator>

#include <fmt/format.h>

namespace mirada::server {
namespace {

template <class List, class Put>
std::string array_of(const List& list, Put&& put) {
  std::string out = "[";
  for (const auto& item : list) {
    if (out.size() > 1) out += ',';
    put(out, item);
  }
  return out + "]";
}

std::string_view kind_name(ThingKind kind) {
  switch (kind) {
    case ThingKind::face:
      return "face";
    case ThingKind::tag:
      return "tag";
    case ThingKind::red_ball:
      return "red_ball";
  }
  return "";
}

}  // namespace

std::string memory_text(const memory::Snapshot& memory) {
  const auto age_s = [&](Micros seen_at) { return seconds(memory.now - seen_at); };
  std::string out = fmt::format(
      R"({{"robot":{{"x_m":{:.3f},"y_m":{:.3f},"heading_deg":{:.2f},"pan_deg":{:.1f},"hfov_deg":{:.1f}}})",
      memory.X_OR.x_m, memory.X_OR.y_m, deg(memory.X_OR.heading_rad), deg(memory.neck.pan_rad),
      deg(memory.hfov_rad));
  out += R"(,"places":)" + array_of(memory.places, [](std::string& text, const auto& place) {
           fmt::format_to(std::back_inserter(text), "[{:.3f},{:.3f},{:.3f},{:.1f}]", place.p_O_m.x(),
                          place.p_O_m.y(), place.sigma_m, seconds(place.age));
         });
  out += R"(,"segments":)" + array_of(memory.segments, [&](std::string& text, const auto& piece) {
           fmt::format_to(std::back_inserter(text), "[{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.1f}]",
                          piece.from_O_m.x(), piece.from_O_m.y(), piece.to_O_m.x(), piece.to_O_m.y(),
                          piece.sigma_m, age_s(piece.seen_at));
         });
  out += R"(,"things":)" + array_of(memory.things, [](std::string& text, const auto& thing) {
           fmt::format_to(std::back_inserter(text), R"(["{}",{},{:.3f},{:.3f},{:.3f},{:.1f}])",
                          kind_name(thing.kind), thing.id, thing.p_O_m.x(), thing.p_O_m.y(), thing.sigma_m,
                          seconds(thing.age));
         });
  out += R"(,"free":)" + array_of(memory.free_m, [](std::string& text, double free_m) {
           fmt::format_to(std::back_inserter(text), "{:.2f}", free_m);
         });
  out += fmt::format(R"(,"next":{{"watching":"{}","why":"{}","pan_deg":{:.1f},"moving":{}}}}})",
                     memory.next.watching, memory.next.why, deg(memory.next.pan_rad), memory.next.moving);
  return out;
}

}  // namespace mirada::server
