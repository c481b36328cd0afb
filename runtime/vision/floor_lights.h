#pragma once
#include <array>
#include <optional>

#include "vision/picture_grid.h"

namespace mirada::vision {

/// The lights that one floor has been seen in: where the sun or a lamp reaches it and where it does not. Its
/// colour stays, its brightness jumps, and by the same factor everywhere in a room.
class FloorLights {
 public:
  void forget() { count_ = 0; }
  /// The floor where it was learnt.
  void start(const Look& look);
  /// The floor's look in a light beside one that is known: a shadow's rim lay between them.
  void see(const Look& look);

  /// The known light which something of this look has if it is the floor.
  std::optional<Look> of(const Look& look) const;
  /// Whether the floor's look may turn into the other one where a shadow begins or ends.
  bool is_change(const Look& from, const Look& to) const;
  /// The brightest; 0 before start().
  int brightest() const;

 private:
  static constexpr std::size_t kMost = 4;
  Look* nearest(const Look& look);

  std::array<Look, kMost> lights_{};
  std::size_t count_ = 0;
};

}  // namespace mirada::vision
