#include "session/run_hash.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <openssl/evp.h>

namespace mirada::session {
namespace {

constexpr double kMetre = 1e-4;
constexpr double kRadian = 1e-4;
constexpr double kPixel = 1e-2;

}  // namespace

struct RunHash::Impl {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  std::vector<unsigned char> pending;

  Impl() { EVP_DigestInit_ex(context, EVP_sha256(), nullptr); }
  ~Impl() { EVP_MD_CTX_free(context); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void add(std::int64_t value) {
    for (int shift = 0; shift < 64; shift += 8) {
      pending.push_back(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> shift));
    }
    if (pending.size() >= 4096) flush();
  }
  void flush() {
    EVP_DigestUpdate(context, pending.data(), pending.size());
    pending.clear();
  }
};

RunHash::RunHash() : impl_(std::make_unique<Impl>()) {}
RunHash::~RunHash() = default;

void RunHash::number(double value, double unit) {
  constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();
  impl_->add(std::isfinite(value) ? static_cast<std::int64_t>(std::llround(value / unit)) : kNone);
}

void RunHash::bytes(std::string_view text) {
  impl_->add(static_cast<std::int64_t>(text.size()));
  impl_->pending.insert(impl_->pending.end(), text.begin(), text.end());
}

void RunHash::tick(Micros t, const Pose2& X_WR, const NeckAngles& neck, const WheelSpeeds& command) {
  impl_->add('T');
  impl_->add(t);
  number(X_WR.x_m, kMetre);
  number(X_WR.y_m, kMetre);
  number(X_WR.heading_rad, kRadian);
  number(neck.pan_rad, kRadian);
  number(neck.tilt_rad, kRadian);
  number(command.left_mps, kMetre);
  number(command.right_mps, kMetre);
}

void RunHash::percepts(const Percepts& percepts) {
  if (percepts.sonar.frame != sonar_frame_) {
    sonar_frame_ = percepts.sonar.frame;
    impl_->add('S');
    impl_->add(percepts.sonar.t_exposure);
    for (const SonarReading& reading : percepts.sonar.readings) {
      number(reading.bearing_rad, kRadian);
      impl_->add(static_cast<std::int64_t>(reading.answer));
      number(reading.distance_m, kMetre);
      number(reading.sigma_m, kMetre);
    }
  }
  if (percepts.things.frame != things_frame_) {
    things_frame_ = percepts.things.frame;
    impl_->add('T');
    impl_->add(percepts.things.t_exposure);
    for (const ThingSeen& thing : percepts.things.things) {
      impl_->add(thing.id);
      number(thing.bearing_rad, kRadian);
      number(thing.distance_m, kMetre);
    }
  }
  if (percepts.lines.frame != lines_frame_) {
    lines_frame_ = percepts.lines.frame;
    impl_->add('L');
    impl_->add(percepts.lines.t_exposure);
    for (const LineSeen& line : percepts.lines.lines) {
      for (const double value : {line.p_RA_m.x(), line.p_RA_m.y(), line.p_RB_m.x(), line.p_RB_m.y()})
        number(value, kMetre);
    }
  }
  if (percepts.faces.frame == faces_frame_) return;
  faces_frame_ = percepts.faces.frame;
  impl_->add('F');
  impl_->add(percepts.faces.t_exposure);
  for (const FacePercept& face : percepts.faces.faces) {
    for (const double value : {face.x_px, face.y_px, face.w_px, face.h_px}) number(value, kPixel);
    number(face.bearing_rad, kRadian);
    number(face.distance_m, kMetre);
    impl_->add(face.id);
    if (face.familiar != Familiar::unsure) bytes(face.name);
  }
}

void RunHash::say(Micros t, std::string_view text) {
  impl_->add('Y');
  impl_->add(t);
  bytes(text);
}

std::string RunHash::finish() {
  impl_->flush();
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(impl_->context, digest.data(), &size);
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  for (unsigned int i = 0; i < size; ++i) {
    out += kHex[digest[i] >> 4];
    out += kHex[digest[i] & 15];
  }
  return out;
}

}  // namespace mirada::session
