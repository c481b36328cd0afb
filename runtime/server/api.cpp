#include "server/api.h"

#include <nlohmann/json.hpp>

#include "server/json_text.h"
#include "server/server_messages.h"
#include "vm/machine.h"
#include "vm/scratch_import.h"

namespace mirada::server {

using nlohmann::json;

std::string packs_json(const packs::PackSet& packs) {
  std::string out = R"({"packs":[)";
  for (const packs::Pack& pack : packs.packs) {
    if (out.back() != '[') out += ',';
    out += pack.manifest_json;
  }
  return out + "]}";
}

std::string setup_page_json(const session::Station& station, Lang lang) {
  return R"({"setup":)" + setup_json(station.setup()) + R"(,"worlds":)" + options_json(station.worlds()) +
         R"(,"robots":)" + options_json(station.robots()) + R"(,"cameras":)" +
         options_json(station.cameras()) + R"(,"lang":")" + (lang == Lang::es ? "es" : "en") + "\"}";
}

std::string examples_json(const std::vector<Example>& examples) {
  std::string out = R"({"examples":[)";
  for (const Example& example : examples) {
    if (out.back() != '[') out += ',';
    std::string head = dump({{"id", example.id},
                             {"pack", example.pack},
                             {"name", {{"en", example.name_en}, {"es", example.name_es}}}});
    head.pop_back();
    out += head + ",\"program\":" + example.program_json + "}";
  }
  return out + "]}";
}

std::string check_program(const std::string& program_json, const packs::PackSet& packs) {
  const Result<vm::LoadedProgram> loaded = vm::load_program(program_json, packs.catalog);
  return check_json(loaded.ok() ? loaded->warnings : loaded.faults());
}

std::string open_scratch(const std::string& bytes, const packs::PackSet& packs) {
  const vm::ImportedProject opened = vm::import_scratch(bytes, packs.catalog, "");
  const std::string program = opened.program_json.empty() ? "null" : opened.program_json;
  return "{\"program\":" + program + ",\"faults\":" + faults_json(opened.faults) + "}";
}

std::string plain_page(const Message& what, const MessageArgs& args, const Message* also) {
  std::string out =
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>Mirada</title><style>body{font:18px/1.5 system-ui,sans-serif;"
      "max-width:36rem;margin:15vh auto;padding:0 16px;color:#334}h1{font-size:28px}</style><h1>Mirada</h1>";
  for (const Lang lang : {Lang::en, Lang::es}) {
    out += lang == Lang::en ? "<p lang=\"en\">" : "<p lang=\"es\">";
    if (also) out += format(*also, {}, lang) + " ";
    out += format(what, args, lang) + "</p>";
  }
  return out + "</html>\n";
}

}  // namespace mirada::server
