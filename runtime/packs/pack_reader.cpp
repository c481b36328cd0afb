#include <set>

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "packs/block_reader.h"
#include "packs/messages.h"
#include "packs/packs.h"

namespace mirada::packs {
namespace {

bool is_colour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

void read_head(JsonReader& json, Pack& pack) {
  if (json.number("format", 1, 1e9) != 1) {
    json.fault("format", messages::wrong_format,
               {{"value", json.has("format") ? short_json(json.json()["format"]) : "-"}});
  }
  pack.id = json.text("id");
  if (!is_name(pack.id, false)) json.fault("id", messages::wrong_name, {{"value", pack.id}});
  pack.version = json.text("version");
  pack.order = json.number_or("order", 0, 1e6, 1000);
  const std::string colour = json.text("colour");
  if (!is_colour(colour)) json.fault("colour", messages::wrong_colour, {{"value", colour}});
  read_languages(json, "name");
  if (json.has("help")) read_languages(json, "help");
}

}  // namespace

Result<Pack> read_pack(const std::string& json_text, const std::string& file_name,
                       const vm::NativeTable& natives) {
  Result<nlohmann::json> parsed = parse_json(json_text, file_name);
  if (!parsed) return parsed.faults();
  Faults faults;
  JsonReader json(*parsed, "", faults);
  Pack pack;
  pack.manifest_json = json_text;
  read_head(json, pack);
  std::set<std::string> opcodes;
  for (JsonReader block : json.objects("blocks", 500)) {
    pack.blocks.push_back(read_block(block, pack.id, natives));
    const std::string& opcode = pack.blocks.back().opcode;
    if (!opcodes.insert(opcode).second) json.fault("blocks", messages::twice, {{"value", opcode}});
  }
  if (pack.blocks.empty()) json.fault("blocks", messages::empty_list);
  json.only({"format", "id", "version", "order", "colour", "name", "help", "blocks"});
  if (!has_errors(faults)) return pack;
  for (Fault& fault : faults) fault.place = file_name + fault.place;
  return faults;
}

}  // namespace mirada::packs
