#include "grains/texture/stress.hpp"

#include "grains/texture/distribution.hpp"
#include "grains/texture/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace arenite::texture {
namespace {

/// f (x) l of one contact.
Tensor2 moment_of(const Contacts& contacts, std::size_t c) { return outer(contacts.force_on_i(c), contacts.branch(c)); }

/// f (x) l of one bond.
Tensor2 moment_of(const Packing& packing, const Bond& bond) {
  return outer(force_on_i(packing, bond), -branch_of(packing, bond));
}

/// f (x) l of a pull across a gap; 0 where it is in the force of a contact.
Tensor2 moment_of(const Packing& packing, const CohesivePair& pair) {
  return acts_across_gap(pair) ? outer(force_on_i(packing, pair), -branch_of(packing, pair)) : Tensor2{};
}

/// Calls `see` for each bond and each cohesive pair.
template <class See> void each_link(const Packing& packing, const See& see) {
  for (const Bond& bond : packing.bonds) see(bond);
  for (const CohesivePair& pair : packing.cohesive) see(pair);
}

/// Sum over contacts, walls included, and over bonds and cohesive pairs that are apart, of f (x) l over the volume of
/// the box (T eq. 1.10), with f on grain i and l from i to j (or to the wall).
Tensor2 whole_stress(const View& view) {
  Tensor2 sum, links;
  for (std::size_t c = 0; c < view.pairs().size(); ++c) sum += moment_of(view.pairs(), c);
  each_link(view.packing, [&](const auto& link) { links += moment_of(view.packing, link); });
  sum += links;
  const Domain& domain = view.packing.domain;
  return 1 / (domain.area() * domain.thickness) * sum;
}

/// Grains bring their moment in proportion to the area that lies in the window.
Tensor2 inner_stress(const View& view, const std::vector<Tensor2>& moments) {
  const Grains& grains = view.packing.grains;
  const double volume = view.blocks.bounds.area() * view.packing.domain.thickness;
  Tensor2 sum;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double r = grains.radius[g],
                 covered = covered_area(view.packing.domain, grains.position[g], r, view.blocks.bounds);
    sum += covered / (std::numbers::pi * r * r) / volume * moments[g];
  }
  return sum;
}

/// At rest forces balance, so that every cut through a sample bears the same: blocks cannot tell how the stress of
/// another sample would differ.
statistics::TensorEstimate with_scatter_in_time(const View& view, const Tensor2& stress) {
  return {stress, view.options.in_time ? view.options.in_time->stress : Tensor2{unknown, unknown, unknown, unknown}};
}

/// What the internal moment must be at rest by the forces on walls and by weight: sum over wall contacts of f (x) x_c
/// plus sum over grains of m g (x) x.
Tensor2 wall_moment(const Packing& packing, Vec2 gravity) {
  const auto& contacts = packing.contacts;
  const Grains& grains = packing.grains;
  Tensor2 sum;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.is_wall(c)) sum += outer(contacts.force_on_i(c), grains.position[contacts.i[c]] + contacts.lever_i(c));
  if (gravity.x == 0 && gravity.y == 0) return sum;
  for (std::size_t g = 0; g < grains.size(); ++g) sum += mass_of(packing, g) * outer(gravity, grains.position[g]);
  return sum;
}

/// Trace and deviatoric parts of the moments of contacts, of all and of the strong ones.
struct StrongPart {
  std::array<double, 3> all{}, strong{};
  double of_pressure() const { return all[0] != 0 ? strong[0] / all[0] : unknown; }
};
StrongPart strong_part(const View& view, const Items& contacts) {
  const double threshold = mean_push(view.pairs(), contacts);
  StrongPart part;
  for (const std::size_t c : contacts) {
    const Tensor2 m = moment_of(view.pairs(), c);
    const double parts[3] = {trace(m), m.xx - m.yy, m.xy + m.yx};
    for (int k = 0; k < 3; ++k) {
      part.all[k] += parts[k];
      if (view.pairs().fn[c] > threshold) part.strong[k] += parts[k];
    }
  }
  return part;
}

/// Share of the mean stress and of the deviatoric stress (along its own direction) that strong contacts carry. The
/// deviator of some blocks may be nothing beside its scatter: the error of its share is that of what is strong less the
/// share of all, over the deviator of the whole sample.
void put_strong_shares(Numbers& to, const View& view) {
  if (view.contacts.empty()) return;
  const StrongPart whole = strong_part(view, view.contacts);
  const double deviator = std::hypot(whole.all[1], whole.all[2]);
  const auto along = [&](const std::array<double, 3>& part) {
    return (whole.all[1] * part[1] + whole.all[2] * part[2]) / deviator;
  };
  const double share = deviator > 0 ? along(whole.strong) / deviator : unknown;
  const auto r = jackknife(view.contacts, view.contact_block, [&](const Items& contacts) {
    const StrongPart part = strong_part(view, contacts);
    return std::vector<double>{part.of_pressure(), (along(part.strong) - share * along(part.all)) / part.all[0]};
  });
  put(to, "strong_share_of_pressure", r[0], "", "Fraction of the pressure carried by contacts above the mean force");
  put(to, "strong_share_of_deviator", Estimate{share, r[1].error * std::abs(whole.all[0]) / deviator}, "",
      "Fraction of the deviator carried by contacts above the mean force");
}

/// The stress of the whole sample by itself, and in `details` what else is known of it.
void put_whole_stress(Numbers& to, Numbers& details, const View& view) {
  const Domain& domain = view.packing.domain;
  const double volume = domain.area() * domain.thickness;
  const Tensor2 s = whole_stress(view);
  const std::vector<Tensor2> moments = grain_moments(view.packing);
  Tensor2 sum;
  for (const Tensor2& m : moments) sum += 1 / volume * m;
  const bool walled = !domain.is_cell() && std::ranges::any_of(view.pairs().j, is_wall);
  const double axis = 0.5 * std::atan2(-(s.xy + s.yx), -(s.xx - s.yy)) * 180 / std::numbers::pi;
  const std::string known = view.options.in_time ? "the scatter in time" : "unknown from one sample";
  put(to, "stress", with_scatter_in_time(view, s), "Pa",
      ("Mean stress of the sample, tension positive; its error is " + known).c_str(), Trait::by_forces);
  put(details, "in_window", statistics::TensorEstimate{inner_stress(view, moments)}, "Pa",
      ("Stress of the grains in the window, tension positive; its error is " + known).c_str(), Trait::detail);
  put(details, "sum_over_grains", sum, "Pa", "Stress as the sum over grains", Trait::detail);
  if (walled)
    put(details, "from_walls_and_weight", 1 / volume * wall_moment(view.packing, view.options.gravity), "Pa",
        "Stress from the forces on walls and from weight; the same in equilibrium", Trait::detail);
  put(details, "pressure_Pa", pressure(s), "Pa", "Pressure p, mean of the principal stresses, compression positive");
  put(details, "deviator_Pa", deviator(s), "Pa", "Deviator q, half the difference of the principal stresses");
  put_angle(details, "axis_of_compression_deg", axis < 0 ? axis + 180 : axis, half_turn,
            "Direction of greatest compression, from x");
}

/// What a laboratory could not measure is NaN, and no part of the mean.
void take_measured(const View& view, PerGrain& rows) {
  rows.sigma_hyd = view.options.grain_sigma_hyd;
  const double mean = mean_of_known(view.grains, rows.sigma_hyd);
  for (const double value : rows.sigma_hyd) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}

}  // namespace

std::vector<Tensor2> grain_moments(const Packing& packing) {
  const auto& contacts = packing.contacts;
  std::vector<Tensor2> moments(packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 f = contacts.force_on_i(c);
    moments[contacts.i[c]] += outer(f, contacts.lever_i(c));
    if (!contacts.is_wall(c)) moments[contacts.j[c]] += outer(-f, contacts.lever_j(c));
  }
  each_link(packing, [&](const auto& link) {
    const double ri = packing.grains.radius[link.i], rj = packing.grains.radius[link.j];
    const Tensor2 moment = moment_of(packing, link);
    moments[link.i] += ri / (ri + rj) * moment;
    moments[link.j] += rj / (ri + rj) * moment;
  });
  return moments;
}

double pressure(const Tensor2& s) { return -0.5 * trace(s); }

double deviator(const Tensor2& s) { return mohr_radius(s); }

/// By the internal moment of a grain.
Tensor2 stress_of(const Packing& packing, std::size_t grain, const Tensor2& moment) {
  const double r = packing.grains.radius[grain];
  return 1 / (std::numbers::pi * r * r * packing.domain.thickness) * moment;
}

std::vector<Tensor2> grain_stresses(const Packing& packing) {
  std::vector<Tensor2> stresses = grain_moments(packing);
  for (std::size_t g = 0; g < stresses.size(); ++g) stresses[g] = stress_of(packing, g, stresses[g]);
  return stresses;
}

void stress(const View& view, Texture& texture) {
  Numbers details = Numbers::tree();
  if (view.has_box && view.has_thickness) put_whole_stress(texture.numbers, details, view);
  put_strong_shares(details, view);
  if (!details.empty()) texture.numbers["stress_details"] = details.mark(Trait::by_forces);
}

/// Stress of every grain over its own volume (T eq. 1.11). The normalised stress needs no length, since it cancels.
void grain_stress(const View& view, Texture& texture) {
  if (!view.options.grain_sigma_hyd.empty()) return take_measured(view, texture.per_grain);
  const Grains& grains = view.packing.grains;
  const std::vector<Tensor2> moments = grain_moments(view.packing);
  PerGrain& rows = texture.per_grain;
  std::vector<double> per_length;  // sigma_hyd times the length, N/m
  double mean = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double area = std::numbers::pi * grains.radius[g] * grains.radius[g];
    per_length.push_back(0.5 * trace(moments[g]) / area);
    if (view.considered[g]) mean += per_length[g] / static_cast<double>(view.grains.size());
    if (!view.has_thickness) continue;
    const double length = view.packing.domain.thickness;
    rows.sigma.push_back(stress_of(view.packing, g, moments[g]));
    rows.sigma_hyd.push_back(per_length[g] / length);
  }
  for (const double value : per_length) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}

/// Hydrostatic stress over the mean of the considered grains: of all, of one material, of one zone (T eq. 3.2). Values
/// are kept relative to the mean of all, so that without a length only the mean in Pa is unknown. Grains whose stress
/// is not known are left out.
void sigma_norm(const View& view, Texture& texture) {
  const bool measured = !view.options.grain_sigma_hyd.empty();
  if ((view.contacts.empty() && !measured) || view.grains.empty()) return;
  double mean = unknown;  // Pa, tension positive
  if (view.has_thickness || measured) mean = mean_of_known(view.grains, texture.per_grain.sigma_hyd);
  constexpr DistributionNames names{"mean_Pa", "Pa", "P0", "Mean stress of the set's grains",
                                    "Fraction of grains above the set's own mean, P_0"};
  const std::vector<double>& value = texture.per_grain.sigma_norm;
  const Items all = known(view.grains, value);
  for (const auto& [name, set] : grains_by_type(view))
    if (const Items items = known(set, value); !items.empty())
      place_of(name, texture.numbers["sigma_norm"], "by_material")
          .update(distribution(items, all, view.grain_block, value, 1.0, names, mean, view.level()));
  if (!measured && texture.numbers.contains("sigma_norm")) texture.numbers["sigma_norm"].mark(Trait::by_forces);
}

}  // namespace arenite::texture
