#include "server/examples.h"

#include <algorithm>
#include <tuple>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "server/json_text.h"

namespace mirada::server {
namespace fs = std::filesystem;
namespace {

Result<Example> read_example(const fs::path& file, const std::string& pack) {
  const Result<std::string> text = read_file(file, 4u << 20);
  if (!text.ok()) return text.faults();
  const Result<nlohmann::json> parsed = parse_json(*text, file.string());
  if (!parsed.ok()) return parsed.faults();
  Faults faults;
  JsonReader in(*parsed, "", faults);
  Example example;
  example.id = file.stem().string();
  example.pack = pack;
  example.name_en = example.name_es = in.text("name");
  if (auto names = in.object_if_present("names")) {
    example.name_en = names->text("en");
    example.name_es = names->text("es");
  }
  example.order = in.number_or("order", 0, 1e6, example.order);
  example.program_json = *text;
  for (Fault& fault : faults) fault.place = file.string() + fault.place;
  if (!faults.empty()) return faults;
  return example;
}

}  // namespace

std::vector<Example> load_examples(const fs::path& folder, const packs::PackSet& packs, Faults& faults) {
  std::vector<Example> examples;
  for (const packs::Pack& pack : packs.packs) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / pack.id / "examples", error)) {
      if (entry.path().extension() != ".json") continue;
      Result<Example> example = read_example(entry.path(), pack.id);
      if (example.ok()) {
        examples.push_back(std::move(example).value());
      } else {
        faults.insert(faults.end(), example.faults().begin(), example.faults().end());
      }
    }
  }
  std::sort(examples.begin(), examples.end(), [](const Example& a, const Example& b) {
    return std::tie(a.order, a.pack, a.id) < std::tie(b.order, b.pack, b.id);
  });
  return examples;
}

}  // namespace mirada::server
