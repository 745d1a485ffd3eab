#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "dem/laws/laws.hpp"

namespace arenite::dem {

struct DiskRecord;
struct SlotForce;

/// What the pair loop reads and fills; the arrays are those of ContactList.
struct PairTask {
  const DiskRecord* record;
  const std::int32_t *i, *j;
  const double *stiffness, *damping, *viscosity, *strength;
  double* memory;
  SlotForce* force;
  double friction;   ///< mu
  double floor;      ///< lowest F_n of contacts that are not glued, N
  double arm_share;  ///< of the overlap that each arm lacks: 1/2 (contact point) or 0 (full radius)
};

/// The inner loops, compiled once for each kind of processor. All kernels give the same bits: the same exactly rounded
/// operations in the same order for every contact and disk, only more of them at a time.
struct Kernel {
  const char* name;
  /// Forces of slots begin .. end-1, all of two disks; by normal law, adhesion and friction law (index in its variant).
  using PairLoop = void (*)(const PairTask&, const ContactLaws&, std::size_t begin, std::size_t end);
  PairLoop pairs[2][2][2];
};

extern const Kernel portable_kernel, avx2_kernel, avx512_kernel;

/// The kernel that `asked` means on this machine: "auto" is the widest it has. InputError for one that is unknown or
/// that the processor lacks.
const Kernel& find_kernel(const std::string& asked);

}  // namespace arenite::dem
