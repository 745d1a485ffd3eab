#include <fmt/format.h>

#include <cmath>

#include "grains/texture/texture.hpp"

namespace arenite::texture {
namespace {

using statistics::curve;
using statistics::matrix;
using statistics::numbers;
using statistics::put;

/// The numbers of the set "all" with those of the others in a group.
template <class T, class Make> Numbers by_set(const ByName<T>& sets, const char* group, const Make& make) {
  Numbers j = Numbers::tree();
  for (const auto& [name, set] : sets)
    if (name == "all") j.update(make(set));
    else j[group][name] = make(set);
  return j;
}

Numbers fabric_set(const Fabric& f, bool curves) {
  Numbers j{{"contacts", f.contacts}};
  put(j, "a_c", f.a_c);
  put(j, "theta_c_deg", f.theta_c_deg);
  put(j, "phi", f.phi);
  put(j, "a_c_signed", f.a_c_signed);
  put(j, "a_c_noise", f.noise);
  put(j, "a_n", f.a_n);
  put(j, "theta_n_deg", f.theta_n_deg);
  put(j, "a_t", f.a_t);
  for (const Mode& mode : f.modes) {
    Numbers& m = j["modes"][std::to_string(mode.m)];
    put(m, "amplitude", mode.amplitude);
    put(m, "phase_deg", mode.phase_deg);
    put(m, "noise", mode.noise);
  }
  if (curves) {
    j["sectors"] = numbers(f.sectors);
    j["sector_force_N"] = numbers(f.sector_force);
  }
  return j;
}

Numbers fabric(const Texture& t, bool curves) {
  Numbers j = by_set(t.fabric, "sets", [&](const Fabric& f) { return fabric_set(f, curves); });
  put(j, "load_axis_deg", t.load_axis_deg);
  if (curves && !t.threshold.threshold.empty())
    j["threshold"] = {{"force", numbers(t.threshold.threshold)},
                      {"a_c_below", numbers(t.threshold.below)},
                      {"noise_below", numbers(t.threshold.below_noise)},
                      {"a_c_above", numbers(t.threshold.above)},
                      {"noise_above", numbers(t.threshold.above_noise)}};
  return j;
}

/// `mean` and `share` are what the set calls its mean and its share above the mean.
Numbers distribution(const Distribution& d, const char* mean, const char* share, bool curves) {
  Numbers j{{"count", d.count}};
  put(j, mean, d.mean);
  put(j, share, d.fraction_above_mean);
  put(j, "fraction_above_mean_of_all", d.fraction_above_mean_of_all);
  put(j, "maximum", d.maximum);
  put(j, "beta", d.tail.beta);
  put(j, "beta_error", d.tail.beta.error);
  put(j, "beta_line", d.tail.line_beta);
  put(j, "line_r2", d.tail.line_r2);
  put(j, "tail_count", static_cast<double>(d.tail.count));
  put(j, "log_likelihood_ratio", d.tail.likelihood_ratio);
  put(j, "p_value", d.tail.p_value);
  put(j, "alpha", d.weak.alpha);
  put(j, "k", d.k);
  put(j, "beta2_over_product", d.relation);
  if (curves) {
    j["pdf"] = curve(d.pdf);
    j["pdf_over_all"] = curve(d.pdf_over_all);
    j["cumulative"] = curve(d.cumulative);
  }
  return j;
}

Numbers distributions(const ByName<Distribution>& sets, const char* mean, const char* share, const char* group, bool curves) {
  return by_set(sets, group, [&](const Distribution& d) { return distribution(d, mean, share, curves); });
}

Numbers coordination(const Coordination& z) {
  Numbers j = Numbers::tree();
  for (const auto& [name, value] : z.mean) put(j, name == "all without rattlers" ? "without_rattlers" : name, value);
  put(j, "rattlers", z.rattlers);
  put(j, "unlike_contacts_twice", z.doubled);
  put(j, "parts_of_z", z.parts);
  put(j, "share_of_contacts", z.share);
  j["histogram"] = numbers(z.histogram);
  return j;
}

void put_stress(Numbers& to, const Stress& s) {
  put(to, "stress", s.whole);
  Numbers j = Numbers::tree();
  put(j, "in_window", s.inner);
  put(j, "sum_over_grains", s.grains);
  put(j, "from_walls_and_weight", s.walls);
  put(j, "pressure_Pa", s.pressure);
  put(j, "deviator_Pa", s.deviator);
  put(j, "axis_of_compression_deg", s.axis_deg);
  put(j, "strong_share_of_pressure", s.strong_pressure_share);
  put(j, "strong_share_of_deviator", s.strong_deviator_share);
  if (!j.empty()) to["stress_details"] = j;
}

Numbers quality(const Quality& q) {
  Numbers j{{"doubled_rows", q.doubled_rows}, {"negative_forces", q.negative_forces}, {"negative_share", q.negative_share}};
  put(j, "median_imbalance", q.median_imbalance);
  put(j, "friction_ratio_max", q.friction_ratio_max);
  put(j, "sliding_share", q.sliding_share);
  return j;
}

Numbers rows(const PerGrain& g) {
  Numbers j{{"considered", g.considered}, {"rattler", g.rattler}, {"contacts", g.contacts}, {"sigma_norm", numbers(g.sigma_norm)}, {"psi6", numbers(g.psi6)}};
  if (!g.sigma_hyd.empty()) j["sigma_hyd_Pa"] = numbers(g.sigma_hyd);
  for (const Tensor2& t : g.sigma) j["sigma_Pa"].push_back(matrix(t));
  return j;
}

using statistics::Lines;
using statistics::stress_unit;
using statistics::with_error;

void put_fabric(Lines& lines, const std::string& name, const Fabric& f) {
  lines.put("a_c, theta_c (" + name + ")", fmt::format("{}, {} deg; random directions give {:.2g}", with_error(f.a_c), with_error(f.theta_c_deg), f.noise));
}

void put_distribution(Lines& lines, const std::string& what, const Distribution& d, const char* unit, double scale = 1) {
  lines.put("mean " + what, d.mean, unit, scale);
  lines.put("share above the mean, " + what, d.fraction_above_mean);
  lines.put("beta of the strong tail, " + what, d.tail.beta);
}

/// Whether a set says anything that "all" does not: the only material of a sample does not, nor do the strong and weak contacts of one type, which
/// are left to the JSON.
bool adds_to_all(const std::string& name, std::size_t count, std::size_t all) {
  return name == "all" || (count != all && !name.ends_with(" strong") && !name.ends_with(" weak"));
}

void put_stress(Lines& lines, const Stress& s) {
  if (!std::isfinite(s.whole.value.xx)) return;
  const auto [unit, scale] = stress_unit(std::abs(s.pressure) + s.deviator);
  const auto& v = s.whole.value;
  const auto& e = s.whole.error;
  lines.put("stress xx, yy (tension positive)", with_error({v.xx, e.xx}, scale) + ", " + with_error({v.yy, e.yy}, scale) + " " + unit);
  lines.put("stress xy, yx", with_error({v.xy, e.xy}, scale) + ", " + with_error({v.yx, e.yx}, scale) + " " + unit);
  lines.put("pressure, deviator, axis", fmt::format("{:.4g}, {:.4g} {}, {:.3g} deg", s.pressure * scale + 0.0, s.deviator * scale, unit, s.axis_deg));
}

}  // namespace

Numbers numbers(const Texture& t, bool curves) {
  Numbers j{{"grains", t.grains}, {"contacts", t.contacts}, {"wall_contacts", t.wall_contacts}};
  j["considered"] = {{"grains", t.considered_grains}, {"contacts", t.considered_contacts}, {"border_m", t.window.border}};
  j["mean_diameter_m"] = t.mean_diameter;
  put(j, "solid_fraction", t.solid_fraction);
  j["coordination"] = coordination(t.coordination);
  if (!t.fabric.empty()) j["fabric"] = fabric(t, curves);
  put_stress(j, t.stress);
  if (!t.force.compressive.empty()) {
    j["force"] = distributions(t.force.compressive, "mean_N", "strong_share", "by_type", curves);
    put(j["force"], "tensile_share", t.force.tensile_share);
    if (!t.force.tensile.empty()) {
      j["force"]["tensile"] = distributions(t.force.tensile, "mean_N", "strong_share", "by_type", curves);
      put(j["force"]["tensile"], "mean_over_compressive_mean", t.force.tensile_mean_ratio);
    }
  }
  if (!t.sigma_norm.sets.empty()) j["sigma_norm"] = distributions(t.sigma_norm.sets, "mean_Pa", "P0", "by_material", curves);
  j["local_order"] = Numbers::tree();
  put(j["local_order"], "psi6", t.order.psi6);
  put(j["local_order"], "triangular_share", t.order.ordered);
  if (t.long_axes.grains > 0) {
    j["long_axes"] = {{"grains", t.long_axes.grains}, {"noise", t.long_axes.noise}};
    put(j["long_axes"], "order", t.long_axes.order);
    put(j["long_axes"], "direction_deg", t.long_axes.direction_deg);
  }
  if (!t.rev.mean.empty())
    j["rev"] = {
        {"area_share", numbers(t.rev.area_share)}, {"mean", numbers(t.rev.mean)}, {"deviation", numbers(t.rev.deviation)}, {"error", numbers(t.rev.error)}};
  j["quality"] = quality(t.quality);
  j["notes"] = t.notes;
  if (curves) j["by_grain"] = rows(t.per_grain);
  return j;
}

std::string to_text(const Texture& t) {
  Lines lines;
  lines.put("grains, contacts, wall contacts", fmt::format("{}, {}, {}", t.grains, t.contacts, t.wall_contacts));
  lines.put("considered grains, contacts", fmt::format("{}, {}", t.considered_grains, t.considered_contacts));
  lines.put("solid fraction", t.solid_fraction);
  const bool one_material = t.coordination.doubled.size() < 2;  // then the pairs only repeat "all"
  for (const auto& [name, z] : t.coordination.mean)
    if (!one_material || name.starts_with("all")) lines.put("coordination, " + name, z);
  lines.put("rattlers", t.coordination.rattlers);
  for (const auto& [name, fabric] : t.fabric)
    if (name == "strong" || name == "weak" || adds_to_all(name, fabric.contacts, t.considered_contacts)) put_fabric(lines, name, fabric);
  for (const auto& [name, forces] : t.force.compressive)
    if (adds_to_all(name, forces.count, t.force.compressive.front().second.count))
      put_distribution(lines, name == "all" ? "force" : "force " + name, forces, "N");
  put_stress(lines, t.stress);
  if (std::isfinite(t.stress.strong_pressure_share.value))
    lines.put("strong contacts' share of p, q", with_error(t.stress.strong_pressure_share) + ", " + with_error(t.stress.strong_deviator_share));
  for (const auto& [name, stress] : t.sigma_norm.sets)
    if (adds_to_all(name, stress.count, t.considered_grains)) {
      const auto [unit, scale] = stress_unit(std::abs(stress.mean.value));
      put_distribution(lines, name == "all" ? "sigma_hyd" : "sigma_hyd " + name, stress, unit, scale);
    }
  lines.put("psi_6", t.order.psi6);
  if (const LongAxes& a = t.long_axes; a.grains > 0)
    lines.put("order of long axes, direction",
              fmt::format("{}, {} deg; random directions give {:.2g}", with_error(a.order), with_error(a.direction_deg), a.noise));
  lines.put("median imbalance of grains", Estimate{t.quality.median_imbalance, unknown}, "of the mean force");
  lines.put("largest |F_t|/F_n", Estimate{t.quality.friction_ratio_max, unknown});
  for (const auto& note : t.notes) lines.note(note);
  return lines.text();
}

}  // namespace arenite::texture
