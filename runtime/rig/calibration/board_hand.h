#pragma once
#include <functional>
#include <optional>

#include "vision/calibration/board_picture.h"
#include "world/held_board.h"

namespace mirada::rig {

/// Where the simulated room's hand is told to hold a board; nothing = put it away. From any thread.
using HoldBoard = std::function<void(std::optional<world::HeldBoard>)>;

/// A hand that brings a board to where it is asked for, a good part of the way with each picture, and then
/// holds it still. Puts it away when destroyed. One thread.
class BoardHand {
 public:
  BoardHand(const vision::BoardSpec& board, HoldBoard hold);
  ~BoardHand();
  BoardHand(const BoardHand&) = delete;
  BoardHand& operator=(const BoardHand&) = delete;

  void step(const Eigen::Isometry3d& X_CB_wanted);

 private:
  world::HeldBoard board_;
  bool held_ = false;
  HoldBoard hold_;
};

}  // namespace mirada::rig
