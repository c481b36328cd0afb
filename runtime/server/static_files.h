#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mirada::server {

/// A file of the editor, ready to be sent.
struct StaticFile {
  std::string bytes;
  std::string_view type;   ///< Content-Type
  std::string etag;        ///< quoted
  bool gzip = false;       ///< the bytes are the file's gzip form
  bool immutable = false;  ///< its name changes with its content
};

/// The files below one folder. Reads them when they are asked for, so that an editor built later appears at
/// once.
class StaticFiles {
 public:
  explicit StaticFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `target` as in the request line ("/assets/a.js?x"). Nothing for what is not there, a folder, a hidden
  /// file, a path that is not plain, and whatever a link would reach outside the folder. "/" is index.html.
  std::optional<StaticFile> find(std::string_view target, bool gzip_accepted) const;
  bool built() const;

 private:
  std::filesystem::path folder_;
};

/// Whether an Accept-Encoding line takes gzip.
bool accepts_gzip(std::string_view accept_encoding);

}  // namespace mirada::server
