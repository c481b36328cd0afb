#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "vision/calibration/board.h"

namespace mirada::vision {

/// The usable pictures of a set, and every other one with its reason.
struct PictureSet {
  std::vector<BoardView> views;  ///< all of one size
  Faults refused;                ///< one or more a picture, in the order given
};

/// Reads pictures from files and finds the board in each. The size that most pictures have counts; pictures
/// of another are refused. One picture is in memory at a time. `on_picture` (may be empty) hears of each
/// picture when it is done: its number from 1.
PictureSet read_pictures(const std::vector<std::filesystem::path>& files, const BoardSpec& board,
                         const std::function<void(std::size_t)>& on_picture = {});

/// One picture as grey levels, the way the sensor saw it (no turning by EXIF); or why it cannot be used.
Result<cv::Mat> read_gray(const std::filesystem::path& file);

}  // namespace mirada::vision
