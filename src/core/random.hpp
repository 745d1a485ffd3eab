#pragma once
#include <cstdint>

namespace arenite {

/// What a stream of random numbers is for; a new use gets a new number, so that uses never share one.
enum class Purpose : std::uint32_t {
  radius = 1,
  position = 2,
  order = 3,
  velocity = 4,
  window = 5,
  detector = 7,
  camera_noise = 8,
  dropped_frames = 9,
  sweep = 10,
  photograph = 11,
  bonds = 12,
  orientation = 13,
  flicker = 14,
  level_jump = 15,
  emissivity = 16,
  inflow = 17,
  inflow_place = 18,
  test = 99
};

/// Counter-based random numbers (Philox 4x32-10): the n-th number of a stream depends only on (seed, purpose, index,
/// n), never on which thread asks or in which order. Distributions are our own, because the standard library's differ
/// between platforms.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t index = 0);
  std::uint64_t bits();                  ///< 64 random bits
  double uniform();                      ///< in [0, 1)
  double uniform(double a, double b);    ///< in [a, b)
  double normal();                       ///< mean 0, standard deviation 1 (Box-Muller)
  std::uint64_t below(std::uint64_t n);  ///< in 0..n-1, n > 0, without bias

 private:
  std::uint64_t seed_, index_;
  std::uint32_t purpose_, draw_ = 0;
  std::uint64_t spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace arenite
