#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mirada::vm::reference {

/// A program for comparing: small, plain, and written down twice, as JSON for the machine and as this tree
/// for the reference evaluator.
struct Node {
  std::string opcode{};        ///< ours; "number" and "text" are literals, "param" a parameter
  std::string text{};          ///< of a text literal, a menu
  double number = 0;           ///< of a number literal
  int name = 0;                ///< which variable, list, message, my block or parameter
  std::vector<Node> inputs{};  ///< in the order in which they are worked out
  std::vector<Node> first{};   ///< the mouth
  std::vector<Node> second{};  ///< the mouth behind "else"
};

struct MyBlock {
  std::string params{};  ///< one letter each: n number, t text, b boolean
  bool returns = false;
  bool warp = false;
  std::vector<Node> body{};
};

struct Script {
  int message = -1;  ///< what starts it; -1: the flag
  std::vector<Node> body{};
};

struct Tree {
  std::vector<MyBlock> blocks{};
  std::vector<Script> scripts{};
};

constexpr int kVariables = 3;
constexpr int kLists = 2;
constexpr int kMessages = 2;

/// A valid program made out of bytes: the same bytes, the same program.
Tree grow(const std::uint8_t* data, std::size_t size);
/// The program in the editor's format.
nlohmann::json to_json(const Tree& tree);

}  // namespace mirada::vm::reference
