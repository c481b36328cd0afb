#include "vision/tags/tag_finder.h"

#include <algorithm>
#include <cassert>
#include <span>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include "vision/tags/aruco_codes.h"

namespace mirada::vision {
namespace {

/// A family made of our own tables, in libapriltag's terms. The bits go round: the second quarter is the
/// first turned by 90 degrees and so on, for so the library turns a code.
struct ArucoFamily {
  ArucoFamily(std::span<const std::uint64_t> codes_by_rows, int side, int min_distance) {
    for (int turn = 0; turn < 4; ++turn) add_quarter(side, turn);
    if (side % 2 == 1) add_bit(side / 2, side / 2);
    for (const std::uint64_t code : codes_by_rows) codes.push_back(reordered(code, side));
    family.ncodes = static_cast<std::uint32_t>(codes.size());
    family.codes = codes.data();
    family.width_at_border = side + 2;
    family.total_width = side + 4;
    family.nbits = static_cast<std::uint32_t>(side * side);
    family.bit_x = xs.data();
    family.bit_y = ys.data();
    family.h = static_cast<std::uint32_t>(min_distance);
    family.name = name;
  }
  ArucoFamily(const ArucoFamily&) = delete;
  ArucoFamily& operator=(const ArucoFamily&) = delete;

  void add_bit(int x, int y) {
    xs.push_back(static_cast<std::uint32_t>(x + 1));
    ys.push_back(static_cast<std::uint32_t>(y + 1));
  }
  void add_quarter(int side, int turn) {
    for (int ring = 0; ring < side / 2; ++ring) {
      for (int i = ring; i < side - 1 - ring; ++i) {
        int x = i;
        int y = ring;
        for (int t = 0; t < turn; ++t) {
          const int old_x = x;
          x = side - 1 - y;
          y = old_x;
        }
        add_bit(x, y);
      }
    }
  }
  std::uint64_t reordered(std::uint64_t by_rows, int side) const {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const auto place = (ys[i] - 1) * static_cast<std::uint32_t>(side) + (xs[i] - 1);
      out = out << 1 | (by_rows >> (static_cast<std::uint32_t>(side * side) - 1 - place) & 1);
    }
    return out;
  }

  std::vector<std::uint64_t> codes;
  std::vector<std::uint32_t> xs, ys;
  char name[6] = "aruco";
  apriltag_family_t family{};
};

std::unique_ptr<ArucoFamily> make_aruco(TagFamily kind) {
  // Smallest distance between two codes of the 250, as the dictionaries state it.
  switch (kind) {
    case TagFamily::aruco_4x4:
      return std::make_unique<ArucoFamily>(kAruco4x4, 4, 3);
    case TagFamily::aruco_5x5:
      return std::make_unique<ArucoFamily>(kAruco5x5, 5, 6);
    case TagFamily::aruco_6x6:
      return std::make_unique<ArucoFamily>(kAruco6x6, 6, 11);
    case TagFamily::april_36h11:
      break;
  }
  return nullptr;
}

TagSighting sighting_of(const apriltag_detection_t& found) {
  TagSighting out;
  out.id = found.id;
  out.bits_corrected = found.hamming;
  out.margin = found.decision_margin;
  // libapriltag goes round from the bottom left, and its pixels' centres lie at halves.
  for (std::size_t i = 0; i < 4; ++i) {
    out.corners_px[3 - i] = {found.p[i][0] - 0.5, found.p[i][1] - 0.5};
  }
  return out;
}

constexpr int kSmallestPicture_px = 16;

}  // namespace

struct TagFinder::Impl {
  std::unique_ptr<ArucoFamily> aruco;
  apriltag_family_t* april = nullptr;
  apriltag_detector_t* detector = nullptr;

  ~Impl() {
    apriltag_detector_destroy(detector);
    if (april) tag36h11_destroy(april);
  }
};

TagFinder::TagFinder(TagFamily family, int threads) : impl_(std::make_unique<Impl>()) {
  impl_->detector = apriltag_detector_create();
  impl_->detector->nthreads = threads;
  impl_->detector->quad_decimate = 1;
  impl_->aruco = make_aruco(family);
  if (impl_->aruco) {
    const int corrected = impl_->aruco->family.h > 5 ? 2 : 1;
    apriltag_detector_add_family_bits(impl_->detector, &impl_->aruco->family, corrected);
  } else {
    impl_->april = tag36h11_create();
    apriltag_detector_add_family(impl_->detector, impl_->april);
  }
}

TagFinder::~TagFinder() = default;
TagFinder::TagFinder(TagFinder&&) noexcept = default;
TagFinder& TagFinder::operator=(TagFinder&&) noexcept = default;

std::vector<TagSighting> TagFinder::find(const cv::Mat& gray) {
  assert(gray.type() == CV_8UC1);
  if (gray.cols < kSmallestPicture_px || gray.rows < kSmallestPicture_px) return {};
  image_u8_t picture = {gray.cols, gray.rows, static_cast<std::int32_t>(gray.step), gray.data};
  zarray_t* list = apriltag_detector_detect(impl_->detector, &picture);
  std::vector<TagSighting> out;
  for (int i = 0; i < zarray_size(list); ++i) {
    apriltag_detection_t* found = nullptr;
    zarray_get(list, i, static_cast<void*>(&found));
    out.push_back(sighting_of(*found));
  }
  apriltag_detections_destroy(list);
  std::sort(out.begin(), out.end(), [](const TagSighting& a, const TagSighting& b) { return a.id < b.id; });
  return out;
}

int family_size(TagFamily family) { return family == TagFamily::april_36h11 ? 587 : 250; }

}  // namespace mirada::vision
