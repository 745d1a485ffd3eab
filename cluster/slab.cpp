#include "slab.hpp"

#include <algorithm>
#include <utility>

#include "solid/elements/kernels/kernels.hpp"

namespace arenite::cluster {
namespace {

constexpr int components = 3;

Box corners_of(DM mesh) {
  std::array<PetscInt, 3> low{}, size{};
  must(DMDAGetCorners(mesh, &low[0], &low[1], &low[2], &size[0], &size[1], &size[2]));
  Box box;
  for (std::size_t a = 0; a < 3; ++a) box.low[a] = low[a], box.high[a] = low[a] + size[a];
  return box;
}

/// Cells around the fine nodes of a rank, and those in the coarse cells that begin at its coarse nodes.
Box reach_of(const Box& own, const Box& coarse, const std::array<int, 3>& cells) {
  Box reach;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t all = (cells[a] + 1) / 2 * 2;
    reach.low[a] = std::max<std::int64_t>(0, std::min(own.low[a] - 1, 2 * coarse.low[a]));
    reach.high[a] = std::min(all, std::max(own.high[a], 2 * coarse.high[a]));
  }
  return reach;
}

/// Whether a node of the fine mesh is one of the sample.
bool is_inside(const statics::Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z) {
  return x < grid.width && y < grid.height && z < grid.depth;
}
std::ptrdiff_t index_in(const statics::Grid& grid, std::int64_t x, std::int64_t y, std::int64_t z) {
  return grid.index(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
}

void make_meshes(Slab& s) {
  std::array<PetscInt, 3> nodes;
  for (std::size_t a = 0; a < 3; ++a) nodes[a] = (s.cells[a] + 1) / 2 + 1;
  constexpr auto ends = DM_BOUNDARY_NONE;
  must(DMDACreate3d(PETSC_COMM_WORLD, ends, ends, ends, DMDA_STENCIL_BOX, nodes[0], nodes[1], nodes[2], PETSC_DECIDE,
                    PETSC_DECIDE, PETSC_DECIDE, components, 1, nullptr, nullptr, nullptr, &s.coarse));
  must(DMSetUp(s.coarse));
  must(DMRefine(s.coarse, PETSC_COMM_WORLD, &s.fine));
}

/// The cells of a rank's reach as a sample of their own.
elements::Voxels voxels_of(const Problem& problem, const Box& reach, const elements::Voxels* whole) {
  const auto pack = [&](const Box& box, std::vector<std::uint8_t>& kinds) {
    box.each([&](auto x, auto y, auto z) {
      const bool inside = x < problem.cells[0] && y < problem.cells[1] && z < problem.cells[2];
      kinds.push_back(inside ? static_cast<std::uint8_t>(whole->kind(index_in(whole->grid, x, y, z)))
                             : std::uint8_t{elements::none});
    });
  };
  const std::vector<std::uint8_t> kinds = handed_out<std::uint8_t>(reach, 1, pack);
  elements::Voxels voxels;
  for (std::size_t a = 0; a < 3; ++a) voxels.cells[a] = static_cast<int>(reach.size(a));
  voxels.grid = {voxels.cells[0] + 1, voxels.cells[1] + 1, voxels.cells[2] + 1};
  voxels.words = Buffer<std::uint32_t>(voxels.grid.padded_size());
  voxels.modes = problem.modes;
  voxels.table = problem.table;
  std::size_t k = 0;
  voxels.each([&](int x, int y, int z) { voxels.words[voxels.grid.index(x, y, z)] = kinds[k++]; });
  return voxels;
}

}  // namespace

Slab::Slab(const Problem& problem, const std::vector<std::uint8_t>& whole_prescribed, const elements::Voxels* whole)
    : cells(problem.cells),
      prescribed(whole_prescribed),
      inverse{statics::BlockDiagonalIn<3, float>(0)} {
  make_meshes(*this);
  own = corners_of(fine);
  reach = reach_of(own, corners_of(coarse), cells);
  voxels = voxels_of(problem, reach, whole);
  u = force = statics::FieldIn<3, double>(voxels.grid.padded_size());
  for (int level = 0; level < voxels.grid.levels(); ++level) levels.push_back(prescribed_at(reach.low[2] + level));
  inverse = statics::inverse_diagonal(voxels.grid, elements::block_diagonal(voxels), levels);
  must(DMCreateLocalVector(fine, &ghosted));
}

void Slab::stiffness(::Vec from, ::Vec to) {
  must(DMGlobalToLocalBegin(fine, from, INSERT_VALUES, ghosted));
  must(DMGlobalToLocalEnd(fine, from, INSERT_VALUES, ghosted));
  Box around = own;
  for (std::size_t a = 0; a < 3; ++a) {
    around.low[a] = std::max(reach.low[a], own.low[a] - 1);
    around.high[a] = std::min(reach.high[a] + 1, own.high[a] + 1);
  }
  {
    const ReadValues values(fine, ghosted);
    around.each([&](auto x, auto y, auto z) {
      const PetscScalar* v = values(x, y, z);
      u.set(node(x, y, z), {v[0], v[1], v[2]});
    });
  }
  elements::kernels_of(voxels).force(voxels, levels.data(), statics::pointers(std::as_const(u)),
                                     statics::pointers(force));
  const Values values(fine, to);
  own.each([&](auto x, auto y, auto z) {
    const std::ptrdiff_t i = node(x, y, z);
    for (int c = 0; c < components; ++c) values(x, y, z)[c] = -force[c][i];
  });
}

void Slab::unsmoothed(::Vec r, ::Vec to) const {
  const ReadValues from(fine, r);
  const Values values(fine, to);
  own.each([&](auto x, auto y, auto z) {
    const auto block = inverse.blocks.at(node(x, y, z));
    const PetscScalar* v = from(x, y, z);
    for (int a = 0; a < components; ++a)
      values(x, y, z)[a] = block(a, 0) * v[0] + block(a, 1) * v[1] + block(a, 2) * v[2];
  });
}

void Slab::keep_free(::Vec v) const {
  const Values values(fine, v);
  own.each([&](auto x, auto y, auto z) {
    const std::ptrdiff_t i = node(x, y, z);
    for (int a = 0; a < components; ++a)
      if (inverse.blocks(a, a)[i] == 0) values(x, y, z)[a] = 0;
  });
}

void Slab::hand_out(const statics::FieldIn<3, double>& whole, const statics::Grid& grid, ::Vec to) const {
  const auto pack = [&](const Box& box, std::vector<double>& values) {
    box.each([&](auto x, auto y, auto z) {
      const bool inside = is_inside(grid, x, y, z);
      for (int c = 0; c < components; ++c) values.push_back(inside ? whole[c][index_in(grid, x, y, z)] : 0);
    });
  };
  const std::vector<double> here = handed_out<double>(own, components, pack);
  PetscScalar* at = nullptr;  // a rank's nodes lie as in its box
  must(VecGetArrayWrite(to, &at));
  std::ranges::copy(here, at);
  must(VecRestoreArrayWrite(to, &at));
}

void Slab::hand_in(::Vec from, const statics::Grid& grid, statics::FieldIn<3, double>& whole) const {
  const PetscScalar* at = nullptr;
  must(VecGetArrayRead(from, &at));
  std::vector<double> here(at, at + components * own.count());
  must(VecRestoreArrayRead(from, &at));
  handed_in(own, components, std::move(here), [&](const Box& box, const std::vector<double>& values) {
    std::size_t k = 0;
    box.each([&](auto x, auto y, auto z) {
      for (int c = 0; c < components; ++c, ++k)
        if (is_inside(grid, x, y, z)) whole[c][index_in(grid, x, y, z)] = values[k];
    });
  });
}

}  // namespace arenite::cluster
