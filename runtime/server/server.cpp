#include "server/server.h"

#include <array>
#include <chrono>
#include <optional>
#include <thread>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <fmt/format.h>

#include "server/allowed_host.h"
#include "server/api.h"
#include "server/connections.h"
#include "server/mailbox.h"
#include "server/messages.h"

namespace mirada::server {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr std::chrono::milliseconds kTick{10};

Result<tcp::endpoint> endpoint_of(const ServerOptions& options) {
  boost::system::error_code error;
  const std::string& address = options.address;
  const asio::ip::address literal =
      asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, error);
  if (!error) return tcp::endpoint(literal, options.port);
  return make_fault("--listen", messages::address_bad, {{"address", address}});
}

Fault listen_fault(const ServerOptions& options, const boost::system::error_code& error) {
  const MessageArgs args{
      {"address", options.address}, {"port", std::to_string(options.port)}, {"reason", error.message()}};
  if (error == asio::error::address_in_use) return make_fault("--port", messages::port_busy, args);
  if (error == asio::error::access_denied) return make_fault("--port", messages::port_forbidden, args);
  if (error.value() == EADDRNOTAVAIL) return make_fault("--listen", messages::address_bad, args);
  return make_fault("--listen", messages::cannot_listen, args);
}

}  // namespace

struct Server::Impl {
  Impl(const ServerOptions& options, session::Station& station, const packs::PackSet& packs,
       const std::vector<Example>& examples, const Clock& clock)
      : hub({station, clock, options.join_code, options.teacher_code, on(station_jobs), to_io()}),
        board{hub,
              clock,
              {station, StaticFiles(options.ui_folder), packs_json(packs), examples_json(examples),
               options.lang, machine_name()},
              packs,
              on(page_jobs),
              to_io(),
              [this] { wake(); }},
        acceptor(io),
        again(io),
        ticker(io) {}

  ~Impl() {
    mailbox->close();
    io.stop();
    if (thread.joinable()) thread.join();
    station_jobs.stop();
    page_jobs.stop();
    station_jobs.join();
    page_jobs.join();
    hub.clear();
  }

  static std::function<void(Job)> on(asio::thread_pool& pool) {
    return [&pool](Job job) { asio::post(pool, std::move(job)); };
  }
  std::function<void(Job)> to_io() const {
    return [box = mailbox](Job job) { box->post(std::move(job)); };
  }

  boost::system::error_code listen(const tcp::endpoint& endpoint) {
    boost::system::error_code error;
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(128, error);
    return error;
  }

  void start() {
    accept();
    thread = std::thread([this] { io.run(); });
  }

  void accept() {
    acceptor.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) return accept_later();
      take(std::move(socket));
      accept();
    });
  }

  /// Out of file descriptors or memory: some connection must end first.
  void accept_later() {
    again.expires_after(std::chrono::milliseconds(100));
    again.async_wait([this](boost::system::error_code error) {
      if (!error) accept();
    });
  }

  void take(tcp::socket socket) {
    constexpr std::size_t kMost = Switchboard::kMaxConnections;
    if (board.open >= kMost && !board.idle.empty()) {
      IdleConnection* longest_or_any = *board.idle.begin();
      board.idle.erase(board.idle.begin());
      longest_or_any->make_room();
    }
    if (board.open >= kMost + Switchboard::kStopReserve) return;  // closes it
    serve_http(std::move(socket), board, board.open >= kMost);
  }

  void wake() {
    if (ticking) return;
    ticking = true;
    tick();
  }

  void tick() {
    hub.tick();
    if (!hub.busy()) {
      ticking = false;
      return;
    }
    ticker.expires_after(kTick);
    ticker.async_wait([this](boost::system::error_code error) {
      if (!error) tick();
    });
  }

  // Connections that wait in `io` refer to `board`, so `io` goes first.
  asio::thread_pool station_jobs{1};
  asio::thread_pool page_jobs{2};
  std::shared_ptr<Mailbox> mailbox{std::make_shared<Mailbox>(io)};
  Hub hub;
  Switchboard board;
  asio::io_context io{1};
  tcp::acceptor acceptor;
  asio::steady_timer again;
  asio::steady_timer ticker;
  bool ticking = false;
  std::thread thread;
};

Server::Server(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Server::~Server() = default;

Result<std::unique_ptr<Server>> Server::open(const ServerOptions& options, session::Station& station,
                                             const packs::PackSet& packs,
                                             const std::vector<Example>& examples, const Clock& clock) {
  const Result<tcp::endpoint> endpoint = endpoint_of(options);
  if (!endpoint.ok()) return endpoint.faults();
  auto impl = std::make_unique<Impl>(options, station, packs, examples, clock);
  if (const auto error = impl->listen(*endpoint)) return listen_fault(options, error);
  impl->start();
  return std::unique_ptr<Server>(new Server(std::move(impl)));
}

std::uint16_t Server::port() const { return impl_->acceptor.local_endpoint().port(); }

bool Server::on_loopback() const { return impl_->acceptor.local_endpoint().address().is_loopback(); }

std::string Server::url() const {
  const tcp::endpoint endpoint = impl_->acceptor.local_endpoint();
  const asio::ip::address address = endpoint.address();
  std::string host = address.to_string();
  if (address.is_v6()) host = fmt::format("[{}]", host);
  if (address.is_unspecified()) host = reachable_address();
  return fmt::format("http://{}:{}/", host, endpoint.port());
}

bool is_loopback_address(const std::string& address) {
  boost::system::error_code error;
  const asio::ip::address literal = asio::ip::make_address(address, error);
  return address == "localhost" || (!error && literal.is_loopback());
}

}  // namespace mirada::server
