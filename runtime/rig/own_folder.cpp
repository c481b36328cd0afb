#include "rig/own_folder.h"

#include <cstdlib>

namespace mirada::rig {
namespace fs = std::filesystem;

fs::path own_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0')
    return fs::path(data) / "mirada";
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : ".") / ".local/share/mirada";
}

fs::path known_faces_file() { return own_folder() / "faces/known.json"; }

}  // namespace mirada::rig
