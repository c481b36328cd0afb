#include "vision/calibration/picture_set.h"

#include <algorithm>
#include <map>
#include <optional>

#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "vision/calibration/board_finder.h"
#include "vision/calibration/messages.h"

namespace mirada::vision {
namespace {

constexpr int kLargestPicture_px = 12'000;
constexpr std::uintmax_t kMaxPictureFile_bytes = 256u << 20;

struct Looked {
  std::string image;
  cv::Size size_px;  ///< 0x0 when it could not be read
  std::optional<BoardView> view;
  Faults faults;
};

Looked look_at(const std::filesystem::path& file, BoardFinder& finder) {
  Looked out{file.filename().string(), {}, std::nullopt, {}};
  auto gray = read_gray(file);
  if (!gray) {
    out.faults = gray.faults();
    return out;
  }
  out.size_px = gray->size();
  auto view = finder.find(*gray, out.image);
  if (view) {
    out.view = std::move(*view);
  } else {
    out.faults = view.faults();
  }
  return out;
}

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// The size most pictures have; of two equally common ones that with more boards, then the larger.
cv::Size common_size(const std::vector<Looked>& all) {
  std::map<std::pair<int, int>, std::pair<int, int>> votes;  // pictures, boards
  for (const Looked& one : all) {
    if (one.size_px.empty()) continue;
    auto& [pictures, boards] = votes[{one.size_px.width, one.size_px.height}];
    ++pictures;
    boards += one.view.has_value();
  }
  const auto best = std::max_element(votes.begin(), votes.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return best == votes.end() ? cv::Size() : cv::Size(best->first.first, best->first.second);
}

}  // namespace

Result<cv::Mat> read_gray(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  auto bytes = read_file(file, kMaxPictureFile_bytes);
  if (!bytes) return bytes.faults();
  cv::Mat gray;
  try {
    const cv::Mat raw(1, static_cast<int>(bytes->size()), CV_8UC1, bytes->data());
    if (!bytes->empty()) gray = cv::imdecode(raw, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    gray.release();
  }
  if (gray.empty()) return make_fault(name, messages::picture_unreadable);
  if (gray.cols > kLargestPicture_px || gray.rows > kLargestPicture_px) {
    return make_fault(name, messages::picture_too_large,
                      {{"width", std::to_string(gray.cols)},
                       {"height", std::to_string(gray.rows)},
                       {"max", std::to_string(kLargestPicture_px)}});
  }
  return gray;
}

PictureSet read_pictures(const std::vector<std::filesystem::path>& files, const BoardSpec& board,
                         const std::function<void(std::size_t)>& on_picture) {
  BoardFinder finder(board);
  std::vector<Looked> all;
  for (const auto& file : files) {
    all.push_back(look_at(file, finder));
    if (on_picture) on_picture(all.size());
  }
  const cv::Size size = common_size(all);
  PictureSet out;
  for (Looked& one : all) {
    if (!one.size_px.empty() && one.size_px != size) {
      one.faults = {make_fault(one.image, messages::picture_other_size,
                               {{"value", size_text(one.size_px)}, {"wanted", size_text(size)}})};
    } else if (one.view) {
      out.views.push_back(std::move(*one.view));
    }
    out.refused.insert(out.refused.end(), one.faults.begin(), one.faults.end());
  }
  return out;
}

}  // namespace mirada::vision
