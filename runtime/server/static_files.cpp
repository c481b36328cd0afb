#include "server/static_files.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/files.h"

namespace mirada::server {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMaxFileBytes = 16u << 20;

struct TypeRow {
  std::string_view ending;
  std::string_view type;
};
constexpr std::array<TypeRow, 20> kTypes{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".webmanifest", "application/manifest+json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".gif", "image/gif"},
    {".webp", "image/webp"},
    {".ico", "image/x-icon"},
    {".cur", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".mp3", "audio/mpeg"},
    {".ogg", "audio/ogg"},
    {".wav", "audio/wav"},
    {".txt", "text/plain; charset=utf-8"},
}};

std::string_view type_of(std::string_view path) {
  for (const TypeRow& row : kTypes) {
    if (path.ends_with(row.ending)) return row.type;
  }
  return "application/octet-stream";
}

/// A path of plain segments: anything that a file system could read in two ways is refused, so nothing is
/// decoded.
bool is_plain(std::string_view path) {
  const bool known = std::all_of(path.begin(), path.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' ||
           c == '-' || c == '_' || c == '.' || c == '~';
  });
  return known && path.size() < 512 && path.starts_with('/') && path.find("/.") == std::string_view::npos &&
         path.find("//") == std::string_view::npos;
}

bool is_inside(const fs::path& file, const fs::path& folder) {
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

/// A build gives /assets/name-8BytHash.js.
bool is_hashed(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::size_t dot = name.find('.');
  return path.starts_with("/assets/") && dot != std::string_view::npos && dot > 9 && name[dot - 9] == '-';
}

}  // namespace

std::optional<StaticFile> StaticFiles::find(std::string_view target, bool gzip_accepted) const {
  std::string path(target.substr(0, target.find('?')));
  if (path == "/") path = "/index.html";
  if (!is_plain(path)) return std::nullopt;
  std::error_code error;
  const fs::path root = fs::canonical(folder_, error);
  if (error) return std::nullopt;
  fs::path file = fs::canonical(root / path.substr(1), error);
  if (error || !is_inside(file, root) || !fs::is_regular_file(file, error)) return std::nullopt;
  StaticFile out;
  const fs::path packed = file.string() + ".gz";
  if (gzip_accepted && fs::symlink_status(packed, error).type() == fs::file_type::regular) {
    file = packed;
    out.gzip = true;
  }
  Result<std::string> bytes = read_file(file, kMaxFileBytes);
  if (!bytes.ok()) return std::nullopt;
  const auto written =
      static_cast<std::uint64_t>(fs::last_write_time(file, error).time_since_epoch().count());
  out.bytes = std::move(bytes).value();
  out.type = type_of(path);
  out.etag = fmt::format("\"{:x}-{:x}{}\"", written, out.bytes.size(), out.gzip ? "-gz" : "");
  out.immutable = is_hashed(path);
  return out;
}

bool StaticFiles::built() const {
  std::error_code error;
  return fs::is_regular_file(folder_ / "index.html", error);
}

bool accepts_gzip(std::string_view accept_encoding) {
  const std::size_t at = accept_encoding.find("gzip");
  if (at == std::string_view::npos) return false;
  std::string weight(accept_encoding.substr(at + 4, accept_encoding.find(',', at) - at - 4));
  std::erase(weight, ' ');
  return !weight.starts_with(";q=0") || weight.find_first_of("123456789") != std::string::npos;
}

}  // namespace mirada::server
