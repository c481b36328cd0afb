#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/result.h"

namespace mirada::vm {

/// A Scratch project's JSON, and the order in which each of its targets lists its blocks: scripts start in
/// that order, which a sorted JSON object forgets.
struct ProjectJson {
  std::shared_ptr<const nlohmann::json> root;
  std::vector<std::vector<std::string>> block_order;  ///< by target; each id once, in JavaScript's order
};

Result<ProjectJson> parse_project(std::string_view text);

}  // namespace mirada::vm
