#include "vision/calibration/board.h"

#include <charconv>

#include "vision/calibration/messages.h"

namespace mirada::vision {
namespace {

constexpr int kFewest = 3;
constexpr int kMost = 60;
constexpr double kSmallestSquare_mm = 0.5;
constexpr double kLargestSquare_mm = 1000;

bool read_count(std::string_view text, int& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size() && out >= kFewest && out <= kMost;
}

bool read_grid(const std::string& text, int& columns, int& rows) {
  const std::size_t cross = text.find_first_of("xX");
  if (cross == std::string::npos) return false;
  const std::string_view all = text;
  return read_count(all.substr(0, cross), columns) && read_count(all.substr(cross + 1), rows);
}

void check_length(double value_mm, double most_mm, const char* place, Faults& faults) {
  if (value_mm >= kSmallestSquare_mm && value_mm <= most_mm) return;
  faults.push_back(make_fault(place, messages::board_length,
                              {{"value", number_text(value_mm, 2)},
                               {"min", number_text(kSmallestSquare_mm)},
                               {"max", number_text(most_mm, 2)}}));
}

void check_grid(const std::string& text, const char* place, BoardSpec& board, Faults& faults) {
  if (read_grid(text, board.corner_columns, board.corner_rows)) return;
  faults.push_back(
      make_fault(place, messages::board_grid,
                 {{"value", text}, {"min", std::to_string(kFewest)}, {"max", std::to_string(kMost)}}));
}

bool read_dictionary(const std::string& name, TagFamily& family) {
  if (name == "4x4") family = TagFamily::aruco_4x4;
  if (name == "5x5") family = TagFamily::aruco_5x5;
  if (name == "6x6") family = TagFamily::aruco_6x6;
  if (name == "36h11") family = TagFamily::april_36h11;
  return name == "4x4" || name == "5x5" || name == "6x6" || name == "36h11";
}

}  // namespace

cv::Point3f BoardSpec::corner_B_m(int i) const {
  return {static_cast<float>(i % corner_columns * square_m),
          static_cast<float>(i / corner_columns * square_m), 0.0F};
}

Result<BoardSpec> chessboard_spec(const std::string& corners, double square_mm) {
  BoardSpec board;
  Faults faults;
  check_grid(corners, "--board", board, faults);
  check_length(square_mm, kLargestSquare_mm, "--square-mm", faults);
  if (!faults.empty()) return faults;
  board.square_m = square_mm * 1e-3;
  return board;
}

Result<BoardSpec> charuco_spec(const std::string& squares, double square_mm, double marker_mm,
                               const std::string& dictionary) {
  BoardSpec board;
  board.kind = BoardSpec::Kind::charuco;
  Faults faults;
  check_grid(squares, "--charuco", board, faults);
  check_length(square_mm, kLargestSquare_mm, "--square-mm", faults);
  if (marker_mm == 0) marker_mm = 0.6 * square_mm;
  check_length(marker_mm, 0.95 * square_mm, "--marker-mm", faults);
  if (!read_dictionary(dictionary, board.markers)) {
    faults.push_back(make_fault("--dictionary", messages::board_dictionary, {{"value", dictionary}}));
  }
  const int marks = board.corner_columns * board.corner_rows / 2;
  if (faults.empty() && marks > family_size(board.markers)) {
    faults.push_back(
        make_fault("--charuco", messages::board_too_many_marks,
                   {{"marks", std::to_string(marks)}, {"max", std::to_string(family_size(board.markers))}}));
  }
  if (!faults.empty()) return faults;
  --board.corner_columns;
  --board.corner_rows;
  board.square_m = square_mm * 1e-3;
  board.marker_m = marker_mm * 1e-3;
  return board;
}

}  // namespace mirada::vision
