#include <algorithm>

#include "base/files.h"
#include "world/messages.h"
#include "world/world_config.h"

namespace mirada::world {
namespace {

namespace fs = std::filesystem;

bool looks_like_path(const std::string& name) {
  return name.find('/') != std::string::npos || fs::path(name).extension() == ".json";
}

}  // namespace

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> out;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(data_folder("runtime/world/rooms"), error)) {
    if (entry.path().extension() == ".json") out.push_back(entry.path().stem().string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

Result<WorldConfig> world_by_name(const std::string& id_or_path, Faults* warnings) {
  const std::vector<std::string> known = shipped_worlds();
  fs::path file = id_or_path;
  if (std::find(known.begin(), known.end(), id_or_path) != known.end()) {
    file = data_folder("runtime/world/rooms") / (id_or_path + ".json");
  } else if (!looks_like_path(id_or_path)) {
    std::string list;
    for (const std::string& id : known) list += (list.empty() ? "" : ", ") + id;
    return make_fault(id_or_path, messages::world_unknown, {{"name", id_or_path}, {"known", list}});
  }
  const Result<std::string> text = read_file(file, 4u << 20);
  if (!text) return text.faults();
  return read_world(*text, file.string(), warnings);
}

}  // namespace mirada::world
