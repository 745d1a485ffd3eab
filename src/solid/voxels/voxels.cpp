#include "solid/voxels/voxels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/definite.hpp"
#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "solid/statics/halo.hpp"

namespace arenite::voxels {
namespace {

void check(const char* kind, const Constants& c) {
  if (!(c.young > 0) || !std::isfinite(c.young))
    throw refusal("the Young modulus of {} voxels is {:g} Pa; give a positive one", kind, c.young);
  if (!(c.poisson > -1 && c.poisson < 0.5))
    throw refusal("Poisson's ratio of {} voxels is {:g}; give one above -1 and below 0.5", kind, c.poisson);
}

/// The sign that a corner's value has in a mode.
double sign_of(int mode, int corner) { return std::popcount(static_cast<unsigned>(mode & ~corner)) % 2 ? -1 : 1; }

/// Phase and grain around a voxel, beyond the faces of the sample too where it is periodic.
struct Around {
  const VoxelMap& map;
  bool periodic;

  /// Kind of the voxel at (x, y, z), by its own phase and those around it.
  Kind kind_at(int x, int y, int z) const {
    const std::size_t own = map.index(x, y, z);
    if (map.phase[own] == Phase::empty) return none;
    const bool in_grain = map.phase[own] == Phase::particle;
    for (int c = z - 1; c <= z + 1; ++c)
      for (int b = y - 1; b <= y + 1; ++b)
        for (int a = x - 1; a <= x + 1; ++a) {
          const bool outside = a < 0 || b < 0 || c < 0 || a >= map.width || b >= map.height || c >= map.depth;
          if (outside && !periodic) continue;
          const std::size_t n = outside ? map.index((a + map.width) % map.width, (b + map.height) % map.height,
                                                    (c + map.depth) % map.depth)
                                        : map.index(a, b, c);
          if (map.phase[n] == Phase::particle && (!in_grain || map.grain[n] != map.grain[own])) return interface;
        }
    return in_grain ? particle : matrix;
  }
};

/// The largest eigenvalue of D_e^-1 K_e of one kind, by the power method.
double highest_ratio(const Modes& m) {
  std::array<double, 24> u{};
  for (std::size_t k = 0; k < 24; ++k) u[k] = std::cos(2.0 * static_cast<double>(k) + 1);  // along no symmetry
  std::array<std::array<double, 9>, 8> inverses;
  for (int c = 0; c < 8; ++c) {
    const auto block = corner_block(m, c, c);
    inverses[static_cast<std::size_t>(c)] =
        inverse_of_definite<3>({block[0][0], block[0][1], block[0][2], block[1][0], block[1][1], block[1][2],
                                block[2][0], block[2][1], block[2][2]});
  }
  double ratio = 0;
  for (int round = 0; round < 2000; ++round) {
    Amplitudes<double> a{};
    for (int c = 0; c < 8; ++c)
      for (int mode = 1; mode < modes_of_a_voxel; ++mode)
        for (int k = 0; k < 3; ++k) a.at[k][mode] += sign_of(mode, c) * u[static_cast<std::size_t>(3 * c + k)];
    const Amplitudes<double> work = work_of(m, a);
    double square = 0;
    for (int c = 0; c < 8; ++c) {
      const auto& inverse = inverses[static_cast<std::size_t>(c)];
      std::array<double, 3> force{};
      for (std::size_t k = 0; k < 3; ++k)
        for (int mode = 1; mode < modes_of_a_voxel; ++mode) force[k] += sign_of(mode, c) * work.at[k][mode];
      for (std::size_t k = 0; k < 3; ++k) {
        double& to = u[static_cast<std::size_t>(3 * c) + k];
        to = inverse[3 * k] * force[0] + inverse[3 * k + 1] * force[1] + inverse[3 * k + 2] * force[2];
        square += to * to;
      }
    }
    ratio = std::sqrt(square);
    for (double& v : u) v /= ratio;
  }
  return ratio;
}

}  // namespace

Modes modes_of(const Constants& constants, Element element) {
  const auto [e, nu] = constants;
  const double mu = e / (2 * (1 + nu)), lambda = e * nu / ((1 + nu) * (1 - 2 * nu));
  const bool wilson = element == Element::wilson;
  const double own = wilson ? 4 * mu * (lambda + mu) / (lambda + 2 * mu) / 3 : (lambda + 2 * mu) / 3;
  const double along = wilson ? own : own + mu / 3;
  return {(lambda + 2 * mu) / 16,    lambda / 16, mu / 16, along / 16, (own - 2 * mu / 3) / 16,
          (lambda + 4 * mu) / 9 / 16};
}

std::array<std::ptrdiff_t, 8> Voxels::corners() const {
  std::array<std::ptrdiff_t, 8> steps;
  for (std::ptrdiff_t c = 0; c < 8; ++c)
    steps[static_cast<std::size_t>(c)] = (c & 1) + (c >> 1 & 1) * grid.stride + (c >> 2) * grid.layer;
  return steps;
}

Voxels make_voxels(const VoxelMap& map, const Material& material, bool periodic) {
  arenite::check(map);
  check("matrix", material.matrix);
  check("interface", material.interface);
  check("particle", material.particle);
  Voxels voxels;
  voxels.width = map.width, voxels.height = map.height, voxels.depth = map.depth;
  const int more = periodic ? 0 : 1;
  voxels.grid = Grid(map.width + more, map.height + more, map.depth + more);
  voxels.grid.periodic = periodic;
  voxels.words = Buffer<std::uint32_t>(voxels.grid.padded_size());
  const Around around{map, periodic};
  for (int z = 0; z < map.depth; ++z)
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x) voxels.words[voxels.grid.index(x, y, z)] = around.kind_at(x, y, z);
  statics::close_period(voxels.grid, voxels.words.data());
  for (const auto& [kind, constants] :
       {std::pair{matrix, material.matrix}, {interface, material.interface}, {particle, material.particle}}) {
    const Modes exact = modes_of(constants, material.element);
    Modes& m = voxels.modes[kind];
    unsigned column = 0;
    for (double Modes::*mode :
         {&Modes::axial, &Modes::cross, &Modes::shear, &Modes::along, &Modes::across, &Modes::trilinear}) {
      voxels.table[column][kind] = static_cast<float>(exact.*mode);
      m.*mode = static_cast<double>(voxels.table[column++][kind]);
    }
  }
  return voxels;
}

std::array<std::array<double, 3>, 3> corner_block(const Modes& modes, int c, int d) {
  std::array<std::array<double, 3>, 3> block{};
  for (std::size_t b = 0; b < 3; ++b) {
    Amplitudes<double> a{};
    for (int m = 0; m < modes_of_a_voxel; ++m) a.at[b][m] = sign_of(m, d);
    const Amplitudes<double> work = work_of(modes, a);
    for (std::size_t e = 0; e < 3; ++e)
      for (int m = 1; m < modes_of_a_voxel; ++m) block[e][b] += sign_of(m, c) * work.at[e][m];
  }
  return block;
}

BlockDiagonal block_diagonal(const Voxels& voxels) {
  const Grid& grid = voxels.grid;
  BlockDiagonal sum(grid.padded_size());
  std::array<std::array<statics::BlockIn<3>, 8>, 4> of_kind{};
  for (const Kind kind : {matrix, interface, particle})
    for (std::size_t c = 0; c < 8; ++c) {
      const auto block = corner_block(voxels.modes[kind], static_cast<int>(c), static_cast<int>(c));
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b)
          of_kind[kind][c](a, b) = block[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }
  const auto steps = voxels.corners();
  grid.each([&](std::ptrdiff_t i, int) {
    statics::BlockIn<3> own;
    for (std::size_t c = 0; c < 8; ++c) {
      const auto& block = of_kind[voxels.kind(i - steps[c])][c];
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) own(a, b) += block(a, b);
    }
    sum.set(i, own);
  });
  return sum;
}

statics::Smoothing smoothing_of(const Voxels& voxels) {
  double highest = 0;
  for (const Kind kind : {matrix, interface, particle}) highest = std::max(highest, highest_ratio(voxels.modes[kind]));
  return {4, highest / 20, highest};
}

namespace {

/// The grain that most of the stiffness around a corner is of; -1 where all is void.
std::int32_t owner_of(const Voxels& voxels, const std::array<std::ptrdiff_t, 8>& steps,
                      const Buffer<std::int32_t>& of_voxel, std::ptrdiff_t i) {
  std::int32_t best = -1;
  double most = 0;
  for (const std::ptrdiff_t own_step : steps) {
    const std::ptrdiff_t own = i - own_step;
    if (voxels.kind(own) == none) continue;
    double weight = 0;
    for (const std::ptrdiff_t other_step : steps)
      if (const std::ptrdiff_t other = i - other_step; voxels.kind(other) != none && of_voxel[other] == of_voxel[own])
        weight += voxels.modes[voxels.kind(other)].axial;
    if (weight > most || (weight == most && of_voxel[own] < best)) most = weight, best = of_voxel[own];
  }
  return best;
}

}  // namespace

Aggregates cut_into_aggregates(const VoxelMap& map, const Voxels& voxels, const std::vector<std::uint8_t>& prescribed,
                               int side) {
  const Grid& grid = voxels.grid;
  const auto steps = voxels.corners();
  Buffer<std::int32_t> owner(grid.padded_size(), -1);
  {
    const auto of_map = statics::owners_in(map);
    Buffer<std::int32_t> of_voxel(grid.padded_size(), -1);
    for (int z = 0; z < map.depth; ++z)
      for (int y = 0; y < map.height; ++y)
        std::copy_n(of_map.begin() + static_cast<std::ptrdiff_t>(map.index(0, y, z)), map.width,
                    of_voxel.begin() + grid.index(0, y, z));
    statics::close_period(grid, of_voxel.data());
    grid.each([&](std::ptrdiff_t i, int level) {
      if (prescribed[static_cast<std::size_t>(level)] != statics::all_prescribed)
        owner[i] = owner_of(voxels, steps, of_voxel, i);
    });
  }
  return statics::cut_by_owner(
      grid, owner,
      [&](const statics::Cell& cell, JoinedSets& sets) {
        // A voxel joins those of its corners that lie in the cell: it may reach over the cell's border on every side.
        for (int z = -1; z < cell.deep; ++z)
          for (int y = -1; y < cell.high; ++y)
            for (int x = -1; x < cell.wide; ++x) {
              const std::ptrdiff_t i = grid.index(cell.x0 + x, cell.y0 + y, cell.z0 + z);
              if (voxels.kind(i) == none) continue;
              std::array<int, 8> place;
              for (std::size_t c = 0; c < 8; ++c) {
                const int right = x + static_cast<int>(c & 1), back = y + static_cast<int>(c >> 1 & 1),
                          up = z + static_cast<int>(c >> 2);
                const bool inside = right >= 0 && right < cell.wide && back >= 0 && back < cell.high && up >= 0 &&
                                    up < cell.deep && owner[i + steps[c]] >= 0;
                place[c] = inside ? (up * side + back) * side + right : -1;
                if (place[c] < 0) continue;
                for (std::size_t b = 0; b < c; ++b)
                  if (place[b] >= 0 && owner[i + steps[b]] == owner[i + steps[c]]) {
                    sets.join(place[b], place[c]);
                    break;
                  }
              }
            }
      },
      side);
}

VoxelStress voxel_stress(const VoxelMap& map, const Voxels& voxels, const Field<double>& u,
                         const std::array<double, 6>& strain) {
  VoxelStress field;
  field.width = map.width, field.height = map.height, field.depth = map.depth;
  field.dx = map.dx;
  for (auto* values :
       {&field.ux, &field.uy, &field.uz, &field.xx, &field.yy, &field.zz, &field.yz, &field.xz, &field.xy})
    values->assign(map.size(), 0.0f);
  std::size_t k = 0;
  for (int z = 0; z < map.depth; ++z)
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x, ++k) {
        const Kind kind = voxels.kind(voxels.grid.index(x, y, z));
        if (kind == none) continue;
        Vec3 sum, gx, gy, gz;
        for (int c = 0; c < 8; ++c) {
          const Vec3 at = u.at(voxels.node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)));
          sum += at;
          gx += sign_of(mode_x, c) * at;
          gy += sign_of(mode_y, c) * at;
          gz += sign_of(mode_z, c) * at;
        }
        const double h = 0.25 / map.dx;
        const double xx = h * gx.x + strain[voigt_xx], yy = h * gy.y + strain[voigt_yy],
                     zz = h * gz.z + strain[voigt_zz];
        const Modes& m = voxels.modes[kind];
        const auto stress = [](double pascal) { return static_cast<float>(16 * pascal); };
        field.ux[k] = static_cast<float>(sum.x / 8);
        field.uy[k] = static_cast<float>(sum.y / 8);
        field.uz[k] = static_cast<float>(sum.z / 8);
        field.xx[k] = stress(m.axial * xx + m.cross * (yy + zz));
        field.yy[k] = stress(m.axial * yy + m.cross * (zz + xx));
        field.zz[k] = stress(m.axial * zz + m.cross * (xx + yy));
        field.yz[k] = stress(m.shear * (h * (gz.y + gy.z) + strain[voigt_yz]));
        field.xz[k] = stress(m.shear * (h * (gz.x + gx.z) + strain[voigt_xz]));
        field.xy[k] = stress(m.shear * (h * (gy.x + gx.y) + strain[voigt_xy]));
      }
  return field;
}

}  // namespace arenite::voxels
