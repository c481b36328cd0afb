#include "vm/json_tree.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "vm/numbers.h"

namespace mirada::vm {

/// Hears what the parser finds and lines it up.
class JsonTree::Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(JsonTree& out) : out_(out) {}

  bool null() override { return add({}); }
  bool boolean(bool truth) override { return add({.number = truth ? 1.0 : 0.0, .kind = Kind::truth}); }
  bool number_integer(number_integer_t number) override { return add_number(static_cast<double>(number)); }
  bool number_unsigned(number_unsigned_t number) override { return add_number(static_cast<double>(number)); }
  bool number_float(number_float_t number, const string_t&) override { return add_number(number); }
  bool string(string_t& text) override { return add({.text = keep(text), .kind = Kind::text}); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Kind::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Kind::array); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    key_ = keep(name);
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::json::exception& error) override {
    constexpr int kNumberTooLarge = 406;
    out_.broken_ = Broken{byte, error.id == kNumberTooLarge};
    return false;
  }

 private:
  using Kind = JsonValue::Kind;

  Letters keep(const std::string& text) {
    const Letters letters{static_cast<std::uint32_t>(out_.letters_.size()),
                          static_cast<std::uint32_t>(text.size())};
    out_.letters_ += text;
    return letters;
  }
  bool add_number(double number) { return add({.number = number, .kind = Kind::number}); }
  bool add(Node node) {
    node.key = std::exchange(key_, {});
    out_.nodes_.push_back(node);
    if (!open_.empty()) ++out_.nodes_[open_.back()].size;
    return true;
  }
  bool open(Kind kind) {
    add({.kind = kind});
    open_.push_back(static_cast<std::uint32_t>(out_.nodes_.size()) - 1);
    return true;
  }
  bool close() {
    const std::uint32_t index = open_.back();
    open_.pop_back();
    out_.nodes_[index].span = static_cast<std::uint32_t>(out_.nodes_.size()) - index;
    return true;
  }

  JsonTree& out_;
  Letters key_{};
  std::vector<std::uint32_t> open_;
};

JsonTree JsonTree::parse(std::string_view text) {
  JsonTree out;
  out.letters_.reserve(text.size());
  Builder builder(out);
  nlohmann::json::sax_parse(text, &builder);
  return out;
}

JsonValue::Kind JsonValue::kind() const { return tree_ ? tree_->nodes_[index_].kind : Kind::null; }
bool JsonValue::truth() const { return is_truth() && number() != 0; }
double JsonValue::number() const { return tree_->nodes_[index_].number; }
std::string_view JsonValue::text() const { return tree_->view(tree_->nodes_[index_].text); }
std::string_view JsonValue::key() const { return tree_->view(tree_->nodes_[index_].key); }
std::size_t JsonValue::size() const { return tree_ ? tree_->nodes_[index_].size : 0; }

JsonValue::Iterator JsonValue::begin() const {
  JsonValue first = *this;
  if (!empty()) ++first.index_;
  return Iterator(first);
}

JsonValue::Iterator JsonValue::end() const {
  JsonValue behind = *this;
  if (!empty()) behind.index_ += tree_->nodes_[index_].span;
  return Iterator(behind);
}

JsonValue JsonValue::operator[](std::size_t i) const {
  if (!is_array()) return {};
  for (const JsonValue part : *this) {
    if (i-- == 0) return part;
  }
  return {};
}

JsonValue JsonValue::find(std::string_view key) const {
  JsonValue found;
  if (!is_object()) return found;
  for (const JsonValue field : *this) {
    if (field.key() == key) found = field;
  }
  return found;
}

std::vector<JsonValue> JsonValue::fields() const {
  std::vector<JsonValue> out;
  if (!is_object()) return out;
  out.reserve(size());
  for (const JsonValue field : *this) out.push_back(field);
  const auto by_key = [](JsonValue a, JsonValue b) { return a.key() < b.key(); };
  if (!std::is_sorted(out.begin(), out.end(), by_key)) std::stable_sort(out.begin(), out.end(), by_key);
  const auto last =
      std::unique(out.rbegin(), out.rend(), [](JsonValue a, JsonValue b) { return a.key() == b.key(); });
  out.erase(out.begin(), last.base());
  return out;
}

std::string plain_text(JsonValue value) {
  if (value.is_text()) return std::string(value.text());
  if (value.is_truth()) return value.truth() ? "true" : "false";
  return value.is_number() ? number_to_string(value.number()) : std::string();
}

std::string shown_json(JsonValue value) {
  if (value.is_structured()) return value.is_array() ? "[...]" : "{...}";
  if (value.is_null()) return "null";
  if (!value.is_text()) return plain_text(value);
  const nlohmann::json text(value.text());
  const std::string shown = text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return shown.size() <= 40 ? shown : shown.substr(0, 37) + "...";
}

}  // namespace mirada::vm
