#include "base/files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/messages.h"

namespace mirada {
namespace fs = std::filesystem;

Result<std::string> read_file(const fs::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    return make_fault(path.string(), messages::file_missing, {{"file", path.string()}});
  if (fs::is_directory(status))
    return make_fault(path.string(), messages::file_is_folder, {{"file", path.string()}});
  std::ifstream in(path, std::ios::binary);
  if (!in) return make_fault(path.string(), messages::file_unreadable, {{"file", path.string()}});
  const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
  std::string bytes;
  bytes.reserve(size <= max_bytes ? size : 0);
  char chunk[65536];
  while (in.read(chunk, sizeof chunk) || in.gcount() > 0) {
    bytes.append(chunk, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > max_bytes) {
      return make_fault(path.string(), messages::file_too_large,
                        {{"file", path.string()}, {"limit_mib", std::to_string(max_bytes >> 20)}});
    }
  }
  return bytes;
}

namespace {

Fault write_fault(const fs::path& path) {
  return make_fault(path.string(), messages::file_not_written,
                    {{"file", path.string()}, {"reason", std::strerror(errno)}});
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// So that a power cut does not bring the old file back. Some file systems cannot; they are as safe as they
/// are.
void sync_folder(const fs::path& folder) {
  const int fd = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  (void)::fsync(fd);
  ::close(fd);
}

}  // namespace

Status write_file_atomically(const fs::path& path, std::string_view bytes, unsigned mode) {
  const fs::path temporary = path.string() + ".new";
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
  if (fd < 0) return write_fault(path);
  // An old temporary file has kept its rights; the umask counts all the same for those asked of all.
  const bool safe = mode == 0644 || ::fchmod(fd, mode) == 0;
  const bool written = safe && write_all(fd, bytes) && ::fsync(fd) == 0;
  const bool closed = ::close(fd) == 0;
  if (!written || !closed || ::rename(temporary.c_str(), path.c_str()) != 0) {
    const Fault fault = write_fault(path);
    ::unlink(temporary.c_str());
    return fault;
  }
  sync_folder(path.parent_path());
  return Ok{};
}

std::string file_mark(const fs::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return "";
  return std::to_string(found.st_ino) + " " + std::to_string(found.st_size) + " " +
         std::to_string(found.st_mtim.tv_sec) + "." + std::to_string(found.st_mtim.tv_nsec);
}

FileLock::FileLock(const fs::path& path)
    : fd_(::open((path.string() + ".lock").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600)) {
  while (fd_ >= 0 && ::flock(fd_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

FileLock::~FileLock() {
  if (fd_ >= 0) ::close(fd_);
}

fs::path data_folder(std::string_view name) {
  if (const char* root = std::getenv("MIRADA_DATA")) return fs::path(root) / name;
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = executable.parent_path().parent_path() / "share/mirada" / name;
  if (fs::exists(installed, error)) return installed;
  for (fs::path up = executable.parent_path(); up.has_relative_path(); up = up.parent_path()) {
    if (fs::exists(up / "CMakePresets.json", error) && fs::exists(up / name, error)) return up / name;
  }
  return fs::path(name);
}

}  // namespace mirada
