#include <fmt/format.h>

#include <cmath>

#include "grains/texture/texture.hpp"

namespace arenite::texture {
namespace {

using statistics::curve;
using statistics::Declared;
using statistics::described;
using statistics::matrix;
using statistics::numbers;
using statistics::put;
using statistics::put_all;
using statistics::tree_of;

constexpr Declared<Fabric> fabric_numbers[] = {
    {"contacts", "", "Contacts of the set", &Fabric::contacts},
    {"a_c", "", "Contact anisotropy 2 (phi_1 - phi_2), T eq. 1.8; 0: contacts in all directions alike", &Fabric::a_c},
    {"theta_c_deg", "deg", "Direction of most contacts, from x", &Fabric::theta_c_deg},
    {"phi", "", "Fabric tensor <n (x) n>, T eq. 1.6", &Fabric::phi},
    {"a_c_signed", "", "a_c cos 2(theta_c - theta_load): positive along the load", &Fabric::a_c_signed},
    {"a_c_noise", "", "a_c that as many random directions give", &Fabric::noise},
    {"a_n", "", "Anisotropy of the mean normal force", &Fabric::a_n},
    {"theta_n_deg", "deg", "Direction of the largest normal forces, from x", &Fabric::theta_n_deg},
    {"a_t", "", "Anisotropy of the mean tangential force", &Fabric::a_t}};

constexpr Declared<Mode> mode_numbers[] = {{"amplitude", "", "|<exp(i m theta)>| of contact directions", &Mode::amplitude},
                                           {"phase_deg", "deg", "Direction of its maximum, in [0, 360/m)", &Mode::phase_deg},
                                           {"noise", "", "Amplitude that as many random directions give", &Mode::noise}};

constexpr Declared<Distribution> distribution_numbers[] = {
    {"fraction_above_mean_of_all", "", "Share of the set above the mean of all", &Distribution::fraction_above_mean_of_all},
    {"maximum", "", "Largest value over the mean", &Distribution::maximum}};

constexpr Declared<ExponentialTail> tail_numbers[] = {
    {"beta_line", "", "The same by a straight line through ln of the survival function", &ExponentialTail::line_beta},
    {"line_r2", "", "Share of that logarithm's variance that the line explains", &ExponentialTail::line_r2},
    {"tail_count", "", "Values above the mean", &ExponentialTail::count},
    {"log_likelihood_ratio", "", "ln L(exponential) - ln L(half-Gaussian)", &ExponentialTail::likelihood_ratio},
    {"p_value", "", "That the exponential's lead is chance (Vuong's test, one-sided)", &ExponentialTail::p_value}};

constexpr Declared<Distribution> relation_numbers[] = {
    {"k", "", "Height of the pdf at the mean, 1/k = 1/(1 - alpha) + 1/beta", &Distribution::k},
    {"beta2_over_product", "", "beta^2/((1 - alpha)(2 - alpha)); 1 where T eq. 1.5 holds", &Distribution::relation}};

constexpr Declared<Coordination> coordination_numbers[] = {
    {"rattlers", "", "Share of grains with fewer than two contacts that carry force", &Coordination::rattlers},
    {"unlike_contacts_twice", "", "2 (N_XX + N_XY)/N_X (T 4.3.1)", &Coordination::doubled},
    {"parts_of_z", "", "2 N_AB over all grains (T 5.3.1); the parts add up to z", &Coordination::parts},
    {"share_of_contacts", "", "N_AB over all contacts", &Coordination::share}};

constexpr Declared<Stress> stress_numbers[] = {
    {"in_window", "Pa", "Stress of the grains in the window, tension positive", &Stress::inner},
    {"sum_over_grains", "Pa", "Stress as the sum over grains", &Stress::grains},
    {"from_walls_and_weight", "Pa", "Stress from the forces on walls and from weight; the same in equilibrium", &Stress::walls},
    {"pressure_Pa", "Pa", "Mean of the principal stresses, compression positive", &Stress::pressure},
    {"deviator_Pa", "Pa", "Half the difference of the principal stresses", &Stress::deviator},
    {"axis_of_compression_deg", "deg", "Direction of greatest compression, from x", &Stress::axis_deg},
    {"strong_share_of_pressure", "", "Share of the pressure that contacts above the mean force carry", &Stress::strong_pressure_share},
    {"strong_share_of_deviator", "", "Share of the deviator that contacts above the mean force carry", &Stress::strong_deviator_share}};

constexpr Declared<Quality> quality_numbers[] = {
    {"doubled_rows", "", "Contacts that stood twice and were merged", &Quality::doubled_rows},
    {"negative_forces", "", "Contacts with negative normal force", &Quality::negative_forces},
    {"negative_share", "", "Share of contacts with negative normal force", &Quality::negative_share},
    {"median_imbalance", "", "Median |sum F| of grains with at least 3 contacts over the mean force", &Quality::median_imbalance},
    {"friction_ratio_max", "", "Largest |F_t|/F_n of contacts that push", &Quality::friction_ratio_max},
    {"sliding_share", "", "Share of contacts within 0.001 of the largest |F_t|/F_n", &Quality::sliding_share}};

constexpr Declared<LocalOrder> order_numbers[] = {
    {"psi6", "", "Mean |<exp(6 i theta)>| over a grain's contacts", &LocalOrder::psi6},
    {"triangular_share", "", "Share of grains with five or more like neighbours and psi_6 of these above 0.9", &LocalOrder::ordered}};

constexpr Declared<LongAxes> long_axes_numbers[] = {{"grains", "", "Grains with a long axis", &LongAxes::grains},
                                                    {"noise", "", "Order that as many random directions give", &LongAxes::noise},
                                                    {"order", "", "|<exp(2 i theta)>| of long axes; 0 at random, 1 all alike", &LongAxes::order},
                                                    {"direction_deg", "deg", "Direction of most long axes, from x", &LongAxes::direction_deg}};

/// The numbers of the set "all" with those of the others in a group.
template <class T, class Make> Numbers by_set(const ByName<T>& sets, const char* group, const Make& make) {
  Numbers j = Numbers::tree();
  for (const auto& [name, set] : sets)
    if (name == "all") j.update(make(set));
    else j[group][name] = make(set);
  return j;
}

Numbers fabric_set(const Fabric& f, bool curves) {
  Numbers j = tree_of(f, fabric_numbers);
  for (const Mode& mode : f.modes) put_all(j["modes"][std::to_string(mode.m)], mode, mode_numbers);
  if (curves) {
    j["sectors"] = numbers(f.sectors);
    j["sector_force_N"] = numbers(f.sector_force);
  }
  return j;
}

Numbers fabric(const Texture& t, bool curves) {
  Numbers j = by_set(t.fabric, "sets", [&](const Fabric& f) { return fabric_set(f, curves); });
  put(j, "load_axis_deg", t.load_axis_deg, "deg", "Direction of the load, from x, that signs refer to");
  if (curves && !t.threshold.threshold.empty())
    j["threshold"] = {{"force", numbers(t.threshold.threshold)},
                      {"a_c_below", numbers(t.threshold.below)},
                      {"noise_below", numbers(t.threshold.below_noise)},
                      {"a_c_above", numbers(t.threshold.above)},
                      {"noise_above", numbers(t.threshold.above_noise)}};
  return j;
}

/// What a kind of values calls its mean and the share above it.
struct Names {
  const char *mean, *unit, *share;
};
constexpr Names force_names{"mean_N", "N", "strong_share"}, stress_names{"mean_Pa", "Pa", "P0"};

Numbers distribution(const Distribution& d, const Names& names, bool curves) {
  Numbers j{{"count", described(d.count, "", "Values of the set")}};
  put(j, names.mean, d.mean, names.unit, "Mean of the set");
  put(j, names.share, d.fraction_above_mean, "", "Share above the set's own mean, P_0");
  put_all(j, d, distribution_numbers);
  put(j, "beta", d.tail.beta, "", "Decay of values above the mean, P ~ exp(-beta x), by maximum likelihood");
  put(j, "beta_error", d.tail.beta.error, "", "Standard error of beta");
  put_all(j, d.tail, tail_numbers);
  put(j, "alpha", d.weak.alpha, "", "Exponent of values below the mean, P ~ x^-alpha, by maximum likelihood");
  put_all(j, d, relation_numbers);
  if (curves) {
    j["pdf"] = curve(d.pdf);
    j["pdf_over_all"] = curve(d.pdf_over_all);
    j["cumulative"] = curve(d.cumulative);
  }
  return j;
}

Numbers distributions(const ByName<Distribution>& sets, const Names& names, const char* group, bool curves) {
  return by_set(sets, group, [&](const Distribution& d) { return distribution(d, names, curves); });
}

Numbers coordination(const Coordination& z) {
  Numbers j = Numbers::tree();
  for (const auto& [name, value] : z.mean)
    put(j, name == "all without rattlers" ? "without_rattlers" : name, value, "", "Mean number of contacts a grain, of the pair or set that the name says");
  put_all(j, z, coordination_numbers);
  j["histogram"] = numbers(z.histogram);
  return j;
}

void put_stress(Numbers& to, const Stress& s) {
  put(to, "stress", s.whole, "Pa", "Mean stress of the sample, tension positive");
  if (Numbers j = tree_of(s, stress_numbers); !j.empty()) to["stress_details"] = j;
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
  lines.put("fraction above the mean, " + what, d.fraction_above_mean);
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
  Numbers j{{"grains", described(t.grains, "", "Grains of the sample")},
            {"contacts", described(t.contacts, "", "Contacts between grains")},
            {"wall_contacts", described(t.wall_contacts, "", "Contacts with walls")}};
  j["considered"] = {{"grains", described(t.considered_grains, "", "Grains in the window that statistics are of")},
                     {"contacts", described(t.considered_contacts, "", "Contacts in that window")},
                     {"border_m", described(t.window.border, "m", "Strip left out along walls")}};
  j["mean_diameter_m"] = described(t.mean_diameter, "m", "Mean diameter of grains");
  put(j, "solid_fraction", t.solid_fraction, "", "Area of grains over area of the sample");
  j["coordination"] = coordination(t.coordination);
  if (!t.fabric.empty()) j["fabric"] = fabric(t, curves);
  put_stress(j, t.stress);
  if (!t.force.compressive.empty()) {
    j["force"] = distributions(t.force.compressive, force_names, "by_type", curves);
    put(j["force"], "tensile_share", t.force.tensile_share, "", "Share of contacts that pull");
    if (!t.force.tensile.empty()) {
      j["force"]["tensile"] = distributions(t.force.tensile, force_names, "by_type", curves);
      put(j["force"]["tensile"], "mean_over_compressive_mean", t.force.tensile_mean_ratio, "", "Mean pull over mean push");
    }
  }
  if (!t.sigma_norm.sets.empty()) j["sigma_norm"] = distributions(t.sigma_norm.sets, stress_names, "by_material", curves);
  j["local_order"] = tree_of(t.order, order_numbers);
  if (t.long_axes.grains > 0) j["long_axes"] = tree_of(t.long_axes, long_axes_numbers);
  if (!t.rev.mean.empty())
    j["rev"] = {
        {"area_share", numbers(t.rev.area_share)}, {"mean", numbers(t.rev.mean)}, {"deviation", numbers(t.rev.deviation)}, {"error", numbers(t.rev.error)}};
  j["quality"] = tree_of(t.quality, quality_numbers);
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
