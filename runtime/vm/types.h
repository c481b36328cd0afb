#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "vm/ast.h"

namespace mirada::vm {

/// What a place can hold, as a set.
using Types = std::uint8_t;
namespace type {
constexpr Types number = 1;
constexpr Types digits = 2;  ///< a text that some number prints as: "5"
constexpr Types text = 4;    ///< any other text
constexpr Types truth = 8;
constexpr Types any = 15;
}  // namespace type

constexpr bool is_bare(Types t) { return (t & ~(type::number | type::digits)) == 0; }
/// Bare, and some of it texts: vm/digits.h.
constexpr bool is_mixed(Types t) { return t == (type::number | type::digits); }

/// The program's my-blocks, variables and lists, and what each can hold: found by following all assignments
/// until nothing is new. A block's own parts are looked up here by the compiler too.
class TypeTable {
 public:
  TypeTable(const Program& program, const std::vector<bool>& runs);

  Types of_block(BlockIndex index) const;  ///< of a reporter or literal; an absent block is an empty text
  Types of_input(const Block& block, std::string_view input) const;
  Types variable(int index) const { return at(index); }
  Types parameter(int definition, std::size_t param) const {
    return at(first_parameter(definition) + static_cast<Place>(param));
  }
  Types returned(int definition) const { return at(place_returned(definition)); }

  /// The variable or list that a block's field names; -1 when it names none. A local one is its script's own.
  int variable_of(const Block& block, std::string_view field) const;
  /// The definition that a call means (index into definitions()); -1: none.
  int definition_of(const Block& call) const;
  int definition_named(const std::string& id, int sprite) const;
  /// The definition whose stack a block stands in; -1: none.
  int definition_around(BlockIndex index) const;
  const std::vector<BlockIndex>& definitions() const { return definitions_; }
  const Signature& signature(int definition) const;
  /// The parameter that an argument reporter means, -1 when none.
  int parameter_of(BlockIndex reporter) const;
  BlockIndex top_of(BlockIndex index) const { return top_of_[static_cast<std::size_t>(index)]; }

 private:
  /// What can hold a value: variables and lists (their index), then each definition's return value and
  /// parameters.
  using Place = int;
  /// What an expression can give: some types always, and what a place can hold.
  struct Source {
    Types always = 0;
    Place place = -1;
  };
  struct Assignment {
    Place to;
    Source from;
  };

  void find_tops();
  void add_variables();
  void add_definitions();
  bool falls_through(BlockIndex first) const;
  void collect_assignments();
  void collect(BlockIndex index);
  void collect_call(const Block& block);
  void assign(Place to, Source from) {
    if (to >= 0) assignments_.push_back({to, from});
  }
  void follow_assignments();
  Source source_of(BlockIndex index) const;
  Source source_of_input(const Block& block, std::string_view name) const;
  static Source literal(const Block& block);
  Types at(Place place) const { return types_[static_cast<std::size_t>(place)]; }
  Place place_returned(int definition) const { return places_[static_cast<std::size_t>(definition)]; }
  Place first_parameter(int definition) const { return place_returned(definition) + 1; }

  const Program& program_;
  const std::vector<bool>& runs_;
  std::vector<BlockIndex> top_of_;
  std::vector<BlockIndex> definitions_;
  std::map<std::pair<std::string_view, int>, int> definition_ids_;
  std::unordered_map<std::string_view, int> variable_ids_;
  std::vector<Types> types_;   ///< by place
  std::vector<Place> places_;  ///< by definition: of its return value, its parameters' follow
  std::vector<Assignment> assignments_;
};

}  // namespace mirada::vm
