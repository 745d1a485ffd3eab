#include <fmt/format.h>

#include <cmath>

#include "statistics/estimate.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::texture {
namespace {

using statistics::Lines;
using statistics::stress_unit;
using statistics::with_error;

void put_fabric(Lines& lines, const std::string& name, const Fabric& f) {
  lines.put("a_c, theta_c (" + name + ")", fmt::format("{}, {} deg; random directions give {:.2g}", with_error(f.a_c), with_error(f.theta_c_deg), f.noise));
}

void put_distribution(Lines& lines, const std::string& what, const Distribution& d, const char* unit, double scale = 1) {
  lines.put("mean " + what, d.mean, unit, scale);
  lines.put("share above the mean, " + what, d.share_above);
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
  lines.put("median imbalance of grains", Estimate{t.quality.median_imbalance, unknown}, "of the mean force");
  lines.put("largest |F_t|/F_n", Estimate{t.quality.friction_ratio_max, unknown});
  for (const auto& note : t.notes) lines.note(note);
  return lines.text();
}

}  // namespace arenite::texture
