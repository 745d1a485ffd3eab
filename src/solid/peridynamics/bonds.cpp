#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <variant>

#include "core/problems.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/padded_labels.hpp"

namespace arenite::peridynamics {
namespace {

using Lane = std::int32_t __attribute__((vector_size(16)));
constexpr int lane_nodes = 4;

Lane load(const void* p) {
  Lane v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

bool all_zero(Lane v) {
  std::uint64_t w[2];
  std::memcpy(w, &v, sizeof w);
  return (w[0] | w[1]) == 0;
}

/// What a bond passes on its way: the square of a node (twice the same), or the corner between two, of which one must
/// be solid.
struct Passage {
  Offset one, other;
};

/// Passages of every half bond, in its order; the line from node to node and no more.
const std::vector<Passage> passages[bonds_per_node] = {
    {},                                                           // (1, 0)
    {{{1, 0}, {1, 0}}},                                           // (2, 0)
    {{{1, 0}, {1, 0}}, {{2, 0}, {2, 0}}},                         // (3, 0)
    {},                                                           // (0, 1)
    {{{0, 1}, {0, 1}}},                                           // (0, 2)
    {{{0, 1}, {0, 1}}, {{0, 2}, {0, 2}}},                         // (0, 3)
    {{{1, 0}, {0, 1}}},                                           // (1, 1)
    {{{1, 0}, {0, 1}}, {{1, 1}, {1, 1}}, {{2, 1}, {1, 2}}},       // (2, 2)
    {{{-1, 0}, {0, 1}}},                                          // (-1, 1)
    {{{-1, 0}, {0, 1}}, {{-1, 1}, {-1, 1}}, {{-2, 1}, {-1, 2}}},  // (-2, 2)
    {{{1, 0}, {1, 0}}, {{1, 1}, {1, 1}}},                         // (2, 1)
    {{{-1, 0}, {-1, 0}}, {{-1, 1}, {-1, 1}}},                     // (-2, 1)
    {{{0, 1}, {0, 1}}, {{1, 1}, {1, 1}}},                         // (1, 2)
    {{{0, 1}, {0, 1}}, {{-1, 1}, {-1, 1}}},                       // (-1, 2)
};

/// All ones where half bond d from these nodes meets solid all the way.
Lane solid_all_the_way(const std::int32_t* labels, const Grid& grid, int d) {
  Lane solid = Lane{} == 0;
  for (const auto& [one, other] : passages[d])
    solid &= (load(labels + one.x + one.y * grid.stride) | load(labels + other.x + other.y * grid.stride)) != 0;
  return solid;
}

/// Force on the first node of every bond, N/m, handed to `visit(i, j, e, force)`.
template <class Visit> void each_exact_bond(const Bonds& bonds, double dx, const Field<double>& u, const Visit& visit) {
  std::visit(
      [&](const auto& law) {
        each_bond(bonds, [&](const Bond& b) {
          const Offset e = b.step();
          const double l = length(e) * dx;
          const Vec2 now = Vec2{e.x * dx, e.y * dx} + u.at(b.j) - u.at(b.i);
          const double lnow = norm(now);
          visit(b.i, b.j, e, (law.force(lnow - l, bonds.modulus(b.type) * dx) / (l * lnow)) * now);
        });
      },
      bonds.law);
}

/// Sums over the half bonds that start at a node, and those that end there, bond by bond in rows.
struct StressSums {
  Buffer<double> xx, yy, xy;
  explicit StressSums(std::size_t n) : xx(n), yy(n), xy(n) {}
};

void add_linear(const BondLaw auto& law, const Bonds& bonds, double dx, const Field<double>& u, StressSums& s) {
  const Grid& grid = bonds.grid;
  std::array<std::array<double, 4>, bonds_per_node> k{};
  for (unsigned d = 0; d < bonds_per_node; ++d)
    for (unsigned t = 1; t < 4; ++t) k[d][t] = bonds.modulus(t) / (2 * dx * std::pow(length(half_bonds[d]), 3));
  for (int y = 0; y < grid.height; ++y)
    for (int d = 0; d < bonds_per_node; ++d) {
      const Offset e = half_bonds[d];
      const double ex = e.x, ey = e.y;
      const std::ptrdiff_t step = bonds.step(d);
      const auto& modulus = k[d];
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
        const std::ptrdiff_t j = i + step;
        const double tension = law.force(ex * (u.x[j] - u.x[i]) + ey * (u.y[j] - u.y[i]), modulus[bonds.type(i, d)]);
        s.xx[i] += ex * ex * tension;
        s.xx[j] += ex * ex * tension;
        s.yy[i] += ey * ey * tension;
        s.yy[j] += ey * ey * tension;
        s.xy[i] += ex * ey * tension;
        s.xy[j] += ex * ey * tension;
      }
    }
}

void add_exact(const Bonds& bonds, double dx, const Field<double>& u, StressSums& s) {
  each_exact_bond(bonds, dx, u, [&](std::ptrdiff_t i, std::ptrdiff_t j, Offset e, Vec2 f) {
    const double h = 1 / (2 * dx);
    for (const std::ptrdiff_t n : {i, j}) {
      s.xx[n] += h * f.x * e.x;
      s.yy[n] += h * f.y * e.y;
      s.xy[n] += h * (f.x * e.y + f.y * e.x) / 2;
    }
  });
}

}  // namespace

void check_by_type(const char* parameter, const char* unit, double matrix, double interface, double particle) {
  for (const auto& [type, value] :
       {std::pair{"matrix", matrix}, std::pair{"interface", interface}, std::pair{"particle", particle}})
    if (!(value > 0) || !std::isfinite(value))
      throw refusal("the {} of {} bonds is {:g} {}; give a positive one", parameter, type, value, unit);
}

Bonds make_bonds(const PhaseMap& map, const Stiffness& stiffness, const BondLawChoice& law, bool stop_at_voids) {
  check(map);
  check_by_type("Young modulus", "Pa", stiffness.matrix, stiffness.interface, stiffness.particle);
  if (std::min(map.width, map.height) < 2 * horizon + 1)
    throw refusal(
        "a phase map of {} x {} nodes is narrower than the horizon of a node; give at least {} nodes in each direction",
        map.width, map.height, 2 * horizon + 1);
  Bonds bonds;
  bonds.law = law;
  bonds.grid = Grid(map.width, map.height);
  const Grid& grid = bonds.grid;
  bonds.scale = nominal_micromodulus * (stiffness.calibrated ? calibration_factor() : 1.0) * stiffness.matrix;
  bonds.relative = {0.0f, 1.0f, static_cast<float>(stiffness.interface / stiffness.matrix),
                    static_cast<float>(stiffness.particle / stiffness.matrix)};
  bonds.words = Buffer<std::uint32_t>(grid.padded_size());
  bonds.group = Buffer<std::uint8_t>(static_cast<std::size_t>(grid.groups) * static_cast<std::size_t>(grid.height));

  const auto labels = padded_labels(map, grid);
  constexpr std::int32_t matrix = matrix_bond, interface = interface_bond, particle = particle_bond;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; x += lane_nodes) {
      const std::ptrdiff_t i = grid.index(x, y);
      const Lane own = load(labels.data() + i), solid = own != 0;
      const Lane within = ((own == 1) & matrix) | ((own > 1) & particle);
      Lane word = own ^ own;
      for (int d = 0; d < bonds_per_node; ++d) {
        const Lane other = load(labels.data() + i + bonds.step(d));
        const Lane same = own == other;
        Lane type = (same & within) | (~same & solid & (other != 0) & interface);
        if (stop_at_voids) type &= solid_all_the_way(labels.data() + i, grid, d);
        word |= type << (2 * d);
      }
      std::memcpy(bonds.words.data() + i, &word, sizeof word);
    }
  classify_groups(bonds, 0, grid.height - 1);
  return bonds;
}

std::size_t bonds_across_voids(const PhaseMap& map) {
  const Bonds all = make_bonds(map, {}), stopped = make_bonds(map, {}, {}, true);
  std::size_t across = 0;
  for (std::size_t i = 0; i < all.words.size(); ++i) {
    const std::uint32_t missing = all.words[i] ^ stopped.words[i];
    across += static_cast<std::size_t>(std::popcount((missing | missing >> 1) & 0x55555555u));  // two bits a bond
  }
  return across;
}

void classify_groups(Bonds& bonds, int first, int last) {
  const Grid& grid = bonds.grid;
  for (int y = std::max(0, first); y <= std::min(grid.height - 1, last + horizon); ++y)
    for (int g = 0; g < grid.groups; ++g) {
      const std::ptrdiff_t begin = grid.row(y) + g * Grid::lanes;
      const auto t = static_cast<std::int32_t>(bonds.words[begin] & 3u);
      Lane any{}, differs{};
      for (std::ptrdiff_t i = begin; i < begin + Grid::lanes; i += lane_nodes) {
        const Lane word = load(bonds.words.data() + i);
        any |= word;
        for (int d = 0; d < bonds_per_node; ++d) {
          const Lane back = (load(bonds.words.data() + i - bonds.step(d)) >> (2 * d)) & 3;
          differs |= ((word >> (2 * d) & 3) - t) | (back - t);
          any |= back;
        }
      }
      std::uint8_t& group = bonds.group[static_cast<std::ptrdiff_t>(y) * grid.groups + g];
      group = Bonds::mixed;
      if (all_zero(any)) group = Bonds::empty;
      else if (all_zero(differs)) group = static_cast<std::uint8_t>(t);
    }
}

bool crosses(const Cut& cut, Vec2 a, Vec2 b) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(cut.from, cut.to, a) * side(cut.from, cut.to, b) < 0 && side(a, b, cut.from) * side(a, b, cut.to) <= 0;
}

void make_cuts(Bonds& bonds, const std::vector<Cut>& cuts) {
  if (cuts.empty()) return;
  each_bond(bonds, [&](const Bond& b) {
    const Vec2 from{static_cast<double>(b.x), static_cast<double>(b.y)},
        to{static_cast<double>(b.x + b.step().x), static_cast<double>(b.y + b.step().y)};
    if (std::any_of(cuts.begin(), cuts.end(), [&](const Cut& cut) { return crosses(cut, from, to); }))
      bonds.break_bond(b.i, b.d);
  });
  classify_groups(bonds, 0, bonds.grid.height - 1);
}

StressField node_stress(const Bonds& bonds, double dx, const Field<double>& u, bool exact_stretch) {
  const Grid& grid = bonds.grid;
  StressSums sums(grid.padded_size());
  if (exact_stretch) add_exact(bonds, dx, u, sums);
  else std::visit([&](const auto& law) { add_linear(law, bonds, dx, u, sums); }, bonds.law);
  StressField field;
  field.width = grid.width;
  field.height = grid.height;
  field.dx = dx;
  const auto compact = [&](const Buffer<double>& padded) {
    std::vector<double> values(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
    for (int y = 0; y < grid.height; ++y)
      std::copy_n(padded.data() + grid.row(y), grid.width,
                  values.begin() + static_cast<std::ptrdiff_t>(y) * grid.width);
    return values;
  };
  field.ux = compact(u.x);
  field.uy = compact(u.y);
  field.xx = compact(sums.xx);
  field.yy = compact(sums.yy);
  field.xy = compact(sums.xy);
  return field;
}

void exact_force(const Bonds& bonds, double dx, const Field<double>& u, Field<double>& f) {
  set_zero(f);
  each_exact_bond(bonds, dx, u, [&](std::ptrdiff_t i, std::ptrdiff_t j, Offset, Vec2 g) {
    f.set(i, f.at(i) + g);
    f.set(j, f.at(j) - g);
  });
}

}  // namespace arenite::peridynamics
