#pragma once
#include <cstddef>
#include <functional>
#include <vector>

/// What a solve tells on its way and at its end.
namespace arenite::statics {

/// What a long solve tells on its way.
struct Progress {
  double share = 0;        ///< of the work that is done, 0 to 1, never falling: for a progress bar
  int iterations = 0;      ///< of the static solver, or steps, so far
  double residual = 0;     ///< relative, the latest
  std::size_t broken = 0;  ///< bonds, where they may break
  double strain = 0;       ///< that the sample has reached, where bonds may break
  double stress = 0;       ///< the same for the stress, Pa
};

/// Called between iterations (of dynamics: every 20 steps) and after each round of breaking bonds; false stops the
/// work, and what was reached is handed back with the ending `stopped`. Empty: nobody watches.
using Watch = std::function<bool(const Progress&)>;

/// The watch over a part of the work, whose shares are those from `begin` to `end` of the whole.
inline Watch of_part(const Watch& watch, double begin, double end) {
  if (!watch) return {};
  return [watch, begin, end](Progress p) {
    p.share = begin + (end - begin) * p.share;
    return watch(p);
  };
}
/// Over the part k of so many alike.
inline Watch of_part(const Watch& watch, std::size_t k, std::size_t parts) {
  const double whole = static_cast<double>(parts);
  return of_part(watch, static_cast<double>(k) / whole, static_cast<double>(k + 1) / whole);
}

/// How a solve ended.
struct StaticReport {
  bool converged = false;
  bool stopped = false;  ///< the watch asked for it
  int iterations = 0;
  double residual = 0;          ///< relative, of the field that is handed back, worked out anew
  std::vector<double> history;  ///< relative residual after each iteration, the start first
  int repairs = 0;              ///< CoarseSpace::repairs
  std::size_t loose_nodes = 0;  ///< that no bond holds in some direction
  std::size_t coarse_nodes = 0;
};

}  // namespace arenite::statics
