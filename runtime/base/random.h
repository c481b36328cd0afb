#pragma once
#include <cstdint>
#include <string_view>

namespace mirada {

/// PCG32 (O'Neill 2014, XSH-RR): the same numbers on every machine. One stream per source of chance, by name,
/// so that one more draw in one place changes nothing elsewhere.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view stream);

  std::uint32_t next();
  /// In [0, 1), with 53 bits.
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// A whole number in [low, high], both included; without modulo bias.
  std::int64_t integer(std::int64_t low, std::int64_t high);
  /// Mean 0, standard deviation 1 (Box-Muller).
  double gaussian();

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace mirada
