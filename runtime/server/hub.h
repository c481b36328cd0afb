#pragma once
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/clock.h"
#include "server/client_message.h"
#include "server/join_code.h"
#include "server/outbox.h"
#include "server/owner_lease.h"
#include "server/server_messages.h"
#include "server/telemetry_text.h"
#include "server/token_bucket.h"
#include "session/station.h"

namespace mirada::server {

/// One viewer's connection as the hub sees it. Called on the hub's thread; no call blocks.
class ViewerLink {
 public:
  virtual ~ViewerLink() = default;
  virtual void send_control(std::string text) = 0;
  virtual void offer_telemetry(SharedBytes text) = 0;
  virtual void offer_picture(SharedBytes bytes) = 0;
  /// Closes with a WebSocket close code; leave() comes later, never during a call.
  virtual void close(std::uint16_t code, const char* reason) = 0;
};

using Job = std::function<void()>;

/// What the hub stands on. `background` runs jobs off the hub's thread, one after the other; `on_hub` brings
/// a job onto the hub's thread and may be called from any. Both outlive the hub or drop what comes later.
struct HubWiring {
  session::Station& station;
  const Clock& clock;
  std::string join_code;     ///< "" = nobody needs one
  std::string teacher_code;  ///< to allow that faces are learnt; "" = nobody needs one
  std::function<void(Job)> background;
  std::function<void(Job)> on_hub;
};

/// Where all viewers of one robot meet: who drives, who watches what, what is passed on to whom. Everything
/// on one thread. Stop is carried out before receive() returns, whatever the background does.
class Hub {
 public:
  using ViewerId = std::uint64_t;

  explicit Hub(HubWiring wiring);
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  ViewerId join(std::shared_ptr<ViewerLink> link, bool needs_code);
  void leave(ViewerId id);
  /// Forgets all viewers without a word: the server is closing.
  void clear();
  /// A pong or a message came from this viewer.
  void heard(ViewerId id);
  void receive(ViewerId id, std::string_view text);

  /// Anyone's Stop: the motors are at zero when this returns, and what was about to start does not. Everybody
  /// is told, but by a flood of Stops not more than 20 times a second: false when they were not.
  bool stop();
  /// To be called every few milliseconds while busy(): passes telemetry and pictures on, ends a silent
  /// owner's lease.
  void tick();
  bool busy() const { return !viewers_.empty() || !lease_.free(); }
  std::size_t viewers() const { return viewers_.size(); }

 private:
  struct Viewer;

  void handle(Viewer& viewer, const ReadMessage& read);
  void hello(Viewer& viewer, const ClientMessage& message);
  void check_code(Viewer& viewer, const std::string& code);
  /// Why this code does not do, or null; `own` and `all` count the viewer's tries and everybody's wrong ones.
  const Message* code_trouble(const std::string& typed, const std::string& code, TryLimit& own,
                              TryLimit& all);
  void run(Viewer& viewer, const std::string& program);
  void start_in_background(ViewerId id, std::string program);
  void evaluate(Viewer& viewer, const ClientMessage& message);
  void choose(Viewer& viewer, const ClientMessage& message);
  void put_back(Viewer& viewer);
  void key(Viewer& viewer, const ClientMessage& message);
  void watch(Viewer& viewer, const session::Wanted& wanted);
  void release(Viewer& viewer);
  void calibrate(Viewer& viewer, const session::CalibrationStep& step);
  void change_faces(Viewer& viewer, const session::FacesStep& step);

  bool within_rate(Viewer& viewer, const ReadMessage& read);
  bool may_drive(Viewer& viewer, std::string_view verb);
  bool drives(const Viewer& viewer) const;
  bool begin_job(Viewer& viewer, std::string_view verb);
  void end_job(ViewerId id);
  void refuse(Viewer& viewer, std::string_view verb, const Message& message);
  void send(ViewerId id, std::string text);
  void broadcast(const std::string& text);
  void tell_owner();
  void release_keys(Viewer& viewer);
  void lose_owner();
  Seats seats() const;
  Seat seat(const Viewer& viewer) const;
  void update_wanted();
  void publish_telemetry();
  void publish_picture();
  /// To whoever drives, when there is something new.
  void publish_calibration();
  void publish_camera_words();
  /// To those who may drive: names are not for everybody.
  void publish_known_faces();
  void end_calibration();
  void give_current(Viewer& viewer);
  Viewer* find(ViewerId id);

  HubWiring wiring_;
  std::map<ViewerId, std::unique_ptr<Viewer>> viewers_;
  ViewerId next_id_ = 1;
  OwnerLease lease_;
  TryLimit wrong_codes_;
  TryLimit wrong_teacher_codes_;         ///< apart: nobody who guesses at the one keeps the teacher out
  std::atomic<std::uint64_t> stops_{0};  ///< counts the Stops: a start that began before one is void
  TokenBucket stop_news_{20, 20};
  std::size_t jobs_ = 0;
  session::Wanted wanted_;

  std::shared_ptr<const session::Telemetry> telemetry_;
  std::optional<TelemetryText> telemetry_text_;
  Micros telemetry_sent_;
  std::shared_ptr<const session::Picture> picture_;
  std::shared_ptr<const session::Calibration> calibration_;
  Micros calibration_sent_;
  std::string camera_words_;          ///< as sent last
  std::uint64_t faces_revision_ = 0;  ///< as sent last
};

}  // namespace mirada::server
