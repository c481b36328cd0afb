#pragma once
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fake_station.h"
#include "server/hub.h"

namespace mirada::server {

using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

struct FakeLink final : ViewerLink {
  void send_control(std::string text) override { control.push_back(json::parse(text)); }
  void offer_telemetry(SharedBytes text) override { telemetry.push_back(json::parse(*text)); }
  void offer_picture(SharedBytes bytes) override { pictures.push_back(std::move(bytes)); }
  void close(std::uint16_t code, const char*) override { closed = code; }

  std::vector<json> of(const std::string& type) const {
    std::vector<json> out;
    for (const json& message : control) {
      if (message["type"] == type) out.push_back(message);
    }
    return out;
  }
  json last(const std::string& type) const {
    const std::vector<json> all = of(type);
    return all.empty() ? json() : all.back();
  }

  std::vector<json> control;
  std::vector<json> telemetry;
  std::vector<SharedBytes> pictures;
  int closed = 0;
};

class HubTest : public testing::Test {
 protected:
  struct Client {
    std::shared_ptr<FakeLink> link = std::make_shared<FakeLink>();
    Hub::ViewerId id = 0;
    FakeLink* operator->() const { return link.get(); }
  };

  std::unique_ptr<Hub> make(const std::string& code = "") {
    return std::make_unique<Hub>(HubWiring{station_, clock_, code, "TEACH1",
                                           [this](Job job) { jobs_.push_back(std::move(job)); },
                                           [](Job job) { job(); }});
  }
  Client join(const std::string& name, bool needs_code = false, const std::string& code = "") {
    Client client;
    client.id = hub_->join(client.link, needs_code);
    greet(client, name, code);
    return client;
  }
  void greet(const Client& client, const std::string& name, const std::string& code = "") {
    say(client, {{"type", "hello"}, {"version", 1}, {"client", "client-" + name}, {"code", code}});
  }
  void say(const Client& client, const json& message) { hub_->receive(client.id, message.dump()); }
  void do_jobs() {
    while (!jobs_.empty()) {
      const Job job = std::move(jobs_.front());
      jobs_.pop_front();
      job();
    }
  }
  void run(const Client& client) {
    say(client, {{"type", "run"}, {"program", "p"}});
    do_jobs();
  }
  static std::string code_of(const json& refused) { return refused["faults"][0]["code"]; }

  FakeStation station_;
  ManualClock clock_;
  std::deque<Job> jobs_;
  std::unique_ptr<Hub> hub_ = make();
};

}  // namespace mirada::server
