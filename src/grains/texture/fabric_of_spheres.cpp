#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "grains/texture/fabric.hpp"
#include "grains/texture/spheres/hemisphere.hpp"
#include "grains/texture/spheres/tensor3.hpp"

namespace arenite::texture {
namespace spheres {
namespace {

/// Components of a symmetric tensor in the order of Voigt, and their places.
constexpr int voigt[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

/// Terms n_a n_b that a direction brings; a quadratic form of them is x . n n.
std::array<double, 6> products(Vec3 n) {
  std::array<double, 6> p{};
  for (int k = 0; k < 6; ++k) p[k] = (k < 3 ? 1 : 2) * n[voigt[k][0]] * n[voigt[k][1]];
  return p;
}

/// sqrt(3/2 b:b) of the deviator b of a symmetric tensor by its six components.
double size_of_deviator(const double* t) {
  const double mean = (t[0] + t[1] + t[2]) / 3;
  double square = 0;
  for (int k = 0; k < 6; ++k) square += k < 3 ? (t[k] - mean) * (t[k] - mean) : 2 * t[k] * t[k];
  return std::sqrt(1.5 * square);
}

enum Term {
  count = 0,
  fabric_sum = 1,
  force_sum = 7,
  normal_sum = 13,
  shear_sum = 49,         // of tangential forces with the tangential forms,
  shear_normal_sum = 55,  // and of these with each other
  terms = 91
};
constexpr double rounding = 1e-12;  // of pivots
enum Result { phi = 0, a_c = 6, a_c_signed, p_4, a_n, a_t, results };

/// What each component of a symmetric tensor b brings to b n - (n . b n) n.
std::array<Vec3, 6> tangential_forms(Vec3 n) {
  std::array<Vec3, 6> forms{};
  for (int k = 0; k < 6; ++k) {
    forms[k][voigt[k][0]] += n[voigt[k][1]];
    if (k >= 3) forms[k][voigt[k][1]] += n[voigt[k][0]];
    forms[k] -= dot(forms[k], n) * n;
  }
  return forms;
}

void add_contact(const ContactsIn<3>& contacts, std::size_t c, double* sums) {
  const auto p = products(contacts.normal[c]);
  sums[count] += 1;
  for (int a = 0; a < 6; ++a) {
    sums[fabric_sum + a] += contacts.normal[c][voigt[a][0]] * contacts.normal[c][voigt[a][1]];
    sums[force_sum + a] += contacts.fn[c] * p[a];
    for (int b = 0; b < 6; ++b) sums[normal_sum + 6 * a + b] += p[a] * p[b];
  }
  const auto forms = tangential_forms(contacts.normal[c]);
  const Vec3 tangential = cross(contacts.ft[c], contacts.normal[c]);
  for (int a = 0; a < 6; ++a) {
    sums[shear_sum + a] += dot(tangential, forms[a]);
    // The sum of the diagonal, which moves nothing along a contact, is fitted to 0.
    for (int b = 0; b < 6; ++b) sums[shear_normal_sum + 6 * a + b] += dot(forms[a], forms[b]) + (a < 3 && b < 3);
  }
}

/// The axis along which most contacts are.
Vec3 axis_of_most(const ContactsIn<3>& contacts, const Items& items) {
  Tensor3 sum;
  for (const std::size_t c : items) sum += outer(contacts.normal[c], contacts.normal[c]);
  return principal(sum).direction[0];
}

/// <P_4(cos)> about an axis, of a fourth moment that the normal equations hold.
double fourth_about(Vec3 axis, const double* normal, double n, const double* tensor) {
  const auto p = products(axis);
  const double second = std::inner_product(p.begin(), p.end(), tensor, 0.0);
  double fourth = 0;  // sum of (n . axis)^4; each product stands with its weight, so one of the two is divided out
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b) fourth += p[a] * p[b] * normal[6 * a + b] / ((a < 3 ? 1 : 2) * (b < 3 ? 1 : 2));
  return (35 * fourth / n - 30 * second + 3) / 8;
}

Tensor3 tensor_of(const double* t) {
  Tensor3 tensor;
  for (int k = 0; k < 6; ++k) tensor.at[voigt[k][0]][voigt[k][1]] = tensor.at[voigt[k][1]][voigt[k][0]] = t[k];
  return tensor;
}

/// About the main axis of all contacts: one of those that are left would add its own turns to the error of what lies
/// about it.
std::vector<double> evaluate(const std::vector<double>& s, Vec3 load_axis, Vec3 main_axis) {
  std::vector<double> r(results, statistics::unknown);
  const double n = s[count];
  if (n < 1) return r;
  for (int k = 0; k < 6; ++k) r[phi + k] = s[fabric_sum + k] / n;
  r[a_c] = 7.5 * size_of_deviator(&r[phi]);
  const auto along = products(load_axis);
  if (load_axis != Vec3{})
    r[a_c_signed] = 11.25 * (std::inner_product(along.begin(), along.end(), &r[phi], 0.0) - 1.0 / 3);
  r[p_4] = fourth_about(main_axis, &s[normal_sum], n, &r[phi]);
  const std::vector<double> form = fitted<6>(&s[normal_sum], &s[force_sum], rounding);
  const double mean_force = (form[0] + form[1] + form[2]) / 3;
  r[a_n] = size_of_deviator(form.data()) / mean_force;
  r[a_t] = size_of_deviator(fitted<6>(&s[shear_normal_sum], &s[shear_sum], rounding).data()) / mean_force;
  return r;
}

std::vector<double> by_directions(const SphereView& view, const Items& items) {
  std::vector<double> contacts(hemisphere::cells);
  for (const std::size_t c : items) contacts[hemisphere::cell_of(view.pairs().normal[c])] += 1;
  return contacts;
}

Numbers direction(Vec3 n) { return Numbers::list({n.x, n.y, n.z}); }

Numbers fabric_numbers(const SphereView& view, const Items& items) {
  Numbers j = Numbers::tree();
  const Vec3 axis = axis_of_most(view.pairs(), items);
  const auto r = statistics::jackknife_of_sums(
      items, view.contact_block, terms, [&](std::size_t c, double* sums) { add_contact(view.pairs(), c, sums); },
      [&](const std::vector<double>& sums) { return evaluate(sums, view.load_axis, axis); });
  std::array<double, 6> value{}, error{};
  for (int k = 0; k < 6; ++k) value[k] = r[phi + k].value, error[k] = r[phi + k].error;
  put(j, "contacts", items.size(), "", "Contacts of the set");
  put(j, "a_c", r[a_c], "",
      "Contact anisotropy a_c, sqrt(3/2 a:a) of a = 15/2 (<n (x) n> - 1/3); 0: isotropic (Guo and Zhao 2013)");
  if (view.load_axis != Vec3{})
    put(j, "a_c_signed", r[a_c_signed], "",
        "3/2 of a's part along the load: a_c with its sign where the fabric is symmetric about the load",
        by_load_axis(view));
  put(j, "a_c_noise", 7.5 / std::sqrt(static_cast<double>(items.size())), "",
      "a_c of the same number of random orientations, root mean square");
  put(j, "phi", Numbers{{"value", rows_of(tensor_of(value.data()))}, {"error", rows_of(tensor_of(error.data()))}}, "",
      "Fabric tensor <n (x) n>", Trait::detail);
  const Principal axes = principal(tensor_of(value.data()));
  put(j, "principal", Numbers::list({axes.value.x, axes.value.y, axes.value.z}), "", "Its principal values",
      Trait::detail);
  put(j, "axis", direction(axes.direction[0]), "", "Direction of most contacts: x, y, z of a unit vector");
  put(j, "directions", by_directions(view, items), "",
      "Contacts by 75 equal parts of the half sphere of directions, from y outwards", Trait::curve);
  put(j, "p_4", r[p_4], "", "<P_4(cos)> of contact orientations about that direction, of the fourth-order fabric",
      Trait::detail);
  put(j, "a_n", r[a_n], "",
      "Anisotropy of the mean normal force, as a_c, of the form f_0 (1 + b n n) that fits the forces best",
      Trait::detail | Trait::by_forces);
  put(j, "a_t", r[a_t], "",
      "Anisotropy of the mean tangential force, as a_c, of the form f_0 (b n - (n b n) n) that fits the forces best",
      Trait::detail | Trait::by_forces);
  return j;
}

}  // namespace
}  // namespace spheres

Numbers fabric_of(const SphereView& view, const Items& items) { return spheres::fabric_numbers(view, items); }

}  // namespace arenite::texture
