#pragma once
#include <array>
#include <variant>

#include "solid/peridynamics/bond_blocks.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/couplings.hpp"
#include "solid/statics/discretisation.hpp"

namespace arenite::peridynamics {

using Kernels = statics::KernelsOf<Bonds>;

/// The kernels of a law for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run
/// here. "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels(const BondLawChoice& law = {});
const Kernels* kernels(const char* name, const BondLawChoice& law = {});

/// The kernels of every law, in the order of BondLawChoice.
struct KernelSet {
  const char* name;
  std::array<Kernels, std::variant_size_v<BondLawChoice>> by_law;
};

extern const KernelSet avx2_kernels, avx512_kernels;

// What the static solver asks of bonds (statics/discretisation.hpp), beside block_diagonal and couplings.
inline const Kernels& kernels_of(const Bonds& bonds) { return kernels(bonds.law); }
/// A bond's energy is at most twice that of its two ends held apart.
inline statics::Smoothing smoothing_of(const Bonds&) { return {4, 0.1, 2}; }

}  // namespace arenite::peridynamics
