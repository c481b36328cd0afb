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
  enum class How {
    from_elsewhere,  ///< than where it was seen last
    beside_another   ///< next to the floor in a light that counts: a shadow's rim lay between them
  };
  /// The floor's look in a picture. In a light that is new it has to be seen from two places, or beside a
  /// known one, before it counts: one thing that stands in the way would not be there again. True: it did not
  /// count yet.
  bool see(const Look& look, How how);

  /// The light, of those that count, which something of this look has if it is the floor.
  std::optional<Look> of(const Look& look) const;
  /// Whether the floor's look may turn into the other one where a shadow begins or ends.
  bool is_change(const Look& from, const Look& to) const;
  /// The brightest that counts; 0 before start().
  int brightest() const;

 private:
  struct Light {
    Look look;
    bool counts = false;
  };
  static constexpr std::size_t kMost = 4;
  Light* nearest(const Look& look);

  std::array<Light, kMost> lights_{};
  std::size_t count_ = 0;
};

}  // namespace mirada::vision
