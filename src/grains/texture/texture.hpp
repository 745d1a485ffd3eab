#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/tensor.hpp"
#include "grains/texture/blocks.hpp"
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
template <int D> struct TimeScatterIn {
  Tensor<D> stress = filled<D>(unknown);  ///< Pa
  double pressure = unknown;              ///< over its mean
};
using TimeScatter = TimeScatterIn<2>;

/// Contacts that hold a grain: in the plane with friction, in space without.
template <int D> inline constexpr int bearing_contacts = 2 * (D - 1);

/// Choices that the definitions leave open (science: T 1.2, 3.2.4, 4.3.1), in the plane and in space.
template <int D> struct ChoicesIn : Measuring {
  int rattler_contacts = bearing_contacts<D>;  ///< a grain with fewer force-bearing contacts than this is a rattler
  Vec<D> gravity = {};                         ///< m/s^2; for the balance of grains and walls only
  RevWindows rev = {};
  Pull pull =
      Pull::measured;  ///< where a simulation tells; of measured forces pulls are errors unless there is cohesion
  std::vector<double> grain_sigma_hyd =
      {};  ///< stress of every grain as a laboratory measured it, Pa; empty: that of its contacts
  std::optional<TimeScatterIn<D>> in_time = {};  ///< of a state in motion; unset: it is at rest, or nobody knows
  std::size_t doubled_rows = 0;                  ///< contacts that stood twice in what was read and were merged
};
template <int D> struct OptionsIn;
template <> struct OptionsIn<2> : ChoicesIn<2> {
  int sectors = 18;  ///< of directions, over half a turn
};
template <> struct OptionsIn<3> : ChoicesIn<3> {
  Vec3 load_direction = {};  ///< where load_axis does not give it: a unit vector; 0: that of greatest compression
};
using Options = OptionsIn<2>;
using SphereOptions = OptionsIn<3>;

/// Where the statistics are taken: the box without the border, or all grains where there is no box.
template <int D> struct WindowIn : Region<D> {
  bool known = false;  ///< false: no box
  double border = 0;   ///< strip left out along walls, m
};
using Window = WindowIn<2>;

/// One row a grain, for drawings; arrays as long as the grains.
template <int D> struct PerGrainIn {
  std::vector<std::uint8_t> considered;  ///< 1 inside the window
  std::vector<std::uint8_t> rattler;
  std::vector<std::int32_t> contacts;  ///< with grains
  std::vector<Tensor<D>> sigma;        ///< Pa; empty without thickness
  std::vector<double> sigma_hyd;       ///< Pa, tension positive; empty without thickness
  std::vector<double> sigma_norm;      ///< over the mean of all considered grains; known without thickness
  std::vector<double> psi6;            ///< |<exp(6 i theta)>| over a disk's contacts; 0 without contacts
};
using PerGrain = PerGrainIn<2>;

/// Everything known of a packing's texture.
template <int D> struct TextureIn {
  WindowIn<D> window;
  double mean_diameter = 0;  ///< m
  Estimate solid_fraction;
  Rev rev;
  PerGrainIn<D> per_grain;
  Numbers numbers = Numbers::tree();  ///< of all statistics, curves among them
  std::vector<std::string> notes;     ///< what could not be computed, and why
};
using Texture = TextureIn<2>;

/// Measures everything that the packing allows. A domain of no area means that the box is not known, as does in space
/// one without walls and periodic sides, which is but the smallest box around the spheres; a thickness that is not
/// positive that the length is not, contacts of which none has a force that forces are not; what needs them is left out
/// and a note says so. Throws InputError where measured stresses are not one a grain, and for a container of spheres
/// without volume.
template <int D> TextureIn<D> measure(const PackingIn<D>& packing, const OptionsIn<D>& options = {});
/// Window and rows by grain alone, as `measure` has them, without the statistics: of rows those of stresses and of the
/// window.
template <int D> TextureIn<D> grain_rows(const PackingIn<D>& packing, const OptionsIn<D>& options = {});

/// The statistics of sigma_norm alone, with their curves, of stresses that a laboratory gave, Pa, one a grain, NaN
/// where not known.
Numbers stress_distribution(const Packing& packing, const std::vector<double>& sigma_hyd);

/// The statistics as JSON, each as {"value", "error"}; unknown ones are left out. `curves` adds histograms,
/// distributions, REV and the rows by grain.
Numbers numbers(const Texture& texture, bool curves = false);

/// The main statistics as a table: name, value +- error, unit, meaning.
std::string to_text(const Texture& texture);

}  // namespace arenite::texture
