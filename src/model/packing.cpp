#include "model/packing.hpp"

#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

#include "model/shapes.hpp"

namespace arenite {

template <int D> double GrainsIn<D>::area() const requires(D == 2) {
  double sum = 0;
  for (const double r : radius) sum += std::numbers::pi * r * r;
  return sum;
}

template <int D> double GrainsIn<D>::volume() const requires(D == 3) {
  double sum = 0;
  for (const double r : radius) sum += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  return sum;
}

template <int D> double GrainsIn<D>::mean_diameter() const {
  return radius.empty() ? 0
                        : 2 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
}

template <int D> void GrainsIn<D>::resize(std::size_t n) {
  const std::size_t old = size();
  id.resize(n);
  for (std::size_t i = old; i < n; ++i) id[i] = static_cast<std::int64_t>(i);
  for (auto* a : {&position, &velocity}) a->resize(n);
  radius.resize(n, 0.0);
  for (auto* a : {&angle, &omega}) a->resize(n);
  material.resize(n, 0);
  zone.resize(n, 0);
}
template struct GrainsIn<2>;
template struct GrainsIn<3>;

Grains picked(const Grains& from, const std::vector<std::int32_t>& which, Vec2 origin) {
  Grains grains;
  grains.resize(which.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    const auto g = static_cast<std::size_t>(which[k]);
    grains.id[k] = from.id[g];
    grains.radius[k] = from.radius[g];
    grains.material[k] = from.material[g];
    grains.zone[k] = from.zone[g];
    grains.position[k] = from.position[g] - origin;
    grains.angle[k] = from.angle[g];
    if (!from.shapes.empty()) add_shape(grains.shapes, shape_of(from, g), from.shapes.gyration[g]);
  }
  return grains;
}

namespace {
/// A turning whose every component is this number.
double all(double number, double /*like*/) { return number; }
Vec3 all(double number, Vec3 /*like*/) { return {number, number, number}; }
}  // namespace

template <int D>
void ContactsIn<D>::add(std::int32_t a, std::int32_t b, Vec<D> n, double normal_force, Turning<D> tangential_force,
                        double arm_a, double arm_b) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  i.push_back(a);
  j.push_back(b);
  normal.push_back(n);
  fn.push_back(normal_force);
  ft.push_back(tangential_force);
  arm_i.push_back(arm_a);
  arm_j.push_back(arm_b);
  overlap.push_back(unknown);
  sliding_velocity.push_back(all(unknown, Turning<D>{}));
  glued.push_back(0);
}
template struct ContactsIn<2>;
template struct ContactsIn<3>;

template <int D> Vec<D> force_on_i(const PackingIn<D>& packing, const BondIn<D>& bond) {
  const Vec<D> branch = branch_of(packing, bond), n = branch / norm(branch);
  return bond.fn * n + cross(bond.ft, n);
}

template <int D> Vec<D> force_on_i(const PackingIn<D>& packing, const CohesivePair& pair) {
  const Vec<D> branch = branch_of(packing, pair);
  return -pair.pull / norm(branch) * branch;
}

template Vec2 force_on_i(const Packing&, const Bond&);
template Vec3 force_on_i(const PackingIn<3>&, const BondIn<3>&);
template Vec2 force_on_i(const Packing&, const CohesivePair&);
template Vec3 force_on_i(const PackingIn<3>&, const CohesivePair&);

template <int D> double mass_of(const PackingIn<D>& packing) {
  double mass = 0;
  for (std::size_t g = 0; g < packing.grains.size(); ++g) mass += mass_of(packing, g);
  return mass;
}
template double mass_of(const Packing&);
template double mass_of(const PackingIn<3>&);

template <> double mean_density(const Packing& packing) {
  return mass_of(packing) / (packing.grains.area() * packing.domain.thickness);
}
template <> double mean_density(const PackingIn<3>& packing) { return mass_of(packing) / packing.grains.volume(); }

template <int D> double mean_compressive_force(const ContactsIn<D>& contacts) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c) || !(contacts.fn[c] > 0)) continue;
    sum += contacts.fn[c];
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}
template double mean_compressive_force(const Contacts&);
template double mean_compressive_force(const ContactsIn<3>&);

}  // namespace arenite
