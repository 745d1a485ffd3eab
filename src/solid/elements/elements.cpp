#include "solid/elements/elements.hpp"

#include <algorithm>
#include <cmath>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "core/vec.hpp"

namespace arenite::elements {
namespace {

/// Corners of a pixel in the order (0,0), (1,0), (0,1), (1,1), from its lower left one on.
std::array<std::ptrdiff_t, 4> corners_of(const Grid& grid, std::ptrdiff_t i) {
  return {i, i + 1, i + grid.stride, i + grid.stride + 1};
}
/// What a corner's value counts in the amplitudes gx, gy and h.
constexpr double sign_x[4] = {-1, 1, -1, 1}, sign_y[4] = {-1, -1, 1, 1}, sign_h[4] = {1, -1, -1, 1};

void check(const char* kind, const Constants& c) {
  if (!(c.young > 0) || !std::isfinite(c.young))
    throw refusal("the Young modulus of {} elements is {:g} Pa; give a positive one", kind, c.young);
  if (!(c.poisson > -1 && c.poisson < 0.5))
    throw refusal("Poisson's ratio of {} elements is {:g}; give one above -1 and below 0.5", kind, c.poisson);
}

/// Kind of the pixel at (x, y), by its own phase and those around it.
Kind kind_at(const PhaseMap& map, int x, int y) {
  const std::size_t k = map.index(x, y);
  if (map.phase[k] == Phase::empty) return none;
  const bool in_grain = map.phase[k] == Phase::particle;
  for (int b = std::max(0, y - 1); b <= std::min(map.height - 1, y + 1); ++b)
    for (int a = std::max(0, x - 1); a <= std::min(map.width - 1, x + 1); ++a) {
      const std::size_t n = map.index(a, b);
      if (map.phase[n] == Phase::particle && (!in_grain || map.grain[n] != map.grain[k])) return interface;
    }
  return in_grain ? particle : matrix;
}

/// Stiffness of the corners c and d of an element against each other.
std::array<std::array<double, 2>, 2> corner_block(const Modes& m, int c, int d) {
  const double xx = sign_x[c] * sign_x[d], xy = sign_x[c] * sign_y[d], yx = sign_y[c] * sign_x[d],
               yy = sign_y[c] * sign_y[d], hh = m.bending * sign_h[c] * sign_h[d];
  return {{{m.axial * xx + m.shear * yy + hh, m.cross * xy + m.shear * yx},
           {m.cross * yx + m.shear * xy, m.axial * yy + m.shear * xx + hh}}};
}

/// The largest eigenvalue of D_e^-1 K_e of one kind, by the power method.
double highest_ratio(const Modes& m) {
  std::array<double, 8> u{};
  for (std::size_t k = 0; k < 8; ++k) u[k] = std::cos(2.0 * static_cast<double>(k) + 1);  // along no symmetry
  double ratio = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<double, 8> next{};
    for (int c = 0; c < 4; ++c) {
      double f[2] = {0, 0};
      for (int d = 0; d < 4; ++d) {
        const auto block = corner_block(m, c, d);
        for (std::size_t a = 0; a < 2; ++a)
          f[a] +=
              block[a][0] * u[static_cast<std::size_t>(2 * d)] + block[a][1] * u[static_cast<std::size_t>(2 * d + 1)];
      }
      const auto own = corner_block(m, c, c);
      const double det = own[0][0] * own[1][1] - own[0][1] * own[1][0];
      const auto at = static_cast<std::size_t>(2 * c);
      next[at] = (own[1][1] * f[0] - own[0][1] * f[1]) / det;
      next[at + 1] = (own[0][0] * f[1] - own[1][0] * f[0]) / det;
    }
    double square = 0;
    for (const double v : next) square += v * v;
    ratio = std::sqrt(square);
    for (std::size_t k = 0; k < 8; ++k) u[k] = next[k] / ratio;
  }
  return ratio;
}

}  // namespace

Modes modes_of(const Constants& constants, Element element, PlaneState plane) {
  const auto [e, nu] = constants;
  const double g = e / (2 * (1 + nu));
  const double c11 = plane == PlaneState::stress ? e / (1 - nu * nu) : e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  const double c12 = plane == PlaneState::stress ? nu * c11 : e * nu / ((1 + nu) * (1 - 2 * nu));
  const double bending = element == Element::wilson ? c11 - c12 * c12 / c11 : c11 + g;
  return {c11 / 4, c12 / 4, g / 4, bending / 12};
}

Elements make_elements(const PhaseMap& map, const Material& material) {
  arenite::check(map);
  check("matrix", material.matrix);
  check("interface", material.interface);
  check("particle", material.particle);
  Elements elements;
  elements.grid = Grid(map.width + 1, map.height + 1);
  elements.words = Buffer<std::uint32_t>(elements.grid.padded_size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) elements.words[elements.grid.index(x, y)] = kind_at(map, x, y);
  for (const auto& [kind, constants] :
       {std::pair{matrix, material.matrix}, {interface, material.interface}, {particle, material.particle}}) {
    const Modes exact = modes_of(constants, material.element, material.plane);
    Modes& m = elements.modes[kind];
    unsigned column = 0;
    for (double Modes::*mode : {&Modes::axial, &Modes::cross, &Modes::shear, &Modes::bending}) {
      elements.table[column][kind] = static_cast<float>(exact.*mode);
      m.*mode = static_cast<double>(elements.table[column++][kind]);
    }
  }
  return elements;
}

BlockDiagonal<double> block_diagonal(const Elements& elements) {
  const Grid& grid = elements.grid;
  BlockDiagonal<double> sum(grid.padded_size());
  for (int y = 0; y < elements.rows(); ++y)
    for (int x = 0; x < elements.columns(); ++x) {
      const std::ptrdiff_t i = grid.index(x, y);
      if (elements.kind(i) == none) continue;
      const auto corners = corners_of(grid, i);
      for (int c = 0; c < 4; ++c) {
        const auto block = corner_block(elements.modes[elements.kind(i)], c, c);
        const std::ptrdiff_t j = corners[static_cast<std::size_t>(c)];
        sum.set(j, {sum.xx[j] + block[0][0], sum.xy[j] + block[0][1], sum.yy[j] + block[1][1]});
      }
    }
  return sum;
}

statics::Smoothing smoothing_of(const Elements& elements) {
  double highest = 0;
  for (const Kind kind : {matrix, interface, particle})
    highest = std::max(highest, highest_ratio(elements.modes[kind]));
  return {6, highest / 40, highest};
}

namespace {

/// The grain that most of the stiffness around a corner is of; -1 where all is void.
std::int32_t owner_of(const Elements& elements, const Buffer<std::int32_t>& of_pixel, std::ptrdiff_t i) {
  const Grid& grid = elements.grid;
  std::int32_t best = -1;
  double most = 0;
  const std::array<std::ptrdiff_t, 4> around{i, i - 1, i - grid.stride, i - grid.stride - 1};
  for (const std::ptrdiff_t own : around) {
    if (elements.kind(own) == none) continue;
    double weight = 0;
    for (const std::ptrdiff_t other : around)
      if (elements.kind(other) != none && of_pixel[other] == of_pixel[own])
        weight += elements.modes[elements.kind(other)].axial;
    if (weight > most || (weight == most && of_pixel[own] < best)) most = weight, best = of_pixel[own];
  }
  return best;
}

}  // namespace

Aggregates cut_into_aggregates(const PhaseMap& map, const Elements& elements,
                               const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = elements.grid;
  const auto of_map = statics::owners_in(map);
  Buffer<std::int32_t> of_pixel(grid.padded_size(), -1), owner(grid.padded_size(), -1);
  for (int y = 0; y < map.height; ++y)
    std::copy_n(of_map.begin() + static_cast<std::ptrdiff_t>(map.index(0, y)), map.width,
                of_pixel.begin() + grid.index(0, y));
  grid.each([&](std::ptrdiff_t i, int y) {
    if (prescribed[y] != statics::both_prescribed) owner[i] = owner_of(elements, of_pixel, i);
  });
  return statics::cut_by_owner(grid, owner, [&](const statics::Cell& c, JoinedSets& sets) {
    // A pixel joins those of its corners that lie in the cell: it may reach over the cell's border on every side.
    for (int y = -1; y < c.high; ++y)
      for (int x = -1; x < c.wide; ++x) {
        const std::ptrdiff_t i = grid.index(c.x0 + x, c.y0 + y);
        if (elements.kind(i) == none) continue;
        const auto corners = corners_of(grid, i);
        const auto place = [&](unsigned k) {
          const int right = x + static_cast<int>(k & 1), up = y + static_cast<int>(k >> 1);
          const bool inside = right >= 0 && right < c.wide && up >= 0 && up < c.high && owner[corners[k]] >= 0;
          return inside ? up * Aggregates::cell + right : -1;
        };
        for (unsigned m = 0; m < 4; ++m)
          for (unsigned n = m + 1; n < 4; ++n)
            if (place(m) >= 0 && place(n) >= 0 && owner[corners[m]] == owner[corners[n]]) sets.join(place(m), place(n));
      }
  });
}

StressField pixel_stress(const PhaseMap& map, const Elements& elements, const Field<double>& u) {
  const Grid& grid = elements.grid;
  StressField field;
  field.width = map.width;
  field.height = map.height;
  field.dx = map.dx;
  for (auto* values : {&field.ux, &field.uy, &field.xx, &field.yy, &field.xy}) values->assign(map.size(), 0.0);
  std::size_t k = 0;
  for (int y = 0; y < field.height; ++y)
    for (int x = 0; x < field.width; ++x, ++k) {
      if (map.phase[k] == Phase::empty) continue;
      const std::ptrdiff_t i = grid.index(x, y);
      Vec2 sum, gx, gy;
      const auto corners = corners_of(grid, i);
      for (unsigned c = 0; c < 4; ++c) {
        const Vec2 at = u.at(corners[c]);
        sum += at;
        gx += sign_x[c] * at;
        gy += sign_y[c] * at;
      }
      field.ux[k] = sum.x / 4;
      field.uy[k] = sum.y / 4;
      const Modes& m = elements.modes[elements.kind(i)];
      field.xx[k] =
          2 / map.dx * (m.axial * gx.x + m.cross * gy.y);  // C e, with C four times the modes and e = g/(2 dx)
      field.yy[k] = 2 / map.dx * (m.cross * gx.x + m.axial * gy.y);
      field.xy[k] = 2 / map.dx * m.shear * (gy.x + gx.y);
    }
  return field;
}

}  // namespace arenite::elements
