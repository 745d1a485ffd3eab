#include "grains/texture/stress.hpp"

#include <cmath>
#include <numbers>

#include "grains/texture/statistics.hpp"

namespace arenite::texture {
namespace {

/// f (x) l of one contact.
Tensor2 moment_of(const Contacts& contacts, std::size_t c) {
  return outer(contacts.force_on_i(c), -(contacts.arm_i[c] + contacts.arm_j[c]) * contacts.normal(c));
}

/// Standard error, component by component, of the mean of equal blocks.
Tensor2 block_error(const std::vector<Tensor2>& density) {
  const auto component = [&](double Tensor2::*part) {
    std::vector<double> values;
    for (const Tensor2& d : density) values.push_back(d.*part);
    return standard_error(values);
  };
  return {component(&Tensor2::xx), component(&Tensor2::xy), component(&Tensor2::yx), component(&Tensor2::yy)};
}

TensorEstimate whole_stress(const View& view) {
  const Domain& domain = view.packing.domain;
  const BlockGrid blocks{box_of(domain), std::max(2, view.blocks.per_side)};
  const double volume = domain.area() * domain.thickness;
  std::vector<Tensor2> density(static_cast<std::size_t>(blocks.count()));
  for (std::size_t c = 0; c < view.pairs().size(); ++c)
    density[static_cast<std::size_t>(blocks.block_of(view.contact_point(c)))] += blocks.count() / volume * moment_of(view.pairs(), c);
  return {1 / volume * internal_moment(view.pairs()), block_error(density)};
}

/// Grains bring their moment in proportion to the area that lies in the window.
TensorEstimate inner_stress(const View& view, const std::vector<Tensor2>& moments) {
  const Domain& domain = view.packing.domain;
  const Grains& grains = view.packing.grains;
  const BlockGrid blocks{view.blocks.bounds, std::max(2, view.blocks.per_side)};
  const double volume = blocks.bounds.area() * domain.thickness / blocks.count();
  std::vector<Tensor2> density(static_cast<std::size_t>(blocks.count()));
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double r = grains.radius[g], disk = std::numbers::pi * r * r;
    for (int b = 0; b < blocks.count(); ++b)
      if (const double area = covered_area(domain, grains.centre(g), r, blocks.block(b)); area > 0)
        density[static_cast<std::size_t>(b)] += area / disk / volume * moments[g];
  }
  Tensor2 mean;
  for (const Tensor2& d : density) mean += 1.0 / blocks.count() * d;
  return {mean, block_error(density)};
}

/// Share of the mean stress and of the deviatoric stress (along its own direction) that strong contacts carry.
void split_by_strength(const View& view, Stress& stress) {
  if (view.contacts.empty()) return;
  const auto add = [&](std::size_t c, double* sums) {
    const Tensor2 m = moment_of(view.pairs(), c);
    const double parts[3] = {trace(m), m.xx - m.yy, m.xy + m.yx};
    for (int k = 0; k < 3; ++k) {
      sums[k] += parts[k];
      if (view.strong(c)) sums[3 + k] += parts[k];
    }
  };
  const auto shares = [](const std::vector<double>& s) {
    const double deviator2 = s[1] * s[1] + s[2] * s[2];
    return std::vector<double>{s[0] != 0 ? s[3] / s[0] : unknown, deviator2 > 0 ? (s[1] * s[4] + s[2] * s[5]) / deviator2 : unknown};
  };
  const auto r = jackknife_of_sums(view.contacts, view.contact_block, 6, add, shares);
  stress.strong_pressure_share = r[0];
  stress.strong_deviator_share = r[1];
}

}  // namespace

Tensor2 internal_moment(const Contacts& contacts) {
  Tensor2 sum;
  for (std::size_t c = 0; c < contacts.size(); ++c) sum += moment_of(contacts, c);
  return sum;
}

std::vector<Tensor2> grain_moments(const Packing& packing) {
  const auto& contacts = packing.contacts;
  std::vector<Tensor2> moments(packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 f = contacts.force_on_i(c), n = contacts.normal(c);
    moments[static_cast<std::size_t>(contacts.i[c])] += outer(f, -contacts.arm_i[c] * n);
    if (!contacts.is_wall(c)) moments[static_cast<std::size_t>(contacts.j[c])] += outer(-f, contacts.arm_j[c] * n);
  }
  return moments;
}

double mass_of(const Packing& packing, std::size_t g) {
  const double r = packing.grains.radius[g];
  const double density = packing.materials.at(static_cast<std::size_t>(packing.grains.material[g])).density;
  return density * std::numbers::pi * r * r * packing.domain.thickness;
}

Tensor2 wall_moment(const Packing& packing, Vec2 gravity) {
  const auto& contacts = packing.contacts;
  const Grains& grains = packing.grains;
  Tensor2 sum;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.is_wall(c))
      sum += outer(contacts.force_on_i(c), grains.centre(static_cast<std::size_t>(contacts.i[c])) - contacts.arm_i[c] * contacts.normal(c));
  if (gravity.x == 0 && gravity.y == 0) return sum;
  for (std::size_t g = 0; g < grains.size(); ++g) sum += mass_of(packing, g) * outer(gravity, grains.centre(g));
  return sum;
}

void measure_stress(const View& view, Texture& texture) {
  Stress& stress = texture.stress;
  split_by_strength(view, stress);
  if (!view.has_box || !view.has_thickness) return;
  const Domain& domain = view.packing.domain;
  const double volume = domain.area() * domain.thickness;
  stress.whole = whole_stress(view);
  const std::vector<Tensor2> moments = grain_moments(view.packing);
  stress.inner = inner_stress(view, moments);
  stress.grains = {};
  for (const Tensor2& m : moments) stress.grains += 1 / volume * m;
  if (!domain.periodic_x && !domain.periodic_y && texture.wall_contacts > 0)
    stress.walls = 1 / volume * wall_moment(view.packing, view.options.gravity);
  const Tensor2& s = stress.whole.value;
  const double difference = s.xx - s.yy, shear = s.xy + s.yx;
  stress.pressure = -0.5 * trace(s);
  stress.deviator = 0.5 * std::hypot(difference, shear);
  const double axis = 0.5 * std::atan2(-shear, -difference) * 180 / std::numbers::pi;
  stress.axis_deg = axis < 0 ? axis + 180 : axis;
}

}  // namespace arenite::texture
