#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirada::vm {

class JsonTree;

/// A value within a JsonTree, or nothing (where a field is absent), which reads as null. As short-lived as
/// the tree; to be passed by value.
class JsonValue {
 public:
  enum class Kind : std::uint8_t { null, truth, number, text, array, object };
  class Iterator;

  JsonValue() = default;
  explicit operator bool() const { return tree_ != nullptr; }
  Kind kind() const;
  bool is_null() const { return kind() == Kind::null; }
  bool is_truth() const { return kind() == Kind::truth; }
  bool is_number() const { return kind() == Kind::number; }
  bool is_text() const { return kind() == Kind::text; }
  bool is_array() const { return kind() == Kind::array; }
  bool is_object() const { return kind() == Kind::object; }
  bool is_structured() const { return is_array() || is_object(); }

  bool truth() const;             ///< false when it is none
  double number() const;          ///< of a number
  std::string_view text() const;  ///< of a text
  std::string_view key() const;   ///< by which its object holds it

  // Of lists and objects; nothing has no parts.
  std::size_t size() const;
  bool empty() const { return size() == 0; }
  Iterator begin() const;  ///< in the order of the file
  Iterator end() const;
  JsonValue operator[](std::size_t i) const;  ///< of a list; walks there; nothing when it is shorter
  /// Of two fields with one name the last counts.
  JsonValue find(std::string_view key) const;
  /// The fields by name, each name once.
  std::vector<JsonValue> fields() const;

 private:
  friend class JsonTree;
  JsonValue(const JsonTree& tree, std::uint32_t index) : tree_(&tree), index_(index) {}

  const JsonTree* tree_ = nullptr;
  std::uint32_t index_ = 0;
};

/// JSON as one list of values, each before its parts: a program nested 10,000 deep is read, walked and let go
/// without recursing.
class JsonTree {
 public:
  struct Broken {
    std::size_t byte = 0;
    bool number_too_large = false;
  };

  /// Of at most 1 GiB of text.
  static JsonTree parse(std::string_view text);
  const std::optional<Broken>& broken() const { return broken_; }
  JsonValue root() const { return nodes_.empty() ? JsonValue() : JsonValue(*this, 0); }

 private:
  friend class JsonValue;
  class Builder;
  struct Letters {
    std::uint32_t first = 0;
    std::uint32_t size = 0;
  };
  struct Node {
    double number = 0;       ///< of a truth: 1 or 0
    Letters key{};           ///< of an object's field
    Letters text{};          ///< of a text
    std::uint32_t size = 0;  ///< parts of a list or an object
    std::uint32_t span = 1;  ///< values up to the next one beside it: itself and all within
    JsonValue::Kind kind = JsonValue::Kind::null;
  };
  std::string_view view(Letters letters) const {
    return std::string_view(letters_).substr(letters.first, letters.size);
  }

  std::vector<Node> nodes_;
  std::string letters_;
  std::optional<Broken> broken_;
};

class JsonValue::Iterator {
 public:
  explicit Iterator(JsonValue at) : at_(at) {}
  JsonValue operator*() const { return at_; }
  Iterator& operator++() {
    at_.index_ += at_.tree_->nodes_[at_.index_].span;
    return *this;
  }
  bool operator==(const Iterator& other) const { return at_.index_ == other.at_.index_; }

 private:
  JsonValue at_;
};

/// The text of a plain value, numbers in JavaScript's form; empty for anything else.
std::string plain_text(JsonValue value);
/// A value for a message: what is not plain is only hinted at.
std::string shown_json(JsonValue value);

}  // namespace mirada::vm
