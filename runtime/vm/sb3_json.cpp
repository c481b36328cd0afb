#include "vm/sb3_json.h"

#include <algorithm>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "vm/messages.h"

namespace mirada::vm {
namespace {

using Json = nlohmann::json;

/// Watches the parser go by and notes the keys of every targets[i].blocks.
class BlockOrder {
 public:
  explicit BlockOrder(std::vector<std::vector<std::string>>& out) : out_(out) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::key) {
      note_key(depth, parsed.get_ref<const std::string&>());
    } else if (in_targets_ && depth == 2) {
      // Every element of the list has its place, whatever it is.
      if (event == Event::object_start || event == Event::array_start || event == Event::value) {
        out_.emplace_back();
        in_blocks_ = false;
      }
    }
    return true;
  }

 private:
  void note_key(int depth, const std::string& key) {
    if (depth == 1) {
      in_targets_ = key == "targets";
      in_blocks_ = false;
      if (in_targets_) out_.clear();
    } else if (depth == 3 && in_targets_ && !out_.empty()) {
      in_blocks_ = key == "blocks";
      if (in_blocks_) out_.back().clear();
    } else if (depth == 4 && in_targets_ && in_blocks_) {
      out_.back().push_back(key);
    }
  }

  std::vector<std::vector<std::string>>& out_;
  bool in_targets_ = false;
  bool in_blocks_ = false;
};

/// JavaScript goes through keys that are whole numbers first, from the smallest.
bool is_index(const std::string& key) {
  if (key.empty() || key.size() > 9 || (key[0] == '0' && key.size() > 1)) return false;
  return std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void order_as_javascript(std::vector<std::string>& keys) {
  std::unordered_set<std::string> seen;
  std::erase_if(keys, [&](const std::string& key) { return !seen.insert(key).second; });
  const auto middle = std::stable_partition(keys.begin(), keys.end(), is_index);
  std::sort(keys.begin(), middle,
            [](const std::string& a, const std::string& b) { return std::stol(a) < std::stol(b); });
}

}  // namespace

Result<ProjectJson> parse_project(std::string_view text) {
  ProjectJson out;
  try {
    BlockOrder watch(out.block_order);
    out.root = std::make_shared<const Json>(
        Json::parse(text, [&](int depth, Json::parse_event_t event, const Json& parsed) {
          return watch(depth, event, parsed);
        }));
  } catch (const Json::parse_error& error) {
    return make_fault("", messages::project_broken, {{"byte", std::to_string(error.byte)}});
  } catch (const Json::exception&) {
    return make_fault("", messages::project_broken, {{"byte", "-"}});
  }
  for (std::vector<std::string>& keys : out.block_order) order_as_javascript(keys);
  return out;
}

}  // namespace mirada::vm
