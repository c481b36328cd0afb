// What the server promises, measured on the program itself: bench_server path/to/mirada path/to/program.json
// [rounds] prints one JSON object. Stop is timed from the first byte sent to the answer, which comes when the
// motors are at zero, while viewers stream the camera and all panels.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "raw_client.h"
#include "serve_process.h"

namespace mirada::bench {
namespace {

using nlohmann::json;
using server::RawClient;

constexpr int kViewers = 10;
constexpr const char* kWatchAll = R"({"type":"watch","camera":true,"sonar":true,"faces":true,"room":true})";

struct Stream {
  std::atomic<bool> done{false};
  std::atomic<std::uint64_t> pictures{0};
  std::atomic<std::uint64_t> telemetry{0};
};

void watch(RawClient client, Stream& stream) {
  while (!stream.done) {
    const RawClient::Frame got = client.next();
    if (got.opcode < 0 || got.opcode == 8) return;
    ++(got.opcode == 2 ? stream.pictures : stream.telemetry);
  }
}

json spread(std::vector<double> values_ms) {
  if (values_ms.empty()) return nullptr;
  std::sort(values_ms.begin(), values_ms.end());
  const auto at = [&](double share) {
    return values_ms[static_cast<std::size_t>(share * static_cast<double>(values_ms.size() - 1) + 0.5)];
  };
  return {{"n", values_ms.size()}, {"p50", at(0.5)}, {"p99", at(0.99)}, {"max", values_ms.back()}};
}

void sleep_s(double time_s) { std::this_thread::sleep_for(std::chrono::duration<double>(time_s)); }

double idle_cpu_percent(const ServeProcess& process) {
  constexpr double kWatch_s = 5;
  sleep_s(1);
  const double before_s = process.cpu_s();
  sleep_s(kWatch_s);
  return 100 * (process.cpu_s() - before_s) / kWatch_s;
}

/// Runs the program, lets it drive for a while, stops it: by the socket and by POST in turns.
void measure_stops(RawClient& owner, std::uint16_t port, const std::string& program, int rounds,
                   std::vector<double>& by_socket_ms, std::vector<double>& by_post_ms) {
  for (int i = 0; i < rounds; ++i) {
    owner.text(R"({"type":"run","program":)" + program + "}");
    if (owner.wait_for("started").is_null()) return;
    sleep_s(0.15);
    const double sent_s = now_s();
    if (i % 2 == 0) {
      owner.text(R"({"type":"stop"})");
      if (owner.wait_for("stopped").is_null()) return;
      by_socket_ms.push_back((now_s() - sent_s) * 1e3);
    } else {
      RawClient other(port);
      if (RawClient::status(other.ask("POST", "/api/stop")) != 204) return;
      by_post_ms.push_back((now_s() - sent_s) * 1e3);
      if (owner.wait_for("stopped").is_null()) return;
    }
  }
}

json measure(const ServeProcess& process, const std::string& program, int rounds) {
  const std::uint16_t port = process.port();
  const double before_s = now_s();
  const int status = RawClient::status(RawClient(port).ask("GET", "/"));
  json out{{"start_to_ready_s", process.start_s()},
           {"first_page_ms", (now_s() - before_s) * 1e3},
           {"first_page_status", status},
           {"idle_cpu_percent", idle_cpu_percent(process)}};
  Stream stream;
  std::vector<std::thread> viewers;
  for (int i = 0; i < kViewers; ++i) {
    RawClient client(port);
    client.hello("viewer-" + std::to_string(i));
    client.text(kWatchAll);
    viewers.emplace_back([&stream, moved = std::make_shared<RawClient>(std::move(client))] {
      watch(std::move(*moved), stream);
    });
  }
  RawClient owner(port);
  owner.hello("owner");
  owner.text(kWatchAll);
  std::vector<double> by_socket_ms, by_post_ms;
  const double began_s = now_s(), cpu_before_s = process.cpu_s();
  measure_stops(owner, port, program, rounds, by_socket_ms, by_post_ms);
  const double took_s = now_s() - began_s;
  out["viewers"] = kViewers;
  out["pictures_per_viewer_per_s"] = static_cast<double>(stream.pictures) / kViewers / took_s;
  out["messages_per_viewer_per_s"] = static_cast<double>(stream.telemetry) / kViewers / took_s;
  out["streaming_cpu_percent"] = 100 * (process.cpu_s() - cpu_before_s) / took_s;
  out["stop_by_socket_ms"] = spread(by_socket_ms);
  out["stop_by_post_ms"] = spread(by_post_ms);
  stream.done = true;
  owner.text(R"({"type":"stop"})");
  for (std::thread& viewer : viewers) viewer.join();
  return out;
}

}  // namespace
}  // namespace mirada::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "bench_server MIRADA PROGRAM.json [ROUNDS]\n");
    return 2;
  }
  const auto program = mirada::read_file(argv[2]);
  const mirada::bench::ServeProcess process(argv[1]);
  if (!program.ok() || process.port() == 0) {
    std::fprintf(stderr, "no program, or the server did not start\n");
    return 2;
  }
  const int rounds = argc > 3 ? std::max(1, std::atoi(argv[3])) : 200;
  std::printf("%s\n", mirada::bench::measure(process, *program, rounds).dump(2).c_str());
  return 0;
}
