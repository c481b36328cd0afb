#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/clock.h"
#include "base/result.h"
#include "packs/packs.h"
#include "server/examples.h"
#include "session/station.h"

namespace mirada::server {

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< an IP address of this machine, or a name of it
  std::uint16_t port = 8080;          ///< 0 = any free one
  std::filesystem::path ui_folder;    ///< the built editor
  Lang lang = Lang::en;               ///< the editor's first language
  std::string join_code;              ///< needed to drive, but not from this machine; "" = by nobody
  std::string teacher_code{};         ///< needed to allow that faces are learnt; "" = by nobody
};

/// HTTP and WebSocket on one port for one robot. Serves on threads of its own from open() to the destructor,
/// which closes every connection and waits for the threads. Station, packs and clock must outlive it.
class Server {
 public:
  /// Listens when it returns; a bad address or a busy port is a fault in words.
  static Result<std::unique_ptr<Server>> open(const ServerOptions& options, session::Station& station,
                                              const packs::PackSet& packs,
                                              const std::vector<Example>& examples, const Clock& clock);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const;
  /// The address to open in a browser.
  std::string url() const;
  bool on_loopback() const;

 private:
  struct Impl;
  explicit Server(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Whether `address` is one of this machine alone (127.0.0.1, ::1, localhost).
bool is_loopback_address(const std::string& address);

}  // namespace mirada::server
