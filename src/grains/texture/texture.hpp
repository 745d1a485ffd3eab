#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rectangle.hpp"
#include "model/packing.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"
#include "statistics/tails.hpp"

namespace arenite::texture {

using statistics::ByName;
using statistics::Curve;
using statistics::Estimate;
using statistics::ExponentialTail;
using statistics::find;
using statistics::TensorEstimate;
using statistics::unknown;

/// What can make contacts pull.
enum class Pull { measured, adhesion, dashpots };

/// Choices that the definitions leave open (science: T 1.2, 3.2.4, 4.3.1).
struct Options {
  double border = 2.5;                       ///< strip left out along each wall, in mean diameters (T 3.2.4)
  std::optional<double> load_axis = {};      ///< direction of the load for signed anisotropies, rad from x; unset: the direction
                                             ///< of greatest compression of the sample's own stress
  int rattler_contacts = 2;                  ///< a grain with fewer force-bearing contacts than this is a rattler
  Vec2 gravity = {};                         ///< m/s^2; for the balance of grains and walls only
  std::uint64_t seed = 1;                    ///< of the places of windows
  int rev_sizes = 20, rev_places = 50;       ///< windows of the REV study
  int sectors = 18;                          ///< of directions, over half a turn
  Pull pull = Pull::measured;                ///< where a simulation tells; of measured forces pulls are errors unless there is cohesion
  std::vector<double> grain_sigma_hyd = {};  ///< stress of every grain as a laboratory measured it, Pa; empty: that of its contacts
};

/// Where the statistics are taken: the box without the border, or all grains where there is no box.
struct Window : geometry::Rectangle {
  bool known = false;  ///< false: no box
  double border = 0;   ///< strip left out along walls, m
};

/// Solid fraction of windows of growing area and random place (T Fig. 3.6); all arrays have one length.
struct Rev {
  std::vector<double> area_share;              ///< of the box
  std::vector<double> mean, deviation, error;  ///< over places; error = standard error of the mean
};

/// Mean numbers of contacts a grain. Names: "all", "all without rattlers", "POM-POM", "POM-HDPE" (HDPE neighbours of a POM grain), "POM-ANY" = (2
/// N_XX + N_XY)/N_X; of grains that are no disks "all, neighbours" as well, which counts two grains that meet in several contacts once.
struct Coordination {
  ByName<Estimate> mean;
  ByName<Estimate> doubled;       ///< T 4.3.1: 2 (N_XX + N_XY)/N_X, unlike contacts twice; "POM-ANY"
  ByName<Estimate> parts;         ///< T 5.3.1: 2 N_AB/N_p; the parts add up to z; "POM-HDPE"
  ByName<Estimate> share;         ///< N_AB/N_c
  Estimate rattlers;              ///< share of grains
  std::vector<double> histogram;  ///< share of grains with 0, 1, 2, ... contacts
};

/// |<exp(i m theta)>| and the direction of its maximum in [0, 360/m) degrees, with what n random directions would give.
struct Mode {
  int m = 2;
  Estimate amplitude, phase_deg;
  double noise = unknown;  ///< 0.886/sqrt(n)
};

/// Directions of one set of contacts. Angles in degrees from x, in [0, 180).
struct Fabric {
  std::size_t contacts = 0;
  TensorEstimate phi;                ///< <n (x) n>, T eq. 1.6
  Estimate a_c, theta_c_deg;         ///< 2 (phi_1 - phi_2), T eq. 1.8, and its direction
  Estimate a_c_signed;               ///< a_c cos 2(theta_c - theta_load)
  double noise = unknown;            ///< of a_c for random directions: twice 0.886/sqrt(n)
  Estimate a_n, theta_n_deg;         ///< of <F_n>(theta) = F_0 [1 + a_n cos 2(theta - theta_n)]
  Estimate a_t;                      ///< of <F_t>(theta) = -F_0 a_t sin 2(theta - theta_t)
  std::array<Mode, 3> modes;         ///< m = 2, 4, 6
  std::vector<double> sectors;       ///< number of contacts in `Options::sectors` sectors over [0, 180), mirrored beyond
  std::vector<double> sector_force;  ///< mean F_n of each sector, N; 0 where empty
};

/// Anisotropy, signed against the load, of the contacts below and above a force threshold (T Fig. 1.12a).
struct ThresholdCurve {
  std::vector<double> threshold;                               ///< F/<F>
  std::vector<double> below, below_noise, above, above_noise;  ///< NaN where fewer than 10 contacts are left
};

/// Power law of the weak values, x < 1: pdf k x^-alpha.
struct PowerLaw {
  std::size_t count = 0;
  Estimate alpha;  ///< maximum likelihood; error (1 - alpha)/sqrt(n)
};

/// One set of positive values (forces, stresses) over their own mean, x = F/<F>.
struct Distribution {
  std::size_t count = 0;
  Estimate mean;                        ///< N or Pa
  Estimate fraction_above_mean;         ///< share above the set's own mean (P_0)
  Estimate fraction_above_mean_of_all;  ///< share above the mean of all
  double maximum = unknown;             ///< largest x
  ExponentialTail tail;
  PowerLaw weak;
  Estimate k;          ///< from 1/k = 1/(1 - alpha) + 1/beta
  Estimate relation;   ///< beta^2 / ((1 - alpha)(2 - alpha)); 1 where T eq. 1.5 holds
  Curve pdf;           ///< against x; error by counting
  Curve pdf_over_all;  ///< the same against x over the mean of all
  Curve cumulative;    ///< survival function: share above x
};

/// Normal forces between grains. Names: "all", "POM-HDPE", and with glued grains "dry-glued".
struct Forces {
  ByName<Distribution> compressive;
  ByName<Distribution> tensile;         ///< of -F_n; only where contacts pull
  Estimate tensile_share;               ///< share of contacts that pull
  double tensile_mean_ratio = unknown;  ///< mean pull over mean push
};

/// Stress, tension positive, Pa.
struct Stress {
  TensorEstimate whole;                                   ///< sum over contacts, walls included, over the box
  TensorEstimate inner;                                   ///< of the grains (cut) in the window
  Tensor2 grains{unknown, unknown, unknown, unknown};     ///< sum over grains: the same as `whole` to rounding
  Tensor2 walls{unknown, unknown, unknown, unknown};      ///< from wall forces and weight: the same at rest
  double pressure = unknown, deviator = unknown;          ///< -(s1 + s2)/2 and (s1 - s2)/2 of `whole`
  double axis_deg = unknown;                              ///< direction of greatest compression, [0, 180)
  Estimate strong_pressure_share, strong_deviator_share;  ///< carried by contacts with F > <F>
};

/// Hydrostatic stress of grains over the mean of the set. Names: "all", "POM", and with zones "dry", "glued".
struct SigmaNorm {
  ByName<Distribution> sets;
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

/// Six-fold local order.
struct LocalOrder {
  Estimate psi6;             ///< mean over grains with contacts
  ByName<Estimate> ordered;  ///< by material: share of X grains with at least 5 X contacts and psi_6 of these > 0.9
};

/// Directions of the long axes of grains that have one: of second moments of shape that differ.
struct LongAxes {
  std::size_t grains = 0;
  Estimate order;          ///< |<exp(2 i theta)>|: 0 at random, 1 all alike; half the difference of the principal values of <2 a (x) a>
  Estimate direction_deg;  ///< its direction, [0, 180)
  double noise = unknown;  ///< of the order of so many random directions, 0.886/sqrt(n)
};

/// How far the data are from a packing at rest; nothing is corrected.
struct Quality {
  std::size_t doubled_rows = 0;  ///< merged while reading
  std::size_t negative_forces = 0;
  double negative_share = 0;
  double median_imbalance = unknown;    ///< median |sum F| of grains with at least 3 contacts over the mean force
  double friction_ratio_max = unknown;  ///< largest |F_t|/F_n of pushing contacts
  double sliding_share = unknown;       ///< contacts within 1e-3 of that largest ratio
};

/// Everything known of a packing's texture.
struct Texture {
  std::size_t grains = 0, contacts = 0;  ///< of the whole sample; contacts with walls apart
  std::size_t wall_contacts = 0;
  std::size_t considered_grains = 0, considered_contacts = 0;  ///< in the window
  Window window;
  double mean_diameter = 0;        ///< m
  double load_axis_deg = unknown;  ///< used for signs
  Estimate solid_fraction;
  Rev rev;
  Coordination coordination;
  ByName<Fabric> fabric;  ///< "all", "strong", "weak", "POM-POM", "POM-POM strong", "dry-glued", ...
  ThresholdCurve threshold;
  Forces force;
  Stress stress;
  SigmaNorm sigma_norm;
  LocalOrder order;
  LongAxes long_axes;  ///< of grains that are no disks
  PerGrain per_grain;
  Quality quality;
  Numbers more = Numbers::tree();  ///< of statistics whose values nothing but tables and files reads
  std::vector<std::string> notes;  ///< what could not be computed, and why
};

/// Measures everything that the packing allows. A domain of no area means that the box is not known, a thickness that is not positive that the length
/// is not; what needs them is left NaN and a note says so. Throws InputError where measured stresses are not one a grain.
Texture measure(const Packing& packing, const Options& options = {});

/// Solid fraction of windows of the box's shape with `area_share` of its area, one for each of so many random places in the whole box (T Fig. 3.6b);
/// over the box's sides the places are the same for every packing. Empty where the box is not known.
std::vector<double> window_fractions(const Packing& packing, double area_share, int places, std::uint64_t seed = 1);

/// Leaves what places alone tell: for contacts whose forces are not known and stand as 0. Strength, rattlers, anisotropies of forces, stresses and
/// their signs become unknown. `Options::rattler_contacts` should be 0 in the measurement.
void forget_forces(Texture& texture);

/// The statistics as JSON, each as {"value", "error"}; unknown ones are left out. `curves` adds histograms, distributions, REV and the rows by grain.
Numbers numbers(const Texture& texture, bool curves = false);

/// The main statistics as a table: name, value +- error, unit, meaning.
std::string to_text(const Texture& texture);

/// Sum over contacts, walls included, of f (x) l, with f on grain i and l from i to j (or to the wall), N m. Divided by the volume of the box it is
/// the stress, tension positive (T eq. 1.10).
Tensor2 internal_moment(const Contacts& contacts);
/// The same sum over the bonds of a packing, and over its cohesive pairs that are apart.
Tensor2 link_moment(const Packing& packing);

/// Internal moment of every grain about its centre, N m (T eq. 1.9). Their sum is the sum over contacts, bonds and pulls across gaps.
std::vector<Tensor2> grain_moments(const Packing& packing);
/// Mean stress of every grain over its own volume, Pa, tension positive (T eq. 1.11).
std::vector<Tensor2> grain_stresses(const Packing& packing);
/// Half the difference of the principal values, of the symmetric part.
double deviator(const Tensor2& stress);

/// Mass of a grain by its material's density, kg.
double mass_of(const Packing& packing, std::size_t grain);

/// What the internal moment must be at rest by the forces on walls and by weight: sum over wall contacts of f (x) x_c plus sum over grains of m g (x)
/// x.
Tensor2 wall_moment(const Packing& packing, Vec2 gravity);

/// Mean numbers of neighbours a grain of two classes, large and small, where neighbours are grains whose surfaces are no farther apart than a given
/// gap (P eqs. 8, 9 and Fig. 5; there the gap is the peridynamic horizon). Errors by leaving out blocks (statistics/jackknife.hpp); NaN where a class
/// has no grains in the window.
struct GapCoordination {
  std::size_t large = 0, small = 0;  ///< grains in the window
  Estimate ll, ls;                   ///< large and small neighbours of a large grain
  Estimate sl, ss;                   ///< large and small neighbours of a small grain
  Estimate l, s;                     ///< Z_l = Z_ll + Z_ls, Z_s = Z_sl + Z_ss
  Estimate mean;                     ///< Z = (Z_l + Z_s)/2
};

/// Classes are two materials by index; grains of other materials count neither as grains nor as neighbours. Counted are grains whose centre lies in
/// the window (unset: the whole box), while neighbours may lie anywhere, in periodic images too. `gap` in m, 0 or more; grains that overlap are
/// neighbours.
/// Throws InputError for a negative gap or one material for both.
GapCoordination gap_coordination(const Packing& packing, double gap, int large = 0, int small = 1, const std::optional<geometry::Rectangle>& window = {});

}  // namespace arenite::texture
