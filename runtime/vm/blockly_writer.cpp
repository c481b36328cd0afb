#include "vm/blockly_writer.h"

#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "vm/literal.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

// Where scripts are put: a column a sprite, a row a block, in Blockly's units.
constexpr int kColumn = 480;
constexpr int kRow = 56;

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// A text that is written as a number in a number's slot.
bool is_plain_number(const std::string& text) {
  const double number = string_to_number(text);
  return number == number && !is_blank(text) && number - number == 0;
}

const char* type_of(const std::string& placeholder) {
  return placeholder == "%b" ? "boolean" : "text";  // Scratch keeps what a %n gets as it comes
}

/// "jump %s times %b" -> "jump times", and the types of its parameters.
struct Heading {
  std::string name{};
  std::vector<std::string> types{};
};
Heading heading_of(const std::string& code) {
  Heading out;
  std::size_t at = 0;
  while (at < code.size()) {
    const std::size_t space = std::min(code.find(' ', at), code.size());
    const std::string word = code.substr(at, space - at);
    at = space + 1;
    if (word == "%s" || word == "%n" || word == "%b") {
      out.types.emplace_back(type_of(word));
    } else if (!word.empty()) {
      out.name += (out.name.empty() ? "" : " ") + word;
    }
  }
  if (out.name.empty()) out.name = "block";
  return out;
}

class Writer {
 public:
  Writer(const Program& program, const BlockCatalog& catalog) : program_(program), catalog_(catalog) {
    for (const Block& block : program_.blocks) {
      if (block.opcode == "procedures_definition" && block.signature >= 0) {
        const Signature& signature = signature_of(block);
        definitions_.emplace(std::pair{block.sprite, signature.id}, &signature);
      }
    }
  }

  std::string write(const std::string& name) {
    std::string blocks = kept_values();
    // Scripts start from the top layer down; one canvas has one order.
    for (auto sprite = static_cast<std::int32_t>(program_.sprites.size()); sprite-- > 0;) {
      int row = 0;
      for (const BlockIndex top : program_.tops) {
        if (program_.at(top).sprite != sprite) continue;
        const std::string place =
            ",\"x\":" + std::to_string(40 + kColumn * sprite) + ",\"y\":" + std::to_string(40 + kRow * row);
        blocks += (blocks.empty() ? "" : ",") + chain(top, place);
        row += 2 + rows_of(top);
      }
    }
    // The variables come last: messages are found on the way through the blocks.
    std::string out = R"({"format":"mirada-program","version":1,"name":)" + quoted(name) + ",\"packs\":[";
    std::string packs;
    for (const std::string& pack : packs_) packs += (packs.empty() ? "" : ",") + quoted(pack);
    return out + packs + R"(],"workspace":{"blocks":{"languageVersion":0,"blocks":[)" + blocks +
           "]},\"variables\":" + variables() + "}}";
  }

 private:
  /// A first flag script that gives variables and lists what the file keeps in them: a program of ours starts
  /// with zeros and empty lists.
  std::string kept_values() {
    std::string chain;
    std::string end;
    const auto add = [&](const char* opcode, const std::string& field, const Variable& variable,
                         const char* input, const Field* value) {
      chain += ",\"next\":{\"block\":{\"type\":\"" + std::string(opcode) + "\",\"id\":\"kept " +
               std::to_string(end.size()) + "\",\"fields\":{\"" + field +
               "\":{\"id\":" + quoted(variable.id) + "}}";
      if (value) chain += ",\"inputs\":{\"" + std::string(input) + "\":{" + kept_literal(*value) + "}}";
      end += "}}";
      packs_.insert("data");
    };
    for (const Variable& variable : program_.variables) {
      const bool zero = variable.initial.is_number && variable.initial.value == "0";
      if (variable.kind == VariableKind::scalar && !zero) {
        add("data_setvariableto", "VARIABLE", variable, "VALUE", &variable.initial);
      }
      if (variable.initial_items.empty() || variable.initial_items.size() > kMostKeptItems) continue;
      add("data_deletealloflist", "LIST", variable, "", nullptr);
      for (const Field& item : variable.initial_items) add("data_addtolist", "LIST", variable, "ITEM", &item);
    }
    if (chain.empty()) return {};
    packs_.insert("events");
    return "{\"type\":\"event_whenflagclicked\",\"id\":\"kept\",\"x\":40,\"y\":-400" + chain + end + "}";
  }

  /// What a socket holds; an empty "not" is true, an empty "and" is false.
  std::string kept_literal(const Field& field) {
    if (field.is_truth) {
      packs_.insert("operators");
      return field.value == "true" ? R"("block":{"type":"operator_not"})"
                                   : R"("block":{"type":"operator_and"})";
    }
    if (field.is_number && is_plain_number(field.value)) {
      return R"("shadow":{"type":"math_number","fields":{"NUM":)" + field.value + "}}";
    }
    return R"("shadow":{"type":"text","fields":{"TEXT":)" + quoted(field.value) + "}}";
  }

  const Signature& signature_of(const Block& block) const {
    return program_.signatures[static_cast<std::size_t>(block.signature)];
  }
  const std::string& sprite_name(std::int32_t sprite) const {
    return program_.sprites[static_cast<std::size_t>(sprite)].name;
  }
  std::string shown_name(const std::string& name, std::int32_t sprite) const {
    return sprite == 0 ? name : sprite_name(sprite) + ": " + name;
  }

  /// How many rows a stack takes, mouths within mouths not counted.
  int rows_of(BlockIndex first) const {
    int rows = 0;
    for (BlockIndex at = first; at != kNone; at = program_.at(at).next) {
      ++rows;
      for (const Input& input : program_.at(at).inputs) {
        if (!input.name.starts_with("SUBSTACK")) continue;
        for (BlockIndex in = input.block; in != kNone; in = program_.at(in).next) ++rows;
      }
    }
    return rows;
  }

  std::string variables() const {
    std::string out;
    const auto add = [&](const std::string& name, const std::string& id, const char* type) {
      out += (out.empty() ? "" : ",") + ("{\"name\":" + quoted(name)) + ",\"id\":" + quoted(id) +
             ",\"type\":\"" + type + "\"}";
    };
    for (const Variable& variable : program_.variables) {
      const bool list = variable.kind == VariableKind::list;
      add(shown_name(variable.name, variable.sprite), variable.id, list ? "list" : "");
    }
    for (const std::string& message : messages_) add(message, "message " + message, "broadcast_msg");
    return "[" + out + "]";
  }

  /// A stack of blocks: along `next` without recursion, however long it is.
  std::string chain(BlockIndex first, const std::string& place = "") {
    std::string out;
    std::string end;
    for (BlockIndex at = first; at != kNone; at = program_.at(at).next) {
      if (at != first) out += ",\"next\":{\"block\":";
      out += "{" + parts(program_.at(at)) + (at == first ? place : "");
      end += at == first ? "}" : "}}";
    }
    return out + end;
  }

  std::string parts(const Block& block) {
    const BlockDef* def = catalog_.find(block.opcode);
    const bool known = def && def->implementation != Implementation::native;
    const bool say = def && block.opcode.starts_with("looks_say");
    if (def && (known || say)) packs_.insert(def->pack);
    std::string out =
        "\"type\":" + quoted(type_for(block, def, known || say)) + ",\"id\":" + quoted(block.id);
    if (block.signature >= 0) out += ",\"extraState\":" + signature(block);
    return out + fields(block) + inputs(block, known || say ? def : nullptr);
  }

  /// A robot's block of the same name means something else.
  static std::string type_for(const Block& block, const BlockDef* def, bool known) {
    return def && !known ? "scratch_" + block.opcode : block.opcode;
  }

  /// The definition's; a call carries a copy, which may be an old one.
  const Signature& real_signature(const Block& block) const {
    const Signature& said = signature_of(block);
    const auto it = definitions_.find({block.sprite, said.id});
    return it == definitions_.end() ? said : *it->second;
  }

  std::string signature(const Block& block) const {
    const Signature& real = real_signature(block);
    const Heading heading = heading_of(real.name);
    std::string params;
    for (std::size_t i = 0; i < real.params.size(); ++i) {
      const std::string type = i < heading.types.size() ? heading.types[i] : "text";
      params += (i ? "," : "") + ("{\"id\":" + quoted(real.params[i].id)) +
                ",\"name\":" + quoted(real.params[i].name) + ",\"type\":" + quoted(type) + "}";
    }
    return "{\"id\":" + quoted(std::to_string(block.sprite) + "/" + real.id) +
           ",\"name\":" + quoted(shown_name(heading.name, block.sprite)) + ",\"params\":[" + params +
           "],\"returns\":false,\"warp\":" + (real.warp ? "true" : "false") + "}";
  }

  std::string fields(const Block& block) {
    std::string out;
    for (const Field& field : block.fields) {
      std::string value = quoted(field.value);
      if (!field.id.empty()) value = "{\"id\":" + quoted(field.id) + "}";
      if (field.name.starts_with("BROADCAST_")) {
        messages_.insert(field.value);
        value = "{\"id\":" + quoted("message " + field.value) + "}";
      }
      out += (out.empty() ? "" : ",") + quoted(field.name) + ":" + value;
    }
    return out.empty() ? out : ",\"fields\":{" + out + "}";
  }

  std::string inputs(const Block& block, const BlockDef* def) {
    std::string out;
    for (const Input& input : block.inputs) {
      std::string content;
      if (input.shadow != kNone) content = "\"shadow\":" + shadow(program_.at(input.shadow), input.name, def);
      if (input.block != kNone) content += (content.empty() ? "" : ",") + ("\"block\":" + chain(input.block));
      if (content.empty()) continue;
      out += (out.empty() ? "" : ",") + quoted(input.name) + ":{" + content + "}";
    }
    if (block.opcode == "procedures_call" && block.signature >= 0) {
      for (const std::string& fallback : fallbacks(block)) out += (out.empty() ? "" : ",") + fallback;
    }
    return out.empty() ? out : ",\"inputs\":{" + out + "}";
  }

  /// What a call's empty slots stand for in Scratch; an empty truth is false here too.
  std::vector<std::string> fallbacks(const Block& block) const {
    std::vector<std::string> out;
    for (const Parameter& param : real_signature(block).params) {
      const Input* given = block.input(param.id);
      if ((given && given->content() != kNone) || param.fallback.empty() || param.fallback == "false")
        continue;
      out.push_back(quoted(param.id) + R"(:{"shadow":{"type":"text","fields":{"TEXT":)" +
                    quoted(param.fallback) + "}}}");
    }
    return out;
  }

  /// A literal as the socket wants it: a number's field where a number stands in a number's socket.
  std::string shadow(const Block& block, const std::string& socket, const BlockDef* def) {
    const Field* literal = literal_field(block);
    if (!literal) return "{" + parts(block) + "}";
    bool wants_number = false;
    if (def) {
      for (const ArgDef& arg : def->args)
        wants_number = wants_number || (arg.name == socket && arg.type == ArgType::number);
    }
    const std::string id = ",\"id\":" + quoted(block.id);
    // What prints otherwise stays as it is written: "1.0" draws no whole numbers.
    const bool same = is_plain_number(literal->value) &&
                      number_to_string(string_to_number(literal->value)) == literal->value;
    if (literal->is_number ? is_plain_number(literal->value) : wants_number && same) {
      return "{\"type\":\"math_number\"" + id +
             ",\"fields\":{\"NUM\":" + nlohmann::json(string_to_number(literal->value)).dump() + "}}";
    }
    return "{\"type\":\"text\"" + id + ",\"fields\":{\"TEXT\":" + quoted(literal->value) + "}}";
  }

  const Program& program_;
  const BlockCatalog& catalog_;
  std::map<std::pair<std::int32_t, std::string>, const Signature*> definitions_;
  std::set<std::string> packs_;
  std::set<std::string> messages_;
};

}  // namespace

std::string write_blockly(const Program& program, const BlockCatalog& catalog, const std::string& name) {
  return Writer(program, catalog).write(name);
}

}  // namespace mirada::vm
