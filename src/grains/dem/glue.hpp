#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Grains a and b (caller's indices) were declared glued: by name, or by their zones where no pair is named.
template <int D> bool is_marked_as_glued(const SampleIn<D>& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[a] > 0 && zone[b] > 0;
  a = grain_of(s, a), b = grain_of(s, b);
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

/// Glued grains part for good.
template <int D> bool glue_breaks(const SampleIn<D>& s) {
  return s.contact.adhesion.visit([](const auto& law) { return law.breaks; });
}

/// Whether grains a and b (caller's indices) attract each other.
template <int D> bool is_glued(const SampleIn<D>& s, std::int32_t a, std::int32_t b) {
  if (!s.glue || !s.contact.adheres()) return false;
  return glue_breaks(s) ? std::binary_search(s.glued_pairs.begin(), s.glued_pairs.end(), pair_key(a, b))
                        : is_marked_as_glued(s, a, b);
}

/// What the laws need of two disks.
template <int D>
Coefficients pair_coefficients(const SampleIn<D>& s, const GrainRecord<D>& a, const GrainRecord<D>& b) {
  return s.coefficients.pair(a, b, is_glued(s, a.grain, b.grain));
}

/// Decides anew which listed pairs attract, after glue was switched on or off. Where glue breaks for good, the
/// marked pairs that touch now (to a millionth of their radii) are the glued ones there are.
template <int D> void glue_touching_pairs(SampleIn<D>& s) {
  s.glued_pairs.clear();
  if (s.glue && glue_breaks(s)) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const auto &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const auto d = a.place - b.place;
      if (dot(d, d) < reach * reach && is_marked_as_glued(s, a.grain, b.grain)) s.glued_pairs.push_back(slot_key(s, p));
    }
    std::sort(s.glued_pairs.begin(), s.glued_pairs.end());
  }
  for (std::size_t p = 0; p < s.list.pairs; ++p)
    s.list.strength[p] = pair_coefficients(s, s.record[s.list.i[p]], s.record[s.list.j[p]]).strength;
}

/// Ends the glue that breaks for good where its contact has opened; the energy of the tangential spring is lost.
template <int D> void end_opened_glue(SampleIn<D>& sample);

/// Adhesion acts, or does not; of glue that breaks for good: pairs that touch now are glued.
template <int D> void set_glue(SampleIn<D>& sample, bool on);

}  // namespace arenite::dem
