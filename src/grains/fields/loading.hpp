#pragma once
#include <optional>
#include <string>
#include <vector>

#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::fields {

/// A stage of loading and the state before it, to which its strains refer; null: to the first row of its history.
struct Test {
  const StageResult& stage;
  const Packing* before = nullptr;
};

/// What the rows of a history say of a test.
struct Loading {
  statistics::Columns curves;
  bool sheared = false;               ///< along its sides, which slide, or in a cell that is sheared
  bool along_y = false;               ///< sheared along left and right
  bool upright = true;                ///< compressed along y
  bool uniaxial = false;              ///< nothing presses across the axis, or the sample is drawn apart
  std::vector<double> shear, normal;  ///< those that its friction is the ratio of, Pa
};

/// The curves of a test, row by row of its history: `time` since the first row; `strain_x`, `strain_y`, `axial_strain`,
/// `volumetric_strain` since the state before, `shear_strain` since the first row; `sigma_xx`, `sigma_yy`, `tau`, `p`,
/// `q`, `q_over_p` of the sides, `mu` where something is sheared along them, `axial_stress` of a uniaxial test;
/// `solid_fraction`, `inertial_number`; `discharge_rate` and `discharge_mass_rate` of a stage that counts what passes;
/// `dissipated_energy` and `work` where energies were tracked. What is not known
/// is left out. Compression is positive; ratios are NaN where the sides are all but unloaded. Nothing without the
/// sides' places or for a stage that has no history.
std::optional<Loading> loading_of(const Test& test);
/// The same of other rows of that stage, those by cycles.
std::optional<Loading> loading_in(const History& rows, const Test& test);

/// Strains of a test at its stored states, named as above, behind their `time`.
statistics::Columns strains_of_states(const Test& test);

/// Strains of the box of every stored state against a box before them, compression positive: `strain_x` and so on along
/// the axes, and `volumetric_strain`.
template <int D> statistics::Columns strains_of_boxes(const StageResultIn<D>& stage, const DomainIn<D>& before);

/// `dissipated_energy` and `work`, J, since the first row; nothing where energies were not tracked.
statistics::Columns energies_of(const History& rows);

/// Shear strain by two sides that slide, the other's way ahead of the one's over their distance (m), row by row since
/// the first row of `since`; empty where neither slides.
std::vector<double> strain_between(const History& rows, const History& since, int one, int other,
                                   const std::vector<double>& distance);
/// Change of a value with time, to the second order inside and the first at the ends.
std::vector<double> rate_of(const std::vector<double>& value, const std::vector<double>& time);
/// Row by row the rate of a shear strain times the mean diameter over sqrt(pressure/density), pressures in Pa (GDR
/// MiDi, Eur. Phys. J. E 14, 341, 2004).
template <int D>
std::vector<double> inertial_numbers(const std::vector<double>& strain, const std::vector<double>& time,
                                     const std::vector<double>& pressure, const PackingIn<D>& packing);
/// a/b, NaN where b is all but nothing.
std::vector<double> loaded_ratio(const std::vector<double>& a, const std::vector<double>& b);

/// Values at a time between two rows, straight from one to the next; those of the first and last row beyond them.
double at_time(const std::vector<double>& time, const std::vector<double>& values, double t);

}  // namespace arenite::fields
