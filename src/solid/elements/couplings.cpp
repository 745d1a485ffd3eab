#include "solid/elements/couplings.hpp"

#include <array>

namespace arenite::elements {
namespace {

using statics::Coupling;
using statics::Hats;
using statics::hats_at;

/// The hats of one aggregate on the corners of one element: their amplitudes, for either component. In a row that
/// slides hats move nodes along x only.
struct Part {
  std::int32_t p;
  Hats gx_u{}, gy_u{}, h_u{}, gx_v{}, gy_v{}, h_v{};

  void add(const Hats& hats, unsigned corner, bool slides) {
    const double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1;
    gx_u += x * hats;
    gy_u += y * hats;
    h_u += x * y * hats;
    if (slides) return;
    gx_v += x * hats;
    gy_v += y * hats;
    h_v += x * y * hats;
  }
};

/// What two parts of an element add to the coupling of their aggregates.
void add(const Modes& m, const Part& p, const Part& q, Coupling& to) {
  for (unsigned a = 0; a < 4; ++a) {
    to.block[0][a] += (m.axial * p.gx_u[a]) * q.gx_u + (m.shear * p.gy_u[a]) * q.gy_u + (m.bending * p.h_u[a]) * q.h_u;
    to.block[1][a] += (m.cross * p.gx_u[a]) * q.gy_v + (m.shear * p.gy_u[a]) * q.gx_v;
    to.block[2][a] += (m.cross * p.gy_v[a]) * q.gx_u + (m.shear * p.gx_v[a]) * q.gy_u;
    to.block[3][a] += (m.axial * p.gy_v[a]) * q.gy_v + (m.shear * p.gx_v[a]) * q.gx_v + (m.bending * p.h_v[a]) * q.h_v;
  }
}

}  // namespace

std::vector<Coupling> couplings(const Elements& elements, const Aggregates& aggregates, const BlockDiagonal<double>&,
                                const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = elements.grid;
  statics::CouplingSum sum(aggregates.list.size());
  for (int y = 0; y < elements.rows(); ++y)
    for (int x = 0; x < elements.columns(); ++x) {
      const std::ptrdiff_t i = grid.index(x, y);
      if (elements.kind(i) == none) continue;
      std::array<Part, 4> parts;
      unsigned count = 0;
      for (unsigned c = 0; c < 4; ++c) {
        const int right = static_cast<int>(c & 1), up = static_cast<int>(c >> 1);
        const std::int32_t p = aggregates.of_node[i + right + up * grid.stride];
        if (p < 0) continue;
        unsigned at = 0;
        while (at < count && parts[at].p != p) ++at;
        if (at == count) parts[count++] = {p};
        parts[at].add(hats_at(x + right, y + up), c, prescribed[y + up] == statics::y_prescribed);
      }
      const Modes& m = elements.modes[elements.kind(i)];
      for (unsigned a = 0; a < count; ++a)
        for (unsigned b = a; b < count; ++b) {
          const bool swap = parts[b].p < parts[a].p;
          const Part &low = parts[swap ? b : a], &high = parts[swap ? a : b];
          add(m, low, high, low.p == high.p ? sum.self(low.p) : sum.between(low.p, high.p));
        }
    }
  return sum.taken();
}

}  // namespace arenite::elements
