#include "grains/dem/glue.hpp"

#include <algorithm>

#include "grains/dem/forces.hpp"
#include "grains/dem/measure.hpp"

namespace arenite::dem {
namespace {

template <int D, class N, class F> void end_opened(SampleIn<D>& s, const N& normal, const F& friction) {
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    if (!(s.list.strength[p] > 0)) continue;
    auto& glue = s.list.glue[p];
    if (slot_kinematics(s, p).overlap > 0) {
      glue = touching;
    } else if (glue == touching) {
      glue = never_touched;
      s.list.strength[p] = 0;
      s.glued_pairs.erase(std::lower_bound(s.glued_pairs.begin(), s.glued_pairs.end(), slot_key(s, p)));
      const double lost = friction.energy(s.laws.slip(Turning<D>{}, sliding_stiffness(s, normal, p, Kinematics<D>{})),
                                          s.list.memory[p]);
      s.tally.dissipated_breakage += lost;
      s.tally.dissipated_friction -= lost;
    }
  }
}

}  // namespace

template <int D> void end_opened_glue(SampleIn<D>& s) {
  if (s.glued_pairs.empty()) return;
  s.laws.visit([&](const auto& normal, const auto&, const auto& friction) { end_opened(s, normal, friction); });
}

template void end_opened_glue(SampleIn<2>&);
template void end_opened_glue(SampleIn<3>&);

template <int D> void set_glue(SampleIn<D>& s, bool on) {
  if (on == s.glue) return;
  book_change(s, &Energies::dissipated_breakage, adhesive_energy<D>, [&] {
    s.glue = on;
    glue_touching_pairs(s);
  });
  each_part(s, [&](auto& part) { part.break_step(s); });
}

template void set_glue(Sample&, bool);
template void set_glue(SampleIn<3>&, bool);

}  // namespace arenite::dem
