#pragma once
#include <cstdint>
#include <string>
#include <sys/types.h>

namespace mirada::bench {

/// A `mirada serve` of its own on a free port, ended by the destructor.
class ServeProcess {
 public:
  explicit ServeProcess(const std::string& program);
  ~ServeProcess();
  ServeProcess(const ServeProcess&) = delete;
  ServeProcess& operator=(const ServeProcess&) = delete;

  /// 0 = it did not start.
  std::uint16_t port() const { return port_; }
  /// From the start of the program to its line that it is ready.
  double start_s() const { return start_s_; }
  /// Seconds of processor time used so far.
  double cpu_s() const;

 private:
  pid_t pid_ = -1;
  int out_ = -1;
  std::uint16_t port_ = 0;
  double start_s_ = 0;
};

double now_s();

}  // namespace mirada::bench
