#include "vision/lines/line_finder.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Eigenvalues>

namespace mirada::vision {
namespace {

using Eigen::Vector2d;

constexpr double kEdge_samples = 0.4;  // 1-sigma of a band's middle
constexpr double kRough_m = 0.002;     // of paint and floor
constexpr std::size_t kLeastCrossings = 5;
constexpr double kLeastLength_m = 0.15;
constexpr double kBent_m = 0.012;  // a piece that bends more is two
constexpr int kMostMissing = 2;    // scans
constexpr double kOffTheWay_samples = 2.5;
constexpr double kNarrower = 0.6, kWider = 1.5;  // than the lines looked for, and a sample's blur
constexpr double kBlur_samples = 1;
constexpr double kLeastWideAsALine = 0.75;  // of the crossings
constexpr double kMostOblique = 4;          // times a line's width along a scan

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// How far the next crossing may lie from where the chain's last ones point; infinite when it is too many
/// scans away.
double off_the_way(const std::vector<BandCrossing>& chain, const BandCrossing& next, double between) {
  const BandCrossing& last = chain.back();
  const int scans = next.scan - last.scan;
  if (scans < 1 || scans > 1 + kMostMissing) return HUGE_VAL;
  if (chain.size() == 1) {
    // As steep as this the other family of scans sees it better.
    const double steep = std::abs(next.at - last.at) / (scans * between);
    return steep < 1.6 ? 0.9 * kOffTheWay_samples : HUGE_VAL;
  }
  const BandCrossing& before = chain[chain.size() - std::min<std::size_t>(chain.size(), 4)];
  const double slope = (last.at - before.at) / (last.scan - before.scan);
  return std::abs(next.at - last.at - slope * scans);
}

/// Root of the mean of the squares of what one error does to both ends of a line, told as its middle's shift
/// across it and its turn.
struct Error {
  double across2_m2 = 0;
  double angle2_rad2 = 0;
  void add(double at_A_m, double at_B_m, double length_m) {
    across2_m2 += std::pow((at_A_m + at_B_m) / 2, 2);
    angle2_rad2 += std::pow((at_B_m - at_A_m) / length_m, 2);
  }
};

/// What tilt, height and pan, known only so well, do to a line from A to B.
Error mount_error(const Vector2d& p_RA_m, const Vector2d& p_RB_m, const GroundProjection& ground,
                  const MountConfig& mount) {
  const Vector2d p_RC_m = ground.X_RC().translation().head<2>();
  const Vector2d a_m = p_RA_m - p_RC_m, b_m = p_RB_m - p_RC_m;
  const double length_m = (p_RB_m - p_RA_m).norm();
  const Vector2d normal = left_of(p_RB_m - p_RA_m) / length_m;
  const double h_m = ground.height_m();
  // With d the distance from below the lens, h its height: dd/dtilt = (d^2 + h^2) / h, dd/dh = d / h.
  const auto by_tilt = [&](const Vector2d& p_m) {
    const double d_m = std::max(p_m.norm(), 1e-6);
    return mount.sigma_tilt_rad * (d_m * d_m + h_m * h_m) / h_m * p_m.dot(normal) / d_m;
  };
  const auto by_height = [&](const Vector2d& p_m) { return mount.sigma_height_m / h_m * p_m.dot(normal); };
  const auto by_pan = [&](const Vector2d& p_m) { return mount.sigma_pan_rad * left_of(p_m).dot(normal); };
  Error out;
  out.add(by_tilt(a_m), by_tilt(b_m), length_m);
  out.add(by_height(a_m), by_height(b_m), length_m);
  out.add(by_pan(a_m), by_pan(b_m), length_m);
  return out;
}

/// A straight line through crossings, with the variances of where it lies across itself at its middle and of
/// its direction.
struct Fit {
  Vector2d middle_m = Vector2d::Zero();
  Vector2d way;
  double across2_m2 = 0, angle2_rad2 = 0;

  Vector2d on_line(const Vector2d& p_m) const { return middle_m + way * way.dot(p_m - middle_m); }
};

/// Least squares across the line, each crossing as exact as the floor between its samples is small.
Fit fitted(std::span<const BandCrossing> chain) {
  const Vector2d rough_way = (chain.back().p_R_m - chain.front().p_R_m).normalized();
  const auto count = static_cast<double>(chain.size());
  const auto sine = [&](const BandCrossing& c) {
    return std::abs(cross(rough_way, c.across_m.normalized()));
  };
  const auto weight = [&](const BandCrossing& c) {
    const double sigma_m = std::hypot(kEdge_samples * c.per_sample_m * sine(c), kRough_m);
    return 1 / (sigma_m * sigma_m);
  };
  Fit fit;
  double weights = 0;
  for (const BandCrossing& c : chain) {
    weights += weight(c);
    fit.middle_m += weight(c) * c.p_R_m;
  }
  fit.middle_m /= weights;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const BandCrossing& c : chain) {
    const Vector2d off_m = c.p_R_m - fit.middle_m;
    spread += weight(c) * off_m * off_m.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  fit.way = axes.eigenvectors().col(1);
  // With a worse fit than the samples explain it is that much worse known.
  const double worse = std::max(1.0, axes.eigenvalues()(0) / (count - 2));
  fit.across2_m2 = worse / weights;
  fit.angle2_rad2 = worse / axes.eigenvalues()(1);
  return fit;
}

}  // namespace

LineFinder::LineFinder(const RobotConfig& robot, double narrowest_m, double widest_m)
    : robot_(robot), narrowest_m_(narrowest_m), widest_m_(widest_m) {}

std::vector<LineSeen> LineFinder::find(const Frame& frame, const NeckAngles& neck) {
  const CameraModel& calibrated = robot_.camera;
  if (frame.bgr.empty() || frame.bgr.cols * calibrated.height_px != frame.bgr.rows * calibrated.width_px)
    return {};
  if (frame.bgr.size() != prepared_) {
    prepared_ = frame.bgr.size();
    camera_ = calibrated.scaled_to(prepared_.width, prepared_.height);
    scans_.resize(camera_);
  }
  const GroundProjection ground(robot_, camera_, neck);
  if (ground.height_m() <= 0) return {};
  const BandLimits limits{narrowest_m_ * kNarrower / 1.5, widest_m_ * kMostOblique};
  std::vector<LineSeen> out;
  add_chains(scans_.down(frame.bgr, ground, limits), ground, out);
  add_chains(scans_.across(frame.bgr, ground, limits), ground, out);
  return out;
}

void LineFinder::add_chains(const Crossings& crossings, const GroundProjection& ground,
                            std::vector<LineSeen>& out) {
  chains_.clear();
  for (const BandCrossing& crossing : crossings) {
    Crossings* best = nullptr;
    double least = kOffTheWay_samples;
    for (Crossings& chain : chains_) {
      const double off = off_the_way(chain, crossing, scans_.samples_between_scans());
      if (off < least) {
        least = off;
        best = &chain;
      }
    }
    if (best == nullptr) best = &chains_.emplace_back();
    best->push_back(crossing);
  }
  for (const Crossings& chain : chains_)
    if (chain.size() >= kLeastCrossings) add_pieces(chain, 0, chain.size() - 1, ground, out);
}

void LineFinder::add_pieces(const Crossings& chain, std::size_t first, std::size_t last,
                            const GroundProjection& ground, std::vector<LineSeen>& out) const {
  if (last - first + 1 < kLeastCrossings) return;
  const Vector2d way = (chain[last].p_R_m - chain[first].p_R_m).normalized();
  std::size_t worst = first;
  double most = 1;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double bent_m = std::abs(cross(way, chain[i].p_R_m - chain[first].p_R_m));
    const double may_m = std::max(kBent_m, 3 * kEdge_samples * chain[i].per_sample_m);
    if (bent_m > most * may_m) {
      most = bent_m / may_m;
      worst = i;
    }
  }
  if (worst == first) return add_line(chain, first, last, ground, out);
  add_pieces(chain, first, worst, ground, out);
  add_pieces(chain, worst, last, ground, out);
}

void LineFinder::add_line(const Crossings& chain, std::size_t first, std::size_t last,
                          const GroundProjection& ground, std::vector<LineSeen>& out) const {
  const std::span<const BandCrossing> piece(chain.data() + first, last - first + 1);
  const Fit fit = fitted(piece);
  const auto wide_as_a_line = [&](const BandCrossing& c) {
    const double width_m = std::abs(cross(fit.way, c.across_m));
    const double blur_m = kBlur_samples * c.per_sample_m * width_m / c.across_m.norm();
    return width_m > kNarrower * narrowest_m_ - blur_m && width_m < kWider * widest_m_ + blur_m;
  };
  const auto count = static_cast<double>(piece.size());
  if (std::ranges::count_if(piece, wide_as_a_line) < kLeastWideAsALine * count) return;
  LineSeen line{fit.on_line(chain[first].p_R_m), fit.on_line(chain[last].p_R_m)};
  if ((line.p_RB_m - line.p_RA_m).norm() < kLeastLength_m) return;
  Error error = mount_error(line.p_RA_m, line.p_RB_m, ground, robot_.mount);
  const double lever_m = fit.way.dot((line.p_RA_m + line.p_RB_m) / 2 - fit.middle_m);
  error.across2_m2 += fit.across2_m2 + fit.angle2_rad2 * lever_m * lever_m;
  error.angle2_rad2 += fit.angle2_rad2;
  line.across_sigma_m = std::sqrt(error.across2_m2);
  line.angle_sigma_rad = std::sqrt(error.angle2_rad2);
  out.push_back(line);
}

}  // namespace mirada::vision
