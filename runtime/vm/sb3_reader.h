#pragma once
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "vm/json_tree.h"
#include "vm/reader.h"

namespace mirada::vm {

/// Turns a Scratch project's JSON into the tree that the editor's programs become. What has the wrong form
/// is an error; what Scratch itself would shrug off (a block that is not there, a circle) a warning. Parts
/// within the program only; use read_scratch_project.
class ProjectReader {
 public:
  explicit ProjectReader(ReadProgram& out) : out_(out), program_(out.program) {}
  void read(JsonValue project);

 private:
  struct Target {
    JsonValue json;
    std::string path;
  };
  struct Task {
    JsonValue json;
    BlockIndex index;
  };

  void error(std::string place, const Message& message, MessageArgs args = {});
  void warning(std::string place, const Message& message, MessageArgs args = {});
  void wrong(const std::string& place, const char* expected, JsonValue value);
  /// A field that must be an object where it is there; nothing when it is not.
  JsonValue object_field(JsonValue json, const char* name, const std::string& folder);
  JsonValue object_field(const Task& task, const char* name);
  std::string path_of(const Task& task) const { return path_ + "/" + std::string(task.json.key()); }

  // sb3_reader.cpp: targets and their variables
  std::vector<Target> order_targets(JsonValue targets);
  void read_variables(const Target& target);
  void read_values(const Target& target, const char* field, VariableKind kind);
  std::size_t add_variable(const std::string& id, const std::string& name, VariableKind kind);
  std::string variable_id(const std::string& name, const std::string& id, VariableKind kind);
  const std::string* known_variable(std::int32_t sprite, const std::string& id, const std::string& name,
                                    VariableKind kind) const;
  void find_cloned();
  void find_values_of_sprites();

  // sb3_blocks.cpp
  void read_scripts(const Target& target);
  BlockIndex add_block(const std::string& id, BlockIndex parent, BlockIndex enclosing);
  BlockIndex add_literal(JsonValue value, BlockIndex parent);
  BlockIndex add_named(const char* opcode, const char* field, JsonValue primitive, VariableKind kind,
                       BlockIndex parent);
  BlockIndex add_content(JsonValue content, const Task& task, std::string_view name);
  void fill(const Task& task);
  void read_next(const Task& task);
  void read_fields(const Task& task);
  void read_inputs(const Task& task);
  void read_input(const Task& task, const std::string& name, JsonValue value);
  void settle(Block& block);
  void read_definition(const Task& task);
  void read_call(const Task& task);
  std::vector<std::string> text_list(JsonValue mutation, const char* name, const Task& task);

  ReadProgram& out_;
  Program& program_;
  std::int32_t sprite_ = 0;
  std::string path_;                                        // of this target
  std::unordered_map<std::string_view, JsonValue> blocks_;  // of this target
  std::unordered_set<std::string> reached_;
  std::vector<Task> tasks_;
  /// Sprite, kind, and "#id" or "=name" -> the variable's id in the program.
  std::map<std::tuple<std::int32_t, VariableKind, std::string>, std::string> known_;
  std::unordered_set<std::string> variable_ids_;
};

}  // namespace mirada::vm
