#pragma once
#include <functional>
#include <mutex>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

namespace mirada::server {

/// Brings jobs from any thread onto the io thread; what comes after close() is dropped, so that a late answer
/// finds no server that is gone.
class Mailbox {
 public:
  explicit Mailbox(boost::asio::io_context& io) : io_(&io) {}

  void post(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    if (io_) boost::asio::post(*io_, std::move(job));
  }
  void close() {
    const std::lock_guard lock(mutex_);
    io_ = nullptr;
  }

 private:
  std::mutex mutex_;
  boost::asio::io_context* io_;
};

}  // namespace mirada::server
