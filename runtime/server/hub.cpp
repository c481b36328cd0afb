#include "server/hub.h"

#include <map>

#include <fmt/format.h>

#include "server/messages.h"
#include "server/viewer.h"

namespace mirada::server {
namespace {

constexpr Micros kTelemetryPeriod = 45 * kMillisecond;  // with ticks of 10 ms: 20 a second
constexpr Micros kCalibrationPeriod = 90 * kMillisecond;
constexpr std::size_t kWrongCodesAMinute = 60;

unsigned panel_mask(const session::Wanted& panels, bool names) {
  return (names ? 16u : 0u) | (panels.sonar ? 1u : 0u) | (panels.faces ? 2u : 0u) | (panels.room ? 4u : 0u) |
         (panels.memory ? 8u : 0u);
}

bool same(const session::Wanted& a, const session::Wanted& b) {
  return a.camera == b.camera && a.sonar == b.sonar && a.faces == b.faces && a.room == b.room &&
         a.memory == b.memory;
}

}  // namespace

Hub::Hub(HubWiring wiring)
    : wiring_(std::move(wiring)),
      wrong_codes_(kWrongCodesAMinute, 60 * kSecond),
      wrong_teacher_codes_(kWrongCodesAMinute, 60 * kSecond),
      telemetry_sent_(-kSecond),
      calibration_sent_(-kSecond) {}

Hub::~Hub() = default;

Hub::ViewerId Hub::join(std::shared_ptr<ViewerLink> link, bool needs_code) {
  auto viewer = std::make_unique<Viewer>();
  viewer->id = next_id_++;
  viewer->link = std::move(link);
  viewer->name = fmt::format("v{}", viewer->id);
  viewer->may_drive = !needs_code || wiring_.join_code.empty();
  const ViewerId id = viewer->id;
  viewers_.emplace(id, std::move(viewer));
  return id;
}

void Hub::leave(ViewerId id) {
  const auto it = viewers_.find(id);
  if (it == viewers_.end()) return;
  const std::unique_ptr<Viewer> viewer = std::move(it->second);
  viewers_.erase(it);
  release_keys(*viewer);
  update_wanted();
  if (viewer->greeted()) tell_owner();
}

void Hub::clear() { viewers_.clear(); }

void Hub::heard(ViewerId id) {
  if (const Viewer* viewer = find(id)) lease_.heard(viewer->client, wiring_.clock.now());
}

bool Hub::stop() {
  stops_.fetch_add(1);
  wiring_.station.stop(session::StopReason::stop_button);
  if (!stop_news_.take(wiring_.clock.now())) return false;
  broadcast(stopped_text());
  return true;
}

void Hub::tick() {
  if (lease_.expire(wiring_.clock.now())) lose_owner();
  if (viewers_.empty()) return;
  publish_telemetry();
  publish_picture();
  publish_calibration();
  publish_camera_words();
  publish_known_faces();
}

void Hub::lose_owner() {
  stops_.fetch_add(1);
  end_calibration();
  wiring_.station.stop(session::StopReason::owner_lost);
  broadcast(notice_text(messages::owner_gone));
  tell_owner();
}

void Hub::publish_telemetry() {
  const std::shared_ptr<const session::Telemetry> newest = wiring_.station.telemetry();
  if (!newest || newest == telemetry_) return;
  const bool turned = !telemetry_ || telemetry_->state != newest->state || telemetry_->run != newest->run;
  const Micros now = wiring_.clock.now();
  if (!turned && now - telemetry_sent_ < kTelemetryPeriod) return;
  telemetry_ = newest;
  telemetry_sent_ = now;
  TelemetryText text(*newest);
  if (telemetry_text_ && telemetry_text_->same_content(text)) return;
  telemetry_text_ = std::move(text);
  std::map<unsigned, SharedBytes> by_panels;
  for (const auto& [id, viewer] : viewers_) {
    if (!viewer->greeted()) continue;
    SharedBytes& message = by_panels[panel_mask(viewer->wanted, viewer->may_drive)];
    if (!message)
      message =
          std::make_shared<const std::string>(telemetry_text_->assemble(viewer->wanted, viewer->may_drive));
    viewer->link->offer_telemetry(message);
  }
}

void Hub::publish_picture() {
  if (!wanted_.camera) return;
  const std::shared_ptr<const session::Picture> newest = wiring_.station.picture();
  if (!newest || newest == picture_) return;
  picture_ = newest;
  const auto bytes = std::make_shared<const std::string>(picture_bytes(*newest));
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted() && viewer->wanted.camera) viewer->link->offer_picture(bytes);
  }
}

void Hub::publish_calibration() {
  const std::shared_ptr<const session::Calibration> newest = wiring_.station.calibration();
  if (!newest || newest == calibration_) return;
  const Micros now = wiring_.clock.now();
  const bool turned = !calibration_ || calibration_->phase != newest->phase;
  if (!turned && now - calibration_sent_ < kCalibrationPeriod) return;
  const bool quiet = !calibration_ && newest->phase == session::Calibration::Phase::off;
  calibration_ = newest;
  calibration_sent_ = now;
  if (quiet) return;
  const std::string text = calibration_text(*newest);
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted() && drives(*viewer)) viewer->link->send_control(text);
  }
}

void Hub::publish_camera_words() {
  const auto words = wiring_.station.camera_words();
  const std::string text = words ? camera_words_text(*words) : "";
  if (text == camera_words_) return;
  camera_words_ = text;
  if (!text.empty()) broadcast(text);
}

void Hub::publish_known_faces() {
  if (wiring_.station.known_faces_revision() == faces_revision_) return;
  const session::KnownFaces faces = wiring_.station.known_faces();
  faces_revision_ = faces.revision;
  const std::string text = known_faces_text(faces);
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted() && viewer->may_drive) viewer->link->send_control(text);
  }
}

void Hub::end_calibration() {
  const auto now = wiring_.station.calibration();
  if (now && now->phase != session::Calibration::Phase::off) (void)wiring_.station.calibrate({});
}

void Hub::give_current(Viewer& viewer) {
  if (const auto newest = wiring_.station.telemetry()) {
    viewer.link->offer_telemetry(std::make_shared<const std::string>(
        TelemetryText(*newest).assemble(viewer.wanted, viewer.may_drive)));
  }
  if (const auto picture = viewer.wanted.camera ? wiring_.station.picture() : nullptr) {
    viewer.link->offer_picture(std::make_shared<const std::string>(picture_bytes(*picture)));
  }
}

void Hub::update_wanted() {
  session::Wanted all;
  for (const auto& [id, viewer] : viewers_) {
    all.camera |= viewer->wanted.camera;
    all.sonar |= viewer->wanted.sonar;
    all.faces |= viewer->wanted.faces;
    all.room |= viewer->wanted.room;
    all.memory |= viewer->wanted.memory;
  }
  if (same(all, wanted_)) return;
  wanted_ = all;
  wiring_.station.want(all);
}

Seats Hub::seats() const {
  Seats seats;
  seats.taken = !lease_.free();
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted()) ++seats.viewers;
    if (seats.owner.empty() && drives(*viewer)) seats.owner = viewer->name;
  }
  return seats;
}

Seat Hub::seat(const Viewer& viewer) const { return {viewer.name, drives(viewer), viewer.may_drive}; }

bool Hub::drives(const Viewer& viewer) const { return viewer.may_drive && lease_.held_by(viewer.client); }

void Hub::tell_owner() {
  const Seats now = seats();
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted()) viewer->link->send_control(owner_text(seat(*viewer), now));
  }
}

void Hub::broadcast(const std::string& text) {
  for (const auto& [id, viewer] : viewers_) {
    if (viewer->greeted()) viewer->link->send_control(text);
  }
}

void Hub::send(ViewerId id, std::string text) {
  if (Viewer* viewer = find(id)) viewer->link->send_control(std::move(text));
}

void Hub::release_keys(Viewer& viewer) {
  for (const std::string& name : viewer.keys_down) wiring_.station.key(name, false);
  viewer.keys_down.clear();
}

Hub::Viewer* Hub::find(ViewerId id) {
  const auto it = viewers_.find(id);
  return it == viewers_.end() ? nullptr : it->second.get();
}

}  // namespace mirada::server
