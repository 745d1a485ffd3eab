#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/texture/rev.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::texture {

using statistics::Estimate;
using statistics::unknown;

/// What can make contacts pull.
enum class Pull { measured, adhesion, dashpots };

/// How far a sample in motion goes astray from its mean over time, as a whole: blocks in space cannot see it. Standard
/// deviations of one moment.
struct TimeScatter {
  Tensor2 stress{unknown, unknown, unknown, unknown};  ///< Pa
  double pressure = unknown;                           ///< over its mean
};

/// Choices that the definitions leave open (science: T 1.2, 3.2.4, 4.3.1).
struct Options : Measuring {
  int rattler_contacts = 2;  ///< a grain with fewer force-bearing contacts than this is a rattler
  Vec2 gravity = {};         ///< m/s^2; for the balance of grains and walls only
  RevWindows rev = {};
  int sectors = 18;  ///< of directions, over half a turn
  Pull pull =
      Pull::measured;  ///< where a simulation tells; of measured forces pulls are errors unless there is cohesion
  std::vector<double> grain_sigma_hyd =
      {};  ///< stress of every grain as a laboratory measured it, Pa; empty: that of its contacts
  std::optional<TimeScatter> in_time = {};  ///< of a state in motion; unset: it is at rest, or nobody knows
  std::size_t doubled_rows = 0;             ///< contacts that stood twice in what was read and were merged
};

/// Where the statistics are taken: the box without the border, or all grains where there is no box.
struct Window : geometry::Rectangle {
  bool known = false;  ///< false: no box
  double border = 0;   ///< strip left out along walls, m
};

/// One row a grain, for drawings; arrays as long as Packing::grains.
struct PerGrain {
  std::vector<std::uint8_t> considered;  ///< 1 inside the window
  std::vector<std::uint8_t> rattler;
  std::vector<std::int32_t> contacts;  ///< with grains
  std::vector<Tensor2> sigma;          ///< Pa; empty without thickness
  std::vector<double> sigma_hyd;       ///< Pa, tension positive; empty without thickness
  std::vector<double> sigma_norm;      ///< over the mean of all considered grains; known without thickness
  std::vector<double> psi6;            ///< |<exp(6 i theta)>| over a grain's contacts; 0 without contacts
};

/// Everything known of a packing's texture.
struct Texture {
  Window window;
  double mean_diameter = 0;  ///< m
  Estimate solid_fraction;
  Rev rev;
  PerGrain per_grain;
  Numbers numbers = Numbers::tree();  ///< of all statistics, curves among them
  std::vector<std::string> notes;     ///< what could not be computed, and why
};

/// Measures everything that the packing allows. A domain of no area means that the box is not known, a thickness that
/// is not positive that the length is not, contacts of which none has a force that forces are not; what needs them is
/// left out and a note says so. Throws InputError where measured stresses are not one a grain.
Texture measure(const Packing& packing, const Options& options = {});
/// Window and rows by grain alone, as `measure` has them, without the statistics: of rows those of stresses and of the
/// window.
Texture grain_rows(const Packing& packing, const Options& options = {});

/// The statistics of sigma_norm alone, with their curves, of stresses that a laboratory gave, Pa, one a grain, NaN
/// where not known.
Numbers stress_distribution(const Packing& packing, const std::vector<double>& sigma_hyd);

/// The statistics as JSON, each as {"value", "error"}; unknown ones are left out. `curves` adds histograms,
/// distributions, REV and the rows by grain.
Numbers numbers(const Texture& texture, bool curves = false);

/// The main statistics as a table: name, value +- error, unit, meaning.
std::string to_text(const Texture& texture);

}  // namespace arenite::texture
