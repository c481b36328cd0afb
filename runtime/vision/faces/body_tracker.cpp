#include "vision/faces/body_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr int kSmallWidth_px = 160;
// The trunk below a face, in the face's widths and heights.
constexpr double kTrunkFrom = 1.45;
constexpr double kTrunkTo = 2.9;
constexpr double kTrunkHalf = 0.8;
constexpr double kRingHalf = 2.6;
constexpr float kFades = 0.85F;  // of what was learnt, a look
constexpr int kClothesLooks = 2;
constexpr double kTellable = 0.62;  // mean likelihood on the own clothes
constexpr double kStillTellable = 0.5;
constexpr double kClothesLike = 0.5;
constexpr double kClothesSurely = 0.7;  // after a loss
constexpr double kLeastAgain = 0.55;    // of the distance that is expected, after a loss
constexpr double kMostAgain = 1.7;
constexpr double kWalks_mps = 0.8;
constexpr double kWhole = 0.5;            // of a box: less is not one thing
constexpr double kTopShare = 1.25;        // from above the face to where clothes end, in the face's heights
constexpr double kClothesSearch_px = 14;  // in the small picture
constexpr double kClothesSearchShare = 0.8;
constexpr double kLowerShare = 1.0;
constexpr double kTrunkVisible = 0.45;
constexpr double kTrunkRange = 0.8;  // less of it tells nothing of the distance
constexpr double kEverywhere = 0.9;  // of the picture: that is no body
constexpr double kLikeAround = 0.3;  // beside it: more of that, and its edges are anywhere
constexpr double kLeastJump = 0.7;   // of the distance, from look to look
constexpr double kMostJump = 1.2;    // less: who is taken for farther away is driven at
constexpr int kTrunkSide_px = 4;
constexpr int kAtEdge_px = 1;
constexpr float kFew = 1e-4F;

cv::Rect2d trunk_of(const FacePercept& face, double half) {
  const double middle = face.x_px + face.w_px / 2;
  return {middle - half * face.w_px, face.y_px + kTrunkFrom * face.h_px, 2 * half * face.w_px,
          (kTrunkTo - kTrunkFrom) * face.h_px};
}

struct Window {
  int at = 0;
  double likeness = 0;  // mean
};

Window most_alike(const float* column, int first, int last, int width) {
  double sum = std::accumulate(column + first, column + first + width, 0.0);
  double best = sum;
  int at = first;
  for (int x = first + 1; x <= last; ++x) {
    sum += column[x + width - 1] - column[x - 1];
    if (sum > best + 1e-6) {
      best = sum;
      at = x;
    }
  }
  return {at, best / width};
}

/// How far to both sides it goes on like the clothes: somebody near is wider than was expected, somebody far
/// or turned narrower.
std::pair<int, int> grown(const float* column, int columns, int at, int width) {
  constexpr int kGap = 2;
  const auto like = [&](int x) { return column[x] > kClothesLike; };
  int from = at + width / 2;
  for (int x = from, gap = 0; x >= 0 && gap <= kGap; --x) {
    gap = like(x) ? 0 : gap + 1;
    if (gap == 0) from = x;
  }
  int to = at + width / 2;
  for (int x = to, gap = 0; x < columns && gap <= kGap; ++x) {
    gap = like(x) ? 0 : gap + 1;
    if (gap == 0) to = x + 1;
  }
  return {from, std::max(to, from + 1)};
}

double middle_of(const float* column, int from, int to) {
  double weight = 0, moment = 0;
  for (int x = from; x < to; ++x) {
    weight += column[x];
    moment += column[x] * (x + 0.5);
  }
  return weight > 0 ? moment / weight : (from + to) / 2.0;
}

}  // namespace

void BodyTracker::look(const cv::Mat& bgr) {
  picture_ = bgr.size();
  scale_ = std::max(1.0, static_cast<double>(bgr.cols) / kSmallWidth_px);
  cv::resize(bgr, small_, {}, 1 / scale_, 1 / scale_, cv::INTER_AREA);
  cv::cvtColor(small_, lab_, cv::COLOR_BGR2Lab);
  bins_.create(lab_.size(), CV_16U);
  for (int y = 0; y < lab_.rows; ++y) {
    const auto* pixel = lab_.ptr<cv::Vec3b>(y);
    auto* bin = bins_.ptr<std::uint16_t>(y);
    for (int x = 0; x < lab_.cols; ++x) {
      const int a = std::clamp((pixel[x][1] - 64) / 8, 0, 15);
      const int b = std::clamp((pixel[x][2] - 64) / 8, 0, 15);
      bin[x] = static_cast<std::uint16_t>(pixel[x][0] / 32 * 256 + a * 16 + b);
    }
  }
}

cv::Rect BodyTracker::in_small(const cv::Rect2d& box) const {
  const cv::Rect out(cvRound(box.x / scale_), cvRound(box.y / scale_),
                     std::max(1, cvRound(box.width / scale_)), std::max(1, cvRound(box.height / scale_)));
  return out & cv::Rect({}, bins_.size());
}

void BodyTracker::count(const cv::Mat& bins, std::vector<float>& into) {
  if (bins.empty()) return;
  for (float& share : into) share *= kFades;
  const float one = (1 - kFades) / static_cast<float>(bins.total());
  for (int y = 0; y < bins.rows; ++y) {
    const auto* bin = bins.ptr<std::uint16_t>(y);
    for (int x = 0; x < bins.cols; ++x) into[bin[x]] += one;
  }
}

/// Each colour counts for those beside it too, along one axis of the bins.
void BodyTracker::spread(std::vector<float>& of, int step, int count) {
  constexpr std::array kBeside{0.7F, 0.25F};
  const std::vector<float> from = of;
  for (int i = 0; i < kBins; ++i) {
    const int at = i / step % count;
    for (int off = 1; off <= 2; ++off) {
      const float share = kBeside[static_cast<std::size_t>(off - 1)];
      if (at >= off)
        of[static_cast<std::size_t>(i)] += share * from[static_cast<std::size_t>(i - off * step)];
      if (at + off < count)
        of[static_cast<std::size_t>(i)] += share * from[static_cast<std::size_t>(i + off * step)];
    }
  }
}

/// How likely each colour is theirs. Lighter and darker shades of it count too:
/// a back is lit otherwise.
void BodyTracker::settle(Clothes& clothes) {
  std::vector<float> mine = clothes.mine, around = clothes.around;
  for (std::vector<float>* of : {&mine, &around}) {
    spread(*of, 256, 8);
    spread(*of, 16, 16);
    spread(*of, 1, 16);
  }
  for (std::size_t i = 0; i < kBins; ++i) clothes.likely[i] = mine[i] / (mine[i] + around[i] + kFew);
}

void BodyTracker::learn_colours(Clothes& clothes, const cv::Rect2d& whole) {
  const cv::Rect trunk = in_small(whole);
  count(bins_(trunk), clothes.mine);
  const double beside_px = (kRingHalf / kTrunkHalf - 1) / 2 * whole.width;
  const cv::Rect ring = in_small({whole.x - beside_px, whole.y, whole.width + 2 * beside_px, whole.height});
  const cv::Rect left(ring.x, ring.y, std::max(0, trunk.x - trunk.width / 3 - ring.x), ring.height);
  const int right_x = trunk.x + trunk.width + trunk.width / 3;
  const cv::Rect right(right_x, ring.y, std::max(0, ring.x + ring.width - right_x), ring.height);
  for (const cv::Rect& side : {left, right})
    if (side.area() > 0) count(bins_(side), clothes.around);
  settle(clothes);
  ++clothes.looks;
  const double enough = clothes.tellable ? kStillTellable : kTellable;
  clothes.tellable = clothes.looks >= kClothesLooks && cv::mean(likelihood(clothes, trunk))[0] >= enough;
}

std::optional<BodyTracker::Body> BodyTracker::learn(const FacePercept& face) {
  cv::Rect2d whole = trunk_of(face, kTrunkHalf);
  const cv::Rect trunk = in_small(whole);
  if (trunk.area() * scale_ * scale_ < 0.7 * whole.area() || trunk.width < kTrunkSide_px) return std::nullopt;
  Clothes& clothes = people_[face.id];
  // A face in profile is before its body: what is known of the clothes tells where that is.
  if (const auto known = clothes.tellable ? measure(clothes, whole) : std::nullopt) whole.x = known->box_px.x;
  learn_colours(clothes, whole);
  const auto body = clothes.tellable ? measure(clothes, whole) : std::nullopt;
  const auto settle_to = [](double& known, double seen) { known += (known == 0 ? 1 : 0.2) * (seen - known); };
  if (body && face.distance_m > 0 && body->width_px > 0 && !body->cut_off)
    settle_to(clothes.width_px_m, body->width_px * face.distance_m);
  if (body && body->top_px) settle_to(clothes.top_share, (*body->top_px - face.y_px) / face.h_px);
  return body;
}

/// Where, above the trunk's middle, it is no longer like the clothes.
std::optional<double> BodyTracker::top_px(const Clothes& clothes, const cv::Rect& trunk) const {
  constexpr int kGap = 2;
  const cv::Rect column(trunk.x + trunk.width / 4, 0, std::max(1, trunk.width / 2),
                        trunk.y + trunk.height / 2);
  if (column.height < 2) return std::nullopt;
  cv::Mat rows;
  cv::reduce(likelihood(clothes, column & cv::Rect({}, bins_.size())), rows, 1, cv::REDUCE_AVG);
  const auto like = [&](int y) { return static_cast<double>(rows.at<float>(y)); };
  int top = rows.rows - 1;
  if (like(top) < kClothesLike) return std::nullopt;
  for (int y = top, gap = 0; y >= 0 && gap <= kGap; --y) {
    gap = like(y) >= kClothesLike ? 0 : gap + 1;
    if (gap == 0) top = y;
  }
  if (top <= kGap) return std::nullopt;
  const double above = like(top - 1);
  const double part = (like(top) - kClothesLike) / std::max(like(top) - above, 1e-3);
  return (top + 0.5 - part) * scale_;
}

cv::Mat BodyTracker::likelihood(const Clothes& clothes, const cv::Rect& area) const {
  cv::Mat out(area.size(), CV_32F);
  for (int y = 0; y < area.height; ++y) {
    const auto* bin = bins_.ptr<std::uint16_t>(area.y + y) + area.x;
    auto* value = out.ptr<float>(y);
    for (int x = 0; x < area.width; ++x) value[x] = clothes.likely[bin[x]];
  }
  return out;
}

const BodyTracker::Clothes* BodyTracker::tellable(int id) const {
  const auto found = people_.find(id);
  return found == people_.end() || !found->second.tellable ? nullptr : &found->second;
}

/// The largest thing in the small picture that is like the clothes, reaches into these columns and begins no
/// lower; what fills the picture from side to side tells nothing.
std::optional<cv::Rect> BodyTracker::largest_like(const Clothes& clothes, int from_x, int to_x,
                                                  int lowest_top) const {
  cv::Mat labels, stats, middles;
  const cv::Mat like = likelihood(clothes, {{}, bins_.size()}) > kClothesLike;
  const int count = cv::connectedComponentsWithStats(like, labels, stats, middles, 4);
  cv::Rect best;
  int most = 0;
  for (int i = 1; i < count; ++i) {
    const auto of = [&](int what) { return stats.at<int>(i, what); };
    const cv::Rect box(of(cv::CC_STAT_LEFT), of(cv::CC_STAT_TOP), of(cv::CC_STAT_WIDTH),
                       of(cv::CC_STAT_HEIGHT));
    const int area = of(cv::CC_STAT_AREA);
    const bool one_thing = area > kWhole * box.area() && box.width < kEverywhere * like.cols;
    const bool whole = one_thing && box.width >= kTrunkSide_px;
    const bool there = box.x < to_x && box.x + box.width > from_x && box.y <= lowest_top;
    if (!whole || area <= most || !there) continue;
    most = area;
    best = box;
  }
  return most > 0 ? std::optional(best) : std::nullopt;
}

/// Measures where a trunk is when what is like its clothes has been found: as if their face were above it.
std::optional<BodyTracker::Body> BodyTracker::measure_over(const Clothes& clothes, const cv::Rect& like,
                                                           const FacePercept& face) const {
  const cv::Rect2d seen(like.x * scale_, like.y * scale_, like.width * scale_, like.height * scale_);
  const bool goes_above = like.y <= kAtEdge_px;
  cv::Rect2d trunk = seen;
  if (!goes_above && clothes.width_px_m > 0 && clothes.top_share > 0) {
    FacePercept above = face;
    const double times = seen.width * face.distance_m / clothes.width_px_m;
    above.w_px *= times;
    above.h_px *= times;
    above.x_px = seen.x + seen.width / 2 - above.w_px / 2;
    above.y_px = seen.y - clothes.top_share * above.h_px;
    trunk = trunk_of(above, kTrunkHalf);
  }
  auto body = measure(clothes, trunk);
  if (!body) return std::nullopt;
  body->goes_above = goes_above;
  // A hem tells where they are, not how far.
  if (goes_above && seen.height < kTrunkVisible * seen.width) body->width_px = 0;
  return body;
}

std::optional<BodyTracker::Body> BodyTracker::find(const FacePercept& face) const {
  const Clothes* clothes = tellable(face.id);
  if (clothes == nullptr) return std::nullopt;
  const cv::Rect2d whole = trunk_of(face, kTrunkHalf);
  const double reach_px = kClothesSearch_px * scale_ + kClothesSearchShare * whole.width;
  // What begins lower is the floor they stand on.
  const double lower_px = kClothesSearch_px * scale_ + kLowerShare * whole.width;
  const auto like = largest_like(*clothes, cvRound((whole.x - reach_px) / scale_),
                                 cvRound((whole.x + whole.width + reach_px) / scale_),
                                 std::max(kAtEdge_px, cvRound((whole.y + lower_px) / scale_)));
  return like ? measure_over(*clothes, *like, face) : std::nullopt;
}

std::optional<BodyTracker::Body> BodyTracker::find_again(const FacePercept& face) const {
  const Clothes* clothes = tellable(face.id);
  if (clothes == nullptr || clothes->width_px_m <= 0) return std::nullopt;
  const auto like = largest_like(*clothes, 0, bins_.cols, bins_.rows);
  const auto body = like ? measure_over(*clothes, *like, face) : std::nullopt;
  if (!body || body->likeness < kClothesSurely || body->width_px <= 0 || body->cut_off) return std::nullopt;
  // They have not gone farther than people walk.
  const double walked_m = kWalks_mps * seconds(face.age);
  const double away_m = distance_m(face.id, *body);
  const bool fits =
      away_m > kLeastAgain * face.distance_m - walked_m && away_m < kMostAgain * face.distance_m + walked_m;
  return fits ? body : std::nullopt;
}

std::optional<BodyTracker::Body> BodyTracker::measure(const Clothes& clothes, const cv::Rect2d& whole) const {
  const cv::Rect band = in_small({0, whole.y, static_cast<double>(picture_.width), whole.height});
  const int width = std::max(kTrunkSide_px, cvRound(whole.width / scale_));
  if (band.width < width || band.height * scale_ < kTrunkVisible * whole.height) return std::nullopt;
  // Columns: the trunk stands upright.
  cv::Mat columns;
  cv::reduce(likelihood(clothes, band), columns, 0, cv::REDUCE_AVG);
  const auto* column = columns.ptr<float>();
  const int reach = cvRound(kClothesSearchShare * whole.width / scale_);
  const int expected = cvRound(whole.x / scale_);
  const int first = std::clamp(expected - reach, 0, band.width - width);
  const int last = std::clamp(expected + reach, 0, band.width - width);
  const Window best = most_alike(column, first, last, width);
  if (best.likeness < kClothesLike) return std::nullopt;
  const auto [from, to] = grown(column, band.width, best.at, width);
  const bool whole_height = band.height * scale_ > kTrunkRange * whole.height;
  const double inside = std::accumulate(column + from, column + to, 0.0);
  const double all = std::accumulate(column, column + band.width, 0.0);
  const int outside = band.width - (to - from);
  const bool everywhere = outside < (1 - kEverywhere) * band.width || all - inside > kLikeAround * outside;
  const double middle = (everywhere ? best.at + 0.5 * width : middle_of(column, from, to)) * scale_;
  return Body{{middle - whole.width / 2, band.y * scale_, whole.width, band.height * scale_},
              whole_height && !everywhere ? (to - from) * scale_ : 0,
              from == 0 || to == band.width,
              best.likeness,
              everywhere ? std::nullopt : top_px(clothes, {from, band.y, to - from, band.height})};
}

double BodyTracker::distance_m(int id, const Body& body) const {
  const auto found = people_.find(id);
  return found == people_.end() || body.width_px <= 0 ? 0 : found->second.width_px_m / body.width_px;
}

double BodyTracker::distance_m(int id, const Body& body, double expected_m) const {
  const double seen_m = distance_m(id, body);
  if (seen_m <= 0 || (body.cut_off && seen_m > expected_m)) return 0;
  return std::clamp(seen_m, kLeastJump * expected_m, kMostJump * expected_m);
}

void BodyTracker::keep_only(const std::vector<int>& ids) {
  std::erase_if(people_, [&](const auto& entry) {
    return std::find(ids.begin(), ids.end(), entry.first) == ids.end();
  });
}

}  // namespace mirada::vision
