#include "solid/peridynamics/moduli.hpp"

namespace arenite::peridynamics {

EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options) {
  EffectiveModuli m;
  bool going = true;
  const auto run = [&](std::size_t k, const PhaseMap& sample, Loading loading) {
    if (!going) return;
    LoadOptions o = options;
    o.loading = loading;
    if (loading == Loading::shear) o.lower = LowerEdge::fixed;
    if (options.watch)
      o.watch = [&, k](Progress p) {
        p.share = (static_cast<double>(k) + p.share) / 3;
        return options.watch(p);
      };
    m.reports[k] = load(sample, o).report;
    going = m.reports[k].ending != Ending::stopped;
  };
  run(0, transposed(map), Loading::tension);
  run(1, map, Loading::tension);
  run(2, map, Loading::shear);
  if (!going) return m;
  m.young_x = m.reports[0].modulus;
  m.poisson_xy = m.reports[0].poisson;
  m.young_y = m.reports[1].modulus;
  m.poisson_yx = m.reports[1].poisson;
  m.shear = m.reports[2].modulus;
  return m;
}

}  // namespace arenite::peridynamics
