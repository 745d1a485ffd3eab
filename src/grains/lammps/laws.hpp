#pragma once
#include <string>

#include "grains/dem/sample.hpp"

/// A sample in the words of LAMMPS: what its granular styles can express of a stage, the input that says so, and the
/// way back.
namespace arenite::lammps {

/// The contact law between grains of two materials as `pair_style granular` has it (places in `start.materials`), at
/// the sample's friction of now.
template <int D> std::string pair_words(const dem::SampleIn<D>& sample, int a, int b);

/// The same between grains of a material and a wall, for `fix wall/gran/region granular`.
template <int D> std::string wall_words(const dem::SampleIn<D>& sample, int material);

/// The restitution that LAMMPS's `damping tsuji` must be told to damp with alpha sqrt(m_eff k): the root of its
/// polynomial for alpha, which is fitted and no inverse of ours. Those it can be told lie below `largest_tsuji`.
double tsuji_restitution(double alpha);
inline constexpr double largest_tsuji = 1.2728;

/// alpha of the sample's dashpots, which follow restitution, over sqrt(m_eff k) as LAMMPS counts k: the secant
/// stiffness at the present overlap.
double damping_over_root(const dem::ContactParameters& contact);

}  // namespace arenite::lammps
