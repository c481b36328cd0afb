#include "vm/sb3_json.h"

#include <algorithm>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "vm/messages.h"

namespace mirada::vm {
namespace {

using Json = nlohmann::json;

/// Goes over the text and notes the keys of every targets[i].blocks. (The parser's own callbacks take a time
/// that grows with the square of an object's size.)
class BlockOrder final : public nlohmann::json_sax<Json> {
 public:
  explicit BlockOrder(std::vector<std::vector<std::string>>& out) : out_(out) {}

  bool null() override { return plain(); }
  bool boolean(bool) override { return plain(); }
  bool number_integer(number_integer_t) override { return plain(); }
  bool number_unsigned(number_unsigned_t) override { return plain(); }
  bool number_float(number_float_t, const string_t&) override { return plain(); }
  bool string(string_t&) override { return plain(); }
  bool binary(binary_t&) override { return plain(); }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

  bool key(string_t& key) override {
    if (depth_ == 1) {
      in_targets_ = key == "targets";
      in_blocks_ = false;
      if (in_targets_) out_.clear();
    } else if (depth_ == 3 && in_targets_ && !out_.empty()) {
      in_blocks_ = key == "blocks";
      if (in_blocks_) out_.back().clear();
    } else if (depth_ == 4 && in_targets_ && in_blocks_) {
      out_.back().push_back(key);
    }
    return true;
  }

 private:
  /// Every element of the list of targets has its place, whatever it is.
  bool plain() {
    if (in_targets_ && depth_ == 2) {
      out_.emplace_back();
      in_blocks_ = false;
    }
    return true;
  }
  bool open() {
    plain();
    ++depth_;
    return true;
  }
  bool close() {
    --depth_;
    return true;
  }

  std::vector<std::vector<std::string>>& out_;
  std::size_t depth_ = 0;
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
    out.root = std::make_shared<const Json>(Json::parse(text));
    BlockOrder watch(out.block_order);
    Json::sax_parse(text, &watch);
  } catch (const Json::parse_error& error) {
    return make_fault("", messages::project_broken, {{"byte", std::to_string(error.byte)}});
  } catch (const Json::exception&) {
    return make_fault("", messages::project_broken, {{"byte", "-"}});
  }
  for (std::vector<std::string>& keys : out.block_order) order_as_javascript(keys);
  return out;
}

}  // namespace mirada::vm
