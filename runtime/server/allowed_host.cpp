#include "server/allowed_host.h"

#include <algorithm>
#include <arpa/inet.h>
#include <memory>
#include <unistd.h>

#include <ifaddrs.h>
#include <net/if.h>

namespace mirada::server {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

struct HostParts {
  std::string name;
  std::string port;  ///< "" when there is none
  bool ok = false;
};

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

HostParts split(std::string_view host) {
  HostParts parts;
  std::size_t name_end = host.find(':');
  if (!host.empty() && host.front() == '[') {
    const std::size_t close = host.find(']');
    if (close == std::string_view::npos) return parts;
    parts.name = lower(host.substr(1, close - 1));
    name_end = close + 1 < host.size() ? close + 1 : std::string_view::npos;
    if (name_end != std::string_view::npos && host[name_end] != ':') return parts;
  } else {
    parts.name = lower(host.substr(0, name_end));
  }
  if (name_end != std::string_view::npos) {
    parts.port = std::string(host.substr(name_end + 1));
    if (!is_port(parts.port)) return parts;
  }
  parts.ok = !parts.name.empty();
  return parts;
}

bool is_loopback(std::string_view address) { return address == "::1" || address.starts_with("127."); }

}  // namespace

bool host_allowed(std::string_view host, std::string_view local_address, std::string_view machine_name) {
  const HostParts parts = split(host);
  if (!parts.ok) return false;
  if (parts.name == local_address) return true;
  if (is_loopback(local_address) && (parts.name == "localhost" || is_loopback(parts.name))) {
    // "127.evil.example" starts like a loopback address and is a name.
    return parts.name == "localhost" || parts.name.find_first_not_of("0123456789.:") == std::string::npos;
  }
  return !machine_name.empty() &&
         (parts.name == machine_name || parts.name == std::string(machine_name) + ".local");
}

bool origin_allowed(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  if (!origin.starts_with(kScheme)) return false;
  const HostParts from = split(origin.substr(kScheme.size()));
  const HostParts to = split(host);
  const auto port = [](const HostParts& parts) {
    return parts.port.empty() ? std::string("80") : parts.port;
  };
  return from.ok && to.ok && from.name == to.name && port(from) == port(to);
}

std::string machine_name() {
  char name[256] = {};
  if (::gethostname(name, sizeof name - 1) != 0) return "";
  return lower(name);
}

std::string reachable_address() {
  ifaddrs* found = nullptr;
  if (::getifaddrs(&found) != 0) found = nullptr;
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> all(found, &::freeifaddrs);
  for (const ifaddrs* at = found; at; at = at->ifa_next) {
    const bool usable = at->ifa_addr && at->ifa_addr->sa_family == AF_INET && (at->ifa_flags & IFF_UP) != 0 &&
                        (at->ifa_flags & IFF_LOOPBACK) == 0;
    if (!usable) continue;
    char text[INET_ADDRSTRLEN] = {};
    const auto* address = reinterpret_cast<const sockaddr_in*>(at->ifa_addr);
    if (::inet_ntop(AF_INET, &address->sin_addr, text, sizeof text)) return text;
  }
  return machine_name() + ".local";
}

}  // namespace mirada::server
