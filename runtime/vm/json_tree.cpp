#include "vm/json_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "vm/json_scanner.h"
#include "vm/numbers.h"

namespace mirada::vm {

/// Lines up what the scanner finds.
class JsonTree::Builder {
 public:
  Builder(std::string_view text, JsonTree& out) : scan_(text), out_(out) {
    out_.letters_.reserve(text.size());
  }

  void build() {
    while (!scan_.broken() && (wants_value_ || !open_.empty())) {
      wants_value_ ? value() : follow();
    }
    if (!scan_.broken() && !scan_.at_end()) scan_.fail();
    if (!scan_.broken()) return;
    out_.broken_ = Broken{scan_.place(), scan_.number_too_large()};
    out_.nodes_.clear();
  }

 private:
  using Kind = JsonValue::Kind;

  void value() {
    const char first = scan_.peek();
    if (first == '{') return open(Kind::object);
    if (first == '[') return open(Kind::array);
    wants_value_ = false;
    if (scan_.take('"')) return add({.text = letters(), .kind = Kind::text});
    if (first == 't') return word("true", {.number = 1, .kind = Kind::truth});
    if (first == 'f') return word("false", {.kind = Kind::truth});
    if (first == 'n') return word("null", {});
    add({.number = scan_.number(), .kind = Kind::number});
  }
  /// What comes behind a value in a list or an object.
  void follow() {
    const bool object = out_.nodes_[open_.back()].kind == Kind::object;
    if (scan_.take(object ? '}' : ']')) return close();
    if (!scan_.take(',')) return scan_.fail();
    if (object) key();
    wants_value_ = true;
  }
  void key() {
    if (!scan_.take('"')) return scan_.fail();
    key_ = letters();
    if (!scan_.take(':')) scan_.fail();
  }
  Letters letters() {
    const auto first = static_cast<std::uint32_t>(out_.letters_.size());
    return {first, static_cast<std::uint32_t>(scan_.text(out_.letters_))};
  }
  void word(std::string_view wanted, Node node) {
    scan_.word(wanted);
    add(node);
  }
  void add(Node node) {
    node.key = std::exchange(key_, {});
    out_.nodes_.push_back(node);
    if (!open_.empty()) ++out_.nodes_[open_.back()].size;
  }
  void open(Kind kind) {
    const bool object = kind == Kind::object;
    add({.kind = kind});
    open_.push_back(static_cast<std::uint32_t>(out_.nodes_.size()) - 1);
    scan_.take(object ? '{' : '[');
    if (scan_.take(object ? '}' : ']')) return close();
    if (object) key();
  }
  void close() {
    const std::uint32_t index = open_.back();
    open_.pop_back();
    out_.nodes_[index].span = static_cast<std::uint32_t>(out_.nodes_.size()) - index;
    wants_value_ = false;
  }

  JsonScanner scan_;
  JsonTree& out_;
  Letters key_{};
  std::vector<std::uint32_t> open_;
  bool wants_value_ = true;
};

JsonTree JsonTree::parse(std::string_view text) {
  JsonTree out;
  Builder(text, out).build();
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
  if (!value.is_number()) return {};
  const double number = value.number();
  // As a text zero has no sign; as a number 1 / -0 is another than 1 / 0.
  return number == 0 && std::signbit(number) ? "-0" : number_to_string(number);
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
