#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "packs/packs.h"

namespace mirada::server {

/// A program that ships with a pack.
struct Example {
  std::string id;  ///< the file's name without ".json"
  std::string pack;
  std::string name_en;
  std::string name_es;
  std::string program_json;
  double order = 1000;
};

/// Every <folder>/<pack>/examples/*.json of these packs: by the envelope's "order" (the first is opened on a
/// first visit), then by pack and id. Its name is the envelope's "names" {en, es}, or "name". A file that
/// cannot be read is left out and told in `faults`.
std::vector<Example> load_examples(const std::filesystem::path& folder, const packs::PackSet& packs,
                                   Faults& faults);

}  // namespace mirada::server
