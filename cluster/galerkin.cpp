#include "galerkin.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/elements/modes.hpp"

namespace arenite::cluster {
namespace {

constexpr std::size_t corners = 8, unknowns = 3 * corners;
using Square = std::array<double, unknowns * unknowns>;  ///< by corner, then component

constexpr unsigned bit(std::size_t corner, std::size_t axis) { return corner >> axis & 1; }

/// The hat of a coarse corner at a corner of one of the eight cells in the coarse cell.
double hat(std::size_t coarse, std::size_t child, std::size_t corner) {
  double weight = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double at = 0.5 * (bit(child, a) + bit(corner, a));
    weight *= bit(coarse, a) ? at : 1 - at;
  }
  return weight;
}

Square stiffness_of(const elements::Modes<3>& modes) {
  Square k{};
  for (std::size_t c = 0; c < corners; ++c)
    for (std::size_t d = 0; d < corners; ++d) {
      const auto block = elements::corner_block<3>(modes, static_cast<int>(c), static_cast<int>(d));
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) k[(3 * c + a) * unknowns + 3 * d + b] = block[a][b];
    }
  return k;
}

/// P^T K P of a cell, P without what is prescribed at its lower and its upper corners.
Square carried_up(const Square& k, std::size_t child, std::uint8_t below, std::uint8_t above) {
  Square p{}, kp{}, sum{};
  for (std::size_t f = 0; f < corners; ++f)
    for (std::size_t a = 0; a < 3; ++a)
      if (!((bit(f, 2) ? above : below) >> a & 1))
        for (std::size_t c = 0; c < corners; ++c) p[(3 * f + a) * unknowns + 3 * c + a] = hat(c, child, f);
  for (std::size_t r = 0; r < unknowns; ++r)
    for (std::size_t m = 0; m < unknowns; ++m)
      for (std::size_t c = 0; c < unknowns; ++c) kp[r * unknowns + c] += k[r * unknowns + m] * p[m * unknowns + c];
  for (std::size_t m = 0; m < unknowns; ++m)
    for (std::size_t r = 0; r < unknowns; ++r)
      for (std::size_t c = 0; c < unknowns; ++c) sum[r * unknowns + c] += p[m * unknowns + r] * kp[m * unknowns + c];
  return sum;
}

/// Such matrices, each worked out once.
class CarriedUp {
 public:
  explicit CarriedUp(const std::array<elements::Modes<3>, 4>& modes) : known_(4 * corners * 8 * 8) {
    for (const elements::Kind kind : elements::solid_kinds) of_kind_[kind] = stiffness_of(modes[kind]);
  }
  const Square& of(elements::Kind kind, std::size_t child, std::uint8_t below, std::uint8_t above) {
    auto& known = known_[((kind * corners + child) * 8 + below) * 8 + above];
    if (!known) known = carried_up(of_kind_[kind], child, below, above);
    return *known;
  }

 private:
  std::array<Square, 4> of_kind_{};
  std::vector<std::optional<Square>> known_;
};

/// The sum over the eight cells of a coarse cell; false where all are empty.
bool add_cells(const Slab& slab, CarriedUp& matrices, std::array<std::int64_t, 3> coarse, Square& sum) {
  bool any = false;
  sum.fill(0);
  for (std::size_t child = 0; child < corners; ++child) {
    const std::int64_t x = 2 * coarse[0] + bit(child, 0), y = 2 * coarse[1] + bit(child, 1),
                       z = 2 * coarse[2] + bit(child, 2);
    const elements::Kind kind = slab.kind(x, y, z);
    if (kind == elements::none) continue;
    const Square& more = matrices.of(kind, child, slab.prescribed_at(z), slab.prescribed_at(z + 1));
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += more[k];
    any = true;
  }
  return any;
}

/// What no cell holds gets a stiffness of its own, and all else a little: hats that nearly coincide on few nodes.
void hold_the_loose(Mat matrix, double usual) {
  Vector diagonal;
  must(MatCreateVecs(matrix, &diagonal, nullptr));
  must(MatGetDiagonal(matrix, diagonal));
  PetscScalar* at = nullptr;
  PetscInt size = 0;
  must(VecGetLocalSize(diagonal, &size));
  must(VecGetArray(diagonal, &at));
  for (PetscInt k = 0; k < size; ++k) at[k] = at[k] > 1e-6 * usual ? at[k] * (1 + 1e-8) : usual;
  must(VecRestoreArray(diagonal, &at));
  must(MatDiagonalSet(matrix, diagonal, INSERT_VALUES));
}

void tell_rigid_modes(DM mesh, Mat matrix) {
  ::Vec places = nullptr;  // the mesh's own
  NullSpace rigid;
  must(DMDASetUniformCoordinates(mesh, 0, 1, 0, 1, 0, 1));
  must(DMGetCoordinates(mesh, &places));
  must(MatNullSpaceCreateRigidBody(places, &rigid));
  must(MatSetNearNullSpace(matrix, rigid));
}

}  // namespace

Matrix coarse_stiffness(const Slab& slab) {
  Matrix matrix;
  must(DMSetMatType(slab.coarse, MATAIJ));
  must(DMCreateMatrix(slab.coarse, &matrix));
  must(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
  std::array<PetscInt, 3> low{}, size{};
  must(DMDAGetCorners(slab.coarse, &low[0], &low[1], &low[2], &size[0], &size[1], &size[2]));
  std::array<PetscInt, 3> first{}, reach{};
  must(DMDAGetGhostCorners(slab.coarse, &first[0], &first[1], &first[2], &reach[0], &reach[1], &reach[2]));
  const auto local = [&](PetscInt x, PetscInt y, PetscInt z) {
    return x - first[0] + reach[0] * (y - first[1] + reach[1] * (z - first[2]));
  };
  CarriedUp matrices(slab.voxels.modes);
  const auto end = [&](std::size_t a) {  // the last node begins no cell
    return std::min<PetscInt>(low[a] + size[a], (slab.cells[a] + 1) / 2);
  };
  Square sum;
  double usual = 0;
  for (const elements::Kind kind : elements::solid_kinds) usual = std::max(usual, slab.voxels.modes[kind].axial);
  for (PetscInt z = low[2]; z < end(2); ++z)
    for (PetscInt y = low[1]; y < end(1); ++y)
      for (PetscInt x = low[0]; x < end(0); ++x) {
        if (!add_cells(slab, matrices, {x, y, z}, sum)) continue;
        std::array<PetscInt, corners> at;
        for (std::size_t c = 0; c < corners; ++c) at[c] = local(x + bit(c, 0), y + bit(c, 1), z + bit(c, 2));
        must(MatSetValuesBlockedLocal(matrix, corners, at.data(), corners, at.data(), sum.data(), ADD_VALUES));
      }
  must(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  must(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  hold_the_loose(matrix, usual);
  tell_rigid_modes(slab.coarse, matrix);
  return matrix;
}

}  // namespace arenite::cluster
