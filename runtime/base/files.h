#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace mirada {

/// The whole file as bytes; a fault in words when it is missing, a folder, unreadable or larger than
/// `max_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t max_bytes = 64u << 20);

/// Writes beside the file, syncs and renames, so that a power cut leaves the old or the new file, never half
/// of one. The file has the rights `mode`, less what the umask takes.
Status write_file_atomically(const std::filesystem::path& path, std::string_view bytes, unsigned mode = 0644);

/// Another one whenever the file was written anew, by whomever; "" when there is none.
std::string file_mark(const std::filesystem::path& path);

/// While it lives, others who ask for the same file wait, in this program and in any other (flock of a file
/// beside it). Where that file cannot be made, nobody waits.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int fd_;
};

/// The folder that holds a data folder such as "blocks", "ui/dist", "runtime/model/robots" or
/// "runtime/world/rooms": found relative to the executable, in a build tree (the source tree above it) or
/// installed (../share/mirada). MIRADA_DATA in the environment overrides it.
std::filesystem::path data_folder(std::string_view name);

}  // namespace mirada
