#include "serve_process.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace mirada::bench {
namespace {

std::uint16_t port_in(const std::string& line) {
  const std::size_t at = line.rfind(':');
  return at == std::string::npos
             ? 0
             : static_cast<std::uint16_t>(std::strtoul(line.c_str() + at + 1, nullptr, 10));
}

}  // namespace

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ServeProcess::ServeProcess(const std::string& program) {
  int ends[2];
  if (::pipe(ends) != 0) return;
  const double began_s = now_s();
  pid_ = ::fork();
  if (pid_ == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execl(program.c_str(), program.c_str(), "serve", "--port", "0", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  out_ = ends[0];
  std::string line;
  char c = 0;
  // Before its address it may print a code.
  while (port_ == 0 && ::read(out_, &c, 1) == 1) {
    line += c;
    if (c != '\n') continue;
    if (line.find("http://") != std::string::npos) port_ = port_in(line);
    line.clear();
  }
  start_s_ = now_s() - began_s;
}

ServeProcess::~ServeProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGTERM);
    ::waitpid(pid_, nullptr, 0);
  }
  if (out_ >= 0) ::close(out_);
}

double ServeProcess::cpu_s() const {
  std::ifstream in("/proc/" + std::to_string(pid_) + "/stat");
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  double user = 0, system = 0;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

}  // namespace mirada::bench
