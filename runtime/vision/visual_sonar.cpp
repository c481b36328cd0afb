#include "vision/visual_sonar.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "vision/column_scan.h"
#include "vision/fixed_colour.h"
#include "vision/floor_looks.h"
#include "vision/floor_memory.h"
#include "vision/ground_projection.h"
#include "vision/obstacle_hold.h"
#include "vision/picture_grid.h"
#include "vision/polar_sweep.h"
#include "vision/thing_edge.h"

namespace mirada::vision {
namespace {

/// Fitted to the errors in rooms made by chance: a foot is round, dirty or in its own shade.
constexpr double kSigmaFit = 2;
constexpr double kFootSigma_m = 0.004;
constexpr double kWideTo_m = 0.6;

bool same_aspect(const cv::Mat& bgr, const CameraModel& camera) {
  const double wanted = static_cast<double>(camera.width_px) / camera.height_px;
  const double given = static_cast<double>(bgr.cols) / bgr.rows;
  return std::abs(given / wanted - 1) < 0.01;
}

}  // namespace

struct VisualSonar::Impl {
  Impl(const RobotConfig& config, const SonarSettings& wanted) : robot(config), settings(wanted) {
    settings.lines_are_obstacles = settings.lines_are_obstacles || robot.lines_are_obstacles;
  }

  bool prepare_size(const cv::Mat& bgr);
  void prepare_neck(const NeckAngles& neck);
  bool scan_all(const Pose2& X_OR, const NeckAngles& neck);
  void see_nothing();
  void to_floor(std::size_t column);
  double doubt_m(const ColumnResult& found, int column, const Eigen::Vector2d& end_R_m) const;
  void find_edges();
  void fill(SonarPercept& percept, const NeckAngles& neck);

  RobotConfig robot;
  SonarSettings settings;
  CameraModel camera;  ///< at the picture's size
  PictureGrid grid;
  FloorMemory memory;
  ObstacleHold hold;
  std::optional<GroundProjection> ground;
  NeckAngles prepared_neck;
  RowScale scale;
  std::vector<ColumnSpan> spans;
  std::vector<ColumnResult> results;
  std::vector<ColumnEnd> ends;
};

VisualSonar::VisualSonar(const RobotConfig& robot, const SonarSettings& settings)
    : impl_(std::make_unique<Impl>(robot, settings)) {}
VisualSonar::~VisualSonar() = default;

void VisualSonar::forget() {
  impl_->memory.forget();
  impl_->hold.forget();
}

bool VisualSonar::Impl::prepare_size(const cv::Mat& bgr) {
  constexpr int kSmallest_px = 32;
  if (bgr.empty() || bgr.type() != CV_8UC3 || std::min(bgr.cols, bgr.rows) < kSmallest_px) return false;
  if (!same_aspect(bgr, robot.camera)) return false;
  if (ground && bgr.cols == camera.width_px && bgr.rows == camera.height_px) return true;
  camera = robot.camera.scaled_to(bgr.cols, bgr.rows);
  grid.resize(camera);
  scale.depth_m.resize(static_cast<std::size_t>(grid.rows()));
  ground.reset();
  return true;
}

void VisualSonar::Impl::prepare_neck(const NeckAngles& neck) {
  const bool same_tilt = ground && std::abs(neck.tilt_rad - prepared_neck.tilt_rad) < 1e-6;
  if (same_tilt && neck.pan_rad == prepared_neck.pan_rad) return;
  ground.emplace(robot, camera, neck);
  prepared_neck = neck;
  if (same_tilt) return;  // how far a row looks does not depend on pan
  grid.stand(ground->X_RC().linear().row(2).transpose());
  spans.resize(static_cast<std::size_t>(grid.columns()));
  results.resize(spans.size());
  ends.resize(spans.size());
  scale.focal_cells = 1 / grid.spacing_rad();
  const Eigen::Vector2d lens = ground->X_RC().translation().head<2>();
  const Eigen::Vector2d ahead = ground->X_RC().linear().col(2).head<2>().normalized();
  scale.height_m = ground->height_m();
  const auto depth_of = [&](int row) { return scale.depth_m[static_cast<std::size_t>(row)]; };
  for (int row = 0; row < grid.rows(); ++row) {
    const Eigen::Vector3d ray = grid.ray_C(grid.columns() / 2, row);
    const auto p = ground->floor_point_of_ray(ray);
    scale.depth_m[static_cast<std::size_t>(row)] = p ? std::min(1e3, (*p - lens).dot(ahead)) : 1e3;
  }
  constexpr double kFine_m = 0.003;
  scale.coarse_row = grid.rows() - 1;
  while (scale.coarse_row > 1 && depth_of(scale.coarse_row - 1) - depth_of(scale.coarse_row) < kFine_m)
    --scale.coarse_row;
  for (int column = 0; column < grid.columns(); ++column) {
    ColumnSpan& span = spans[static_cast<std::size_t>(column)];
    span.bottom_row = grid.bottom_row(column);
    span.top_row = grid.top_row(column);
    span.horizon_row = span.bottom_row;
    while (span.horizon_row >= span.top_row && ground->drop(grid.ray_C(column, span.horizon_row)) > 1e-4) {
      --span.horizon_row;
    }
    if (span.horizon_row < span.top_row) span.horizon_row = -1;
  }
}

bool VisualSonar::Impl::scan_all(const Pose2& X_OR, const NeckAngles& neck) {
  if (settings.floor == SonarSettings::Floor::fixed_colour) {
    for (int column = 0; column < grid.columns(); ++column) {
      const auto i = static_cast<std::size_t>(column);
      results[i] = scan_fixed_colour(grid, column, spans[i], settings);
    }
    return true;
  }
  const ScanSettings scan{settings.lines_are_obstacles, memory.knows_floor()};
  if (!memory.scan(grid, spans, scale, scan, X_OR, neck, results)) return false;
  hold.apply(grid, spans, *ground, X_OR, results);
  memory.learn(grid, spans, scale, results);
  return true;
}

/// A picture that cannot be judged: only what lies above the horizon is known, whatever it shows.
void VisualSonar::Impl::see_nothing() {
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool above = spans[i].bottom_row >= 0 && spans[i].horizon_row >= spans[i].bottom_row;
    results[i] = {.end = above ? ColumnResult::End::above_horizon : ColumnResult::End::nothing};
  }
}

/// What a column found, as an answer about places on the floor.
void VisualSonar::Impl::to_floor(std::size_t i) {
  using End = ColumnResult::End;
  const int column = static_cast<int>(i);
  const ColumnResult& found = results[i];
  ColumnEnd& out = ends[i];
  out = {};
  if (spans[i].bottom_row < 0) return;
  const Eigen::Vector3d axis_R =
      ground->X_RC().linear() * grid.ray_C(column, std::max(spans[i].top_row, spans[i].horizon_row));
  const Eigen::Vector2d lens = ground->X_RC().translation().head<2>();
  const Eigen::Vector2d away = axis_R.head<2>().normalized();
  out.end_R_m = lens + settings.range_m * away;
  if (found.end == End::above_horizon) out.answer = Answer::above_horizon;
  const auto foot = ground->floor_point_of_ray(grid.ray_C(column, spans[i].bottom_row + 0.5));
  if (!foot || found.end == End::nothing || found.end == End::above_horizon) return;
  out.foot_R_m = *foot;
  if (found.end == End::through_horizon) return;
  const auto end = ground->floor_point_of_ray(grid.ray_C(column, found.row));
  const bool in_range = end && (*end - lens).norm() <= settings.range_m;
  const bool seen_to_edge = found.end == End::floor_to_top;
  out.answer = in_range && !seen_to_edge ? Answer::blocked : Answer::clear;
  if (in_range) out.end_R_m = *end;
  const double tilt_rad = std::asin(-ground->X_RC().linear()(2, 2));
  out.sigma_m = ground_sigma_m((out.end_R_m - lens).norm(), ground->height_m(), tilt_rad, camera.fy_px,
                               found.sigma_row * grid.pixels_down(), robot.mount);
  out.sigma_m =
      std::max(std::hypot(kSigmaFit * out.sigma_m, kFootSigma_m), doubt_m(found, column, out.end_R_m));
}

/// What was passed over but may stand on the floor: the answer may be wrong by as much.
double VisualSonar::Impl::doubt_m(const ColumnResult& found, int column,
                                  const Eigen::Vector2d& end_R_m) const {
  constexpr float kWorthIt_m = 0.025F;
  constexpr double kSigmas = 1.9;  // a little less than 95 % of the answers
  const auto doubtful = [](const ColumnResult::Crossing& c) { return !c.flat && c.upright_m >= kWorthIt_m; };
  const auto* end = found.crossings.begin() + found.crossing_count;
  const auto* first = std::find_if(found.crossings.begin(), end, doubtful);
  if (first == end) return 0;
  const auto foot = ground->floor_point_of_ray(grid.ray_C(column, first->from_row + 0.5));
  return foot ? (end_R_m - *foot).norm() / kSigmas : 0;
}

/// Where two things stand side by side, one farther off: how far the nearer one reaches.
void VisualSonar::Impl::find_edges() {
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    ColumnEnd& left = ends[i];
    ColumnEnd& right = ends[i + 1];
    if (!is_jump(left, right)) continue;
    const bool left_nearer = left.end_R_m.squaredNorm() < right.end_R_m.squaredNorm();
    const int column = static_cast<int>(i) + (left_nearer ? 0 : 1);
    const int beside = static_cast<int>(i) + (left_nearer ? 1 : 0);
    // So near, a side that is measured a little too far in is a contact: the thing may reach to the next
    // column.
    const bool near = std::min(left.end_R_m.norm(), right.end_R_m.norm()) < kWideTo_m;
    const double row = results[static_cast<std::size_t>(column)].row;
    const double share = near && memory.knows_floor() ? 1 : thing_edge(grid, column, beside, row);
    left.edge = left_nearer ? share : 1 - share;
  }
}

void VisualSonar::Impl::fill(SonarPercept& percept, const NeckAngles& neck) {
  percept.boundary.reserve(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) to_floor(i);
  if (settings.floor == SonarSettings::Floor::learnt) find_edges();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double row = results[i].end == ColumnResult::End::nothing ? spans[i].bottom_row : results[i].row;
    percept.boundary.push_back({static_cast<float>(grid.u_px(static_cast<int>(i), row)),
                                static_cast<float>(grid.v_px(row)), ends[i].answer});
  }
  percept.readings.reserve(static_cast<std::size_t>(deg(camera.hfov_rad())) + 2);
  sweep(ends, neck.pan_rad + robot.mount.yaw_rad, camera.hfov_rad() / 2, robot.mount.sigma_pan_rad,
        percept.readings);
}

SonarPercept VisualSonar::look(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
  SonarPercept percept;
  percept.frame = frame.number;
  percept.t_exposure = frame.t_exposure;
  percept.neck = neck;
  percept.X_OR = X_OR;
  Impl& impl = *impl_;
  const RobotConfig& robot = impl.robot;
  const bool usable = impl.prepare_size(frame.bgr);
  if (usable) {
    impl.prepare_neck(neck);
    impl.grid.look_at(frame.bgr);
    percept.floor_model_trusted = impl.scan_all(X_OR, neck);
    if (!percept.floor_model_trusted) impl.see_nothing();
    impl.fill(percept, neck);
  } else {
    sweep({}, neck.pan_rad + robot.mount.yaw_rad, robot.camera.hfov_rad() / 2, 0, percept.readings);
  }
  return percept;
}

}  // namespace mirada::vision
