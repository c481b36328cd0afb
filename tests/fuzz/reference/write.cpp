// A tree as the editor would save it.
#include "fuzz/reference/tree.h"

namespace mirada::vm::reference {
namespace {

using Json = nlohmann::json;

Json named(const char* what, int number) { return {{"id", what + std::to_string(number)}}; }

std::string type_of(char param) { return param == 'n' ? "number" : param == 't' ? "text" : "boolean"; }

class Writer {
 public:
  explicit Writer(const Tree& tree) : tree_(tree) {}

  Json write() {
    Json tops = Json::array();
    for (std::size_t i = 0; i < tree_.blocks.size(); ++i) {
      Json head = block("procedures_definition");
      head["extraState"] = signature(static_cast<int>(i));
      definition_ = static_cast<int>(i);
      tops.push_back(under(std::move(head), tree_.blocks[i].body));
      definition_ = -1;
    }
    for (const Script& script : tree_.scripts) {
      Json head = block(script.message < 0 ? "event_whenflagclicked" : "event_whenbroadcastreceived");
      if (script.message >= 0) head["fields"]["BROADCAST_OPTION"] = named("m", script.message);
      tops.push_back(under(std::move(head), script.body));
    }
    Json variables = Json::array();
    const auto declare = [&](const char* what, const char* type, int count) {
      for (int i = 0; i < count; ++i) {
        const std::string name = what + std::to_string(i);
        variables.push_back({{"name", name}, {"id", name}, {"type", type}});
      }
    };
    declare("v", "", kVariables);
    declare("L", "list", kLists);
    declare("m", "broadcast_msg", kMessages);
    return {{"workspace", {{"blocks", {{"blocks", tops}}}, {"variables", variables}}}};
  }

 private:
  Json block(const std::string& type) { return {{"type", type}, {"id", "b" + std::to_string(next_++)}}; }

  Json under(Json head, const std::vector<Node>& body) {
    if (!body.empty()) head["next"]["block"] = stack(body);
    return head;
  }
  Json stack(const std::vector<Node>& nodes) {
    Json out;
    for (std::size_t i = nodes.size(); i-- > 0;) {
      Json one = json_of(nodes[i]);
      if (!out.is_null()) one["next"]["block"] = std::move(out);
      out = std::move(one);
    }
    return out;
  }

  Json signature(int number) {
    const MyBlock& my = tree_.blocks[static_cast<std::size_t>(number)];
    Json params = Json::array();
    for (std::size_t i = 0; i < my.params.size(); ++i) {
      const std::string name = "p" + std::to_string(i);
      params.push_back({{"id", name}, {"name", name}, {"type", type_of(my.params[i])}});
    }
    const std::string id = "f" + std::to_string(number);
    return {{"id", id}, {"name", id}, {"params", params}, {"returns", my.returns}, {"warp", my.warp}};
  }

  /// The names of a block's sockets, in the order of Node::inputs.
  static std::vector<std::string> sockets(const Node& node) {
    const std::string& op = node.opcode;
    if (op == "operator_letter_of") return {"LETTER", "STRING"};
    if (op == "operator_join" || op == "operator_contains") return {"STRING1", "STRING2"};
    if (op == "operator_length") return {"STRING"};
    if (op == "operator_round" || op == "operator_mathop") return {"NUM"};
    if (op == "operator_not") return {"OPERAND"};
    if (op == "operator_lt" || op == "operator_gt" || op == "operator_equals" || op == "operator_and" ||
        op == "operator_or") {
      return {"OPERAND1", "OPERAND2"};
    }
    if (op.starts_with("operator_")) return {"NUM1", "NUM2"};
    if (op == "data_itemoflist" || op == "data_deleteoflist") return {"INDEX"};
    if (op == "data_insertatlist" || op == "data_replaceitemoflist") return {"INDEX", "ITEM"};
    if (op == "data_addtolist" || op == "data_itemnumoflist" || op == "data_listcontainsitem")
      return {"ITEM"};
    if (op == "control_repeat") return {"TIMES"};
    if (op == "control_for_each" || op == "data_setvariableto" || op == "data_changevariableby" ||
        op == "procedures_return") {
      return {"VALUE"};
    }
    return {"CONDITION"};
  }

  Json json_of(const Node& node) {
    const std::string& op = node.opcode;
    if (op == "param") return parameter(node);
    Json out = block(op);
    if (op.starts_with("procedures_call")) {
      out["extraState"] = signature(node.name);
      for (std::size_t i = 0; i < node.inputs.size(); ++i)
        out["inputs"]["p" + std::to_string(i)] = socket(node.inputs[i]);
      return out;
    }
    const std::vector<std::string> names = sockets(node);
    for (std::size_t i = 0; i < node.inputs.size(); ++i) out["inputs"][names[i]] = socket(node.inputs[i]);
    if (!node.first.empty()) out["inputs"]["SUBSTACK"]["block"] = stack(node.first);
    if (!node.second.empty()) out["inputs"]["SUBSTACK2"]["block"] = stack(node.second);
    fields(node, out);
    return out;
  }

  static void fields(const Node& node, Json& out) {
    const std::string& op = node.opcode;
    if (op == "operator_mathop") out["fields"]["OPERATOR"] = node.text;
    if (op == "control_stop") out["fields"]["STOP_OPTION"] = "this script";
    if (op.starts_with("event_broadcast")) out["fields"]["BROADCAST_INPUT"] = named("m", node.name);
    if (op == "data_for_each_item") out["fields"]["LIST"] = {{"id", "L" + node.text}};
    const bool list = op.find("list") != std::string::npos;
    if (list) out["fields"]["LIST"] = named("L", node.name);
    const bool variable =
        op.find("variable") != std::string::npos || op == "control_for_each" || op == "data_for_each_item";
    if (variable) out["fields"]["VARIABLE"] = named("v", node.name);
  }

  Json parameter(const Node& node) {
    const MyBlock& my = tree_.blocks[static_cast<std::size_t>(definition_)];
    const bool truth = my.params[static_cast<std::size_t>(node.name)] == 'b';
    Json out = block(truth ? "argument_reporter_boolean" : "argument_reporter_string_number");
    out["fields"]["VALUE"] = "p" + std::to_string(node.name);
    return out;
  }

  Json socket(const Node& node) {
    if (node.opcode == "text") {
      Json shadow = block("text");
      shadow["fields"]["TEXT"] = node.text;
      return {{"shadow", shadow}};
    }
    if (node.opcode == "number") {
      Json shadow = block("math_number");
      shadow["fields"]["NUM"] = node.number;
      return {{"shadow", shadow}};
    }
    return {{"block", json_of(node)}};
  }

  const Tree& tree_;
  int next_ = 0;
  int definition_ = -1;
};

}  // namespace

Json to_json(const Tree& tree) { return Writer(tree).write(); }

}  // namespace mirada::vm::reference
