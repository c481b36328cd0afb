#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "vm/catalog.h"

namespace mirada::vm {

using BlockIndex = std::int32_t;
constexpr BlockIndex kNone = -1;

/// A field as it stands in the file. `value` is its text (a number in JavaScript's form); `id` names a
/// variable, list or message.
struct Field {
  std::string name{};
  std::string value{};
  std::string id{};
  bool is_number = false;  ///< written as a JSON number
  bool is_truth = false;   ///< written as a JSON truth; only initial values of Scratch projects are
};

/// A socket: the block in it wins over the shadow beneath. For a mouth, `block` is the first of the stack.
struct Input {
  std::string name{};
  BlockIndex block = kNone;
  BlockIndex shadow = kNone;
  BlockIndex content() const { return block != kNone ? block : shadow; }
};

enum class ParamType { number, text, truth, raw };  ///< raw: Scratch's, as it comes
struct Parameter {
  std::string id{};
  std::string name{};
  ParamType type = ParamType::number;
  std::string fallback{};  ///< of a raw one: what a call without it gives
};

/// A my-block's head; calls carry a copy, the definition's counts.
struct Signature {
  std::string id{};
  std::string name{};
  std::vector<Parameter> params{};
  bool returns = false;
  bool warp = false;
};

struct Block {
  std::string id{};
  std::string opcode{};
  const BlockDef* def = nullptr;  ///< null: unknown, or a literal shadow
  std::vector<Field> fields{};
  std::vector<Input> inputs{};
  BlockIndex next = kNone;
  BlockIndex parent =
      kNone;  ///< the block whose socket or mouth it is in, or that it follows; none at the top
  BlockIndex enclosing = kNone;  ///< the block whose socket or mouth its stack is in
  std::int32_t signature = -1;   ///< in Program::signatures
  std::int32_t sprite = 0;
  bool is_shadow = false;
  bool disabled = false;
  bool wanted_next = false;  ///< was in the file as something that is no block

  const Field* field(std::string_view name) const;
  const Input* input(std::string_view name) const;
};

enum class VariableKind { scalar, list, message };
/// A variable, list or message that the file declares. `sprite` is 0 for everybody's.
struct Variable {
  std::string id{};
  std::string name{};
  VariableKind kind = VariableKind::scalar;
  std::int32_t sprite = 0;
  Field initial{};                     ///< value and is_number
  std::vector<Field> initial_items{};  ///< of a list
};

/// One sprite of an imported project; a program of ours has exactly one without a name.
struct Sprite {
  std::string name{};
  bool is_stage = true;
  bool is_cloned = false;  ///< some block may clone it: its variables live in each copy
};

/// A program as a tree in index form: no pointers, so nothing recurses when it is made, walked or destroyed.
struct Program {
  std::string name{};
  std::vector<std::string> packs{};
  std::vector<Block> blocks{};
  std::vector<BlockIndex> tops{};  ///< first blocks of stacks, in the order in which scripts start
  std::vector<Variable> variables{};
  std::vector<Signature> signatures{};
  std::vector<Sprite> sprites{Sprite{}};
  std::unordered_map<std::string, BlockIndex> by_id;
  bool from_scratch = false;
  std::shared_ptr<const BlockCatalog> scratch_blocks;  ///< of an imported project

  const Block& at(BlockIndex i) const { return blocks[static_cast<std::size_t>(i)]; }
  Block& at(BlockIndex i) { return blocks[static_cast<std::size_t>(i)]; }
};

/// The number of blocks that count against the limit, shadows left out.
std::size_t counted_blocks(const Program& program);

namespace limits {
constexpr std::size_t kProgramBytes = 4u << 20;
constexpr std::size_t kBlocks = 5'000;
constexpr std::size_t kScratchBlocks = 50'000;  ///< of an imported project
constexpr std::size_t kParameters = 255;        ///< of a my-block
constexpr int kNesting = 256;
}  // namespace limits

}  // namespace mirada::vm
