#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "grains/texture/spheres/tensor3.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/view.hpp"
#include "model/joints.hpp"

namespace arenite::texture {
namespace {

using spheres::rows_of;
Numbers rows_of(const Tensor2& tensor) { return tensor; }

/// f (x) l of one contact.
template <int D> Tensor<D> moment_of(const ContactsIn<D>& contacts, std::size_t c) {
  return outer(contacts.force_on_i(c), contacts.branch(c));
}

/// Sum over contacts, walls included, and over bonds and cohesive pairs that are apart, of f (x) l over the volume of
/// the box (T eq. 1.10), with f on grain i and l from i to j (or to the wall).
template <int D> Tensor<D> whole_stress(const PackingIn<D>& packing) {
  Tensor<D> sum, links;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c) sum += moment_of(packing.contacts, c);
  for_each_joint(packing,
                 [&](std::size_t, std::size_t, Vec<D> force, Vec<D> branch) { links += outer(force, -branch); });
  sum += links;
  return 1 / volume_of(packing.domain) * sum;
}

/// Grains bring their moment in proportion to the area that lies in the window.
Tensor2 inner_stress(const View& view, const std::vector<Tensor2>& moments) {
  const Grains& grains = view.packing.grains;
  const double volume = view.blocks.bounds.area() * view.packing.domain.thickness;
  Tensor2 sum;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double r = grains.radius[g],
                 covered = covered_by<2>(view.packing.domain, grains.position[g], r, view.blocks.bounds);
    sum += covered / (std::numbers::pi * r * r) / volume * moments[g];
  }
  return sum;
}

/// At rest forces balance, so that every cut through a sample bears the same: blocks cannot tell how the stress of
/// another sample would differ.
template <int D> Numbers with_scatter_in_time(const ViewIn<D>& view, const Tensor<D>& stress) {
  const Numbers value = rows_of(stress);
  if (!value.is_known()) return value;
  return {{"value", value}, {"error", view.options.in_time ? rows_of(view.options.in_time->stress) : Numbers()}};
}

/// What the internal moment must be at rest by the forces on walls and by weight: sum over wall contacts of f (x) x_c
/// plus sum over grains of m g (x) x.
template <int D> Tensor<D> wall_moment(const PackingIn<D>& packing, Vec<D> gravity) {
  const auto& contacts = packing.contacts;
  const GrainsIn<D>& grains = packing.grains;
  Tensor<D> sum;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.is_wall(c)) sum += outer(contacts.force_on_i(c), grains.position[contacts.i[c]] + contacts.lever_i(c));
  if (gravity == Vec<D>{}) return sum;
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

void put_strong_shares(Numbers& /*to*/, const SphereView& /*view*/) {}

/// What is said of the window alone.
void put_in_window(Numbers& to, const View& view, const std::vector<Tensor2>& moments, const std::string& error_is) {
  put(to, "in_window", statistics::TensorEstimate{inner_stress(view, moments)}, "Pa",
      ("Stress of the grains in the window, tension positive; its error is " + error_is).c_str(), Trait::detail);
}
void put_in_window(Numbers& /*to*/, const SphereView& /*view*/, const std::vector<Tensor3>& /*moments*/,
                   const std::string& /*error_is*/) {}

constexpr const char* deviator_is(const Tensor2& /*of*/) {
  return "Deviator q, half the difference of the principal stresses";
}
constexpr const char* deviator_is(const Tensor3& /*of*/) {
  return "Deviator q, sqrt(3 J_2): in a triaxial test the difference of the principal stresses";
}

void put_axes(Numbers& to, const Tensor2& s) {
  const double axis = 0.5 * std::atan2(-(s.xy + s.yx), -(s.xx - s.yy)) * 180 / std::numbers::pi;
  put_angle(to, "axis_of_compression_deg", axis < 0 ? axis + 180 : axis, half_turn,
            "Direction of greatest compression, from x");
}
void put_axes(Numbers& to, const Tensor3& stress) {
  const spheres::Principal axes = spheres::principal(stress);
  const Vec3 s = axes.value, n = axes.direction[2];
  put(to, "principal_Pa", Numbers::list({s.x, s.y, s.z}), "Pa", "Principal stresses, tension positive");
  put(to, "axis_of_compression", Numbers::list({n.x, n.y, n.z}), "",
      "Direction of greatest compression: x, y, z of a unit vector");
}

/// The stress of the whole sample by itself, and in `details` what else is known of it.
template <int D> void put_whole_stress(Numbers& to, Numbers& details, const ViewIn<D>& view) {
  const DomainIn<D>& domain = view.packing.domain;
  const double volume = volume_of(domain);
  const Tensor<D> s = whole_stress(view.packing);
  const std::vector<Tensor<D>> moments = grain_moments(view.packing);
  Tensor<D> sum;
  for (const Tensor<D>& m : moments) sum += 1 / volume * m;
  const bool walled = !domain.is_cell() && std::ranges::any_of(view.pairs().j, arenite::is_wall);
  const std::string error_is = view.options.in_time ? "the scatter in time" : "unknown from one sample";
  put(to, "stress", with_scatter_in_time(view, s), "Pa",
      ("Mean stress of the sample, tension positive; its error is " + error_is).c_str(), Trait::by_forces);
  put_in_window(details, view, moments, error_is);
  put(details, "sum_over_grains", rows_of(sum), "Pa", "Stress as the sum over grains", Trait::detail);
  if (walled)
    put(details, "from_walls_and_weight", rows_of(1 / volume * wall_moment(view.packing, view.options.gravity)), "Pa",
        "Stress from the forces on walls and from weight; the same in equilibrium", Trait::detail);
  put(details, "pressure_Pa", pressure(s), "Pa", "Pressure p, mean of the principal stresses, compression positive");
  put(details, "deviator_Pa", deviator(s), "Pa", deviator_is(s));
  put_axes(details, s);
}

}  // namespace

template <int D> void stress(const ViewIn<D>& view, TextureIn<D>& texture) {
  Numbers details = Numbers::tree();
  if (view.has_box && view.has_thickness) put_whole_stress(texture.numbers, details, view);
  put_strong_shares(details, view);
  if (!details.empty()) texture.numbers["stress_details"] = details.mark(Trait::by_forces);
}
template void stress(const View&, Texture&);
template void stress(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture
