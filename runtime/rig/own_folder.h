#pragma once
#include <filesystem>

namespace mirada::rig {

/// The user's own folder for what Mirada keeps: XDG_DATA_HOME/mirada, else ~/.local/share/mirada.
std::filesystem::path own_folder();

/// Where the known faces of this user's robots are kept.
std::filesystem::path known_faces_file();

}  // namespace mirada::rig
