#pragma once
#include <string>
#include <string_view>

namespace mirada::server {

/// Whether a Host line names this robot: the address that the connection came in on, its host name,
/// `<name>.local`, or a loopback name when it came in by loopback. The port may differ (forwarded ports); a
/// foreign name may not, or a page of another site could reach the robot through a name that it points here
/// (DNS rebinding).
bool host_allowed(std::string_view host, std::string_view local_address, std::string_view machine_name);

/// Whether an Origin line is `http://` and exactly this Host line.
bool origin_allowed(std::string_view origin, std::string_view host);

/// The name of this machine, lower case.
std::string machine_name();

/// An address of this machine that others on its network can reach: the first IPv4 one that is not loopback,
/// else
/// `<name>.local`.
std::string reachable_address();

}  // namespace mirada::server
