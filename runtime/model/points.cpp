#include "model/points.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "model/messages.h"

namespace mirada {
namespace {

bool is_point(const nlohmann::json& value) {
  if (!value.is_array() || value.size() != 2) return false;
  for (const nlohmann::json& number : value) {
    if (!number.is_number()) return false;
    const double metres = number.get<double>();
    if (!std::isfinite(metres) || std::abs(metres) > kFarthestPoint_m) return false;
  }
  return true;
}

}  // namespace

std::vector<Eigen::Vector2d> read_points(JsonReader& reader, std::string_view field, std::size_t min,
                                         std::size_t max) {
  if (!reader.has(field) && min == 0) return {};
  const nlohmann::json* list = reader.has(field) ? &reader.json().at(std::string(field)) : nullptr;
  if (!list || !list->is_array() || list->size() < min || list->size() > max) {
    reader.fault(field, messages::points_needed,
                 {{"min", std::to_string(min)}, {"max", std::to_string(max)}});
    return {};
  }
  std::vector<Eigen::Vector2d> out;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const nlohmann::json& value = (*list)[i];
    if (is_point(value)) {
      out.emplace_back(value[0].get<double>(), value[1].get<double>());
    } else {
      reader.fault(std::string(field) + "/" + std::to_string(i), messages::point_needed,
                   {{"value", short_json(value)},
                    {"min", number_text(-kFarthestPoint_m)},
                    {"max", number_text(kFarthestPoint_m)}});
    }
  }
  return out;
}

}  // namespace mirada
