#include "rig/calibration/board_hand.h"

#include <cmath>

#include "base/units.h"

namespace mirada::rig {
namespace {

constexpr int kSquare_px = 24;
constexpr double kShare = 0.45;  ///< of the way that is left
constexpr double kThere_m = 0.002;
constexpr double kThere_rad = rad(0.5);

}  // namespace

BoardHand::BoardHand(const vision::BoardSpec& board, HoldBoard hold) : hold_(std::move(hold)) {
  vision::BoardPicture picture = vision::board_picture(board, kSquare_px);
  board_.gray = std::move(picture.gray);
  board_.px_per_m = picture.px_per_m;
  board_.origin_px = picture.origin_px;
}

BoardHand::~BoardHand() { hold_(std::nullopt); }

void BoardHand::step(const Eigen::Isometry3d& X_CB_wanted) {
  const Eigen::Quaterniond from(board_.X_CB.linear());
  const Eigen::Quaterniond to(X_CB_wanted.linear());
  const Eigen::Vector3d way = X_CB_wanted.translation() - board_.X_CB.translation();
  const bool there = way.norm() < kThere_m && from.angularDistance(to) < kThere_rad;
  if (!held_ || there) {
    board_.X_CB = X_CB_wanted;
  } else {
    board_.X_CB.linear() = from.slerp(kShare, to).toRotationMatrix();
    board_.X_CB.translation() += kShare * way;
  }
  held_ = true;
  hold_(board_);
}

}  // namespace mirada::rig
