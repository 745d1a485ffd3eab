#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "grains/texture/fabric.hpp"
#include "grains/texture/oscillation.hpp"

namespace arenite::texture {
namespace {

using Complex = std::complex<double>;
constexpr double degrees = 180 / std::numbers::pi;

/// Mean length of the resultant of n random unit vectors: sqrt(pi)/2 / sqrt(n).
double resultant_noise(std::size_t n) { return 0.5 * std::sqrt(std::numbers::pi / static_cast<double>(n)); }

/// Sums over contacts: the powers of u = exp(2 i theta), and the normal equations that fit F_n and F_t by A + B cos 2
/// theta + C sin 2 theta.
enum Term { count, c2, s2, c4, s4, c6, s6, cc, cs, ss, fn, fn_c, fn_s, ft, ft_c, ft_s, terms };

void add_contact(const Contacts& contacts, std::size_t c, double* sums) {
  const double nx = contacts.normal[c].x, ny = contacts.normal[c].y;
  const Complex u{nx * nx - ny * ny, 2 * nx * ny}, u2 = u * u, u3 = u2 * u;
  const double x = u.real(), y = u.imag(), n = contacts.fn[c], t = contacts.ft[c];
  const double values[terms] = {1,     x,     y, u2.real(), u2.imag(), u3.real(), u3.imag(), x * x,
                                x * y, y * y, n, n * x,     n * y,     t,         t * x,     t * y};
  for (int k = 0; k < terms; ++k) sums[k] += values[k];
}

/// Components along cos 2 theta, sin 2 theta and so on, of which amplitudes and directions are made when their errors
/// are known.
enum Result {
  phi_xx,
  phi_xy,
  phi_yy,
  a_c_signed,
  x2,
  y2,
  x4,
  y4,
  x6,
  y6,
  force_x,
  force_y,
  friction_x,
  friction_y,
  results
};

void fit_forces(const std::vector<double>& s, std::vector<double>& r) {
  const double normal[] = {s[count], s[c2], s[s2], s[c2], s[cc], s[cs], s[s2], s[cs], s[ss]};
  const std::vector<double> n = fitted<3>(normal, &s[fn], 1e-15), t = fitted<3>(normal, &s[ft], 1e-15);
  r[force_x] = n[1] / n[0];
  r[force_y] = n[2] / n[0];
  r[friction_x] = t[1] / n[0];
  r[friction_y] = t[2] / n[0];
}

std::vector<double> evaluate(const std::vector<double>& s, double load_axis) {
  std::vector<double> r(results, unknown);
  const double n = s[count];
  if (n < 1) return r;
  const Complex second{s[c2] / n, s[s2] / n};
  r[phi_xx] = 0.5 * (1 + second.real());
  r[phi_yy] = 0.5 * (1 - second.real());
  r[phi_xy] = 0.5 * second.imag();
  r[a_c_signed] = 2 * (second * std::polar(1.0, -2 * load_axis)).real();
  for (int k = x2; k <= y6; ++k) r[k] = s[c2 + k - x2] / n;
  if (n > 3) fit_forces(s, r);
  return r;
}

/// How many contacts point into each of as many sectors over [0, 180) as asked, and their mean F_n, N; 0 where there
/// are none.
void put_sectors(Numbers& to, const View& view, const Items& items) {
  const auto sectors = static_cast<std::size_t>(view.options.sectors);
  std::vector<double> count(sectors, 0.0), force(sectors, 0.0);
  for (const std::size_t c : items) {
    double angle = std::atan2(view.pairs().normal[c].y, view.pairs().normal[c].x) * degrees;
    if (angle < 0) angle += 180;
    // A direction on an edge, as in a lattice, goes to the sector above it whatever its last bit says.
    const auto s = static_cast<std::size_t>(std::floor((angle + 1e-9) / (180.0 / view.options.sectors))) % sectors;
    count[s] += 1;
    force[s] += view.pairs().fn[c];
  }
  for (std::size_t s = 0; s < sectors; ++s)
    if (count[s] > 0) force[s] /= count[s];
  put(to, "sectors", count, "", "Contacts by sectors of directions over half a turn", Trait::curve);
  put(to, "sector_force_N", force, "N", "Mean normal force of these contacts", Trait::curve | Trait::by_forces);
}

}  // namespace

/// Directions of one set of contacts, mirrored beyond half a turn. Directions in degrees from x, in [0, 180).
Numbers fabric_of(const View& view, const Items& items) {
  const auto r = jackknife_of_sums(
      items, view.contact_block, terms, [&](std::size_t c, double* sums) { add_contact(view.pairs(), c, sums); },
      [&](const std::vector<double>& s) { return evaluate(s, view.load_axis); });
  const Oscillation contacts = oscillation(r[x2], r[y2], 2), force = oscillation(r[force_x], r[force_y], 2);
  const double noise = resultant_noise(items.size());
  const auto tensor = [&](double Estimate::*part) {
    return Tensor2{r[phi_xx].*part, r[phi_xy].*part, r[phi_xy].*part, r[phi_yy].*part};
  };
  Numbers j = Numbers::tree();
  put(j, "contacts", items.size(), "", "Contacts of the set");
  put(j, "a_c", Estimate{2 * contacts.amplitude.value, 2 * contacts.amplitude.error}, "",
      "Contact anisotropy a_c, 2 (phi_1 - phi_2), T eq. 1.8; 0: isotropic");
  put_angle(j, "theta_c_deg", contacts.direction_deg, half_turn, "Principal direction of the contacts, from x");
  put(j, "phi", statistics::TensorEstimate{tensor(&Estimate::value), tensor(&Estimate::error)}, "",
      "Fabric tensor <n (x) n>, T eq. 1.6", Trait::detail);
  put(j, "a_c_signed", r[a_c_signed], "", "a_c cos 2(theta_c - theta_load): positive along the load",
      Trait::detail | by_load_axis(view));
  put(j, "a_c_noise", 2 * noise, "", "a_c of the same number of random orientations");
  put(j, "a_n", force.amplitude, "", "Anisotropy of the mean normal force", Trait::detail | Trait::by_forces);
  put_angle(j, "theta_n_deg", force.direction_deg, half_turn, "Direction of the largest normal forces, from x",
            Trait::detail | Trait::by_forces);
  put(j, "a_t", oscillation(r[friction_x], r[friction_y], 2).amplitude, "", "Anisotropy of the mean tangential force",
      Trait::detail | Trait::by_forces);
  j["modes"].mark(Trait::detail);
  for (int k = 0; k < 3; ++k) {
    Numbers& mode = j["modes"][std::to_string(2 * (k + 1))] = Numbers::tree();
    const int m = 2 * (k + 1);
    const Oscillation fold = oscillation(r[x2 + 2 * k], r[y2 + 2 * k], m);
    put(mode, "amplitude", fold.amplitude, "", "|<exp(i m theta)>| of contact orientations");
    put_angle(mode, "phase_deg", fold.direction_deg, whole_turn / m, "Direction of its maximum, in [0, 360/m)");
    put(mode, "noise", noise, "", "Amplitude for the same number of random orientations");
  }
  put_sectors(j, view, items);
  return j;
}

/// Signed a_c of the contacts that carry at most, and more than, a multiple of the mean force, from 0 to 4 by 0.1.
void threshold(const View& view, Texture& texture) {
  if (view.contacts.empty() || view.mean_force <= 0) return;
  constexpr std::size_t fewest = 10;
  const auto& contacts = view.pairs();
  Items sorted = view.contacts;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) { return contacts.fn[a] < contacts.fn[b]; });
  std::vector<double> sum{0};  // of cos 2(theta - theta_load) over the weakest k contacts
  for (const std::size_t c : sorted) {
    const Vec2 n = contacts.normal[c], load{std::cos(view.load_axis), std::sin(view.load_axis)};
    sum.push_back(sum.back() + 2 * dot(n, load) * dot(n, load) - 1);
  }
  std::vector<double> force, below, noise_below, above,
      noise_above;  // over the mean force; unknown where fewer contacts are left
  const auto push = [](std::vector<double>& a, std::vector<double>& noise, double total, std::size_t n) {
    a.push_back(n < fewest ? unknown : 2 * total / static_cast<double>(n));
    noise.push_back(n < fewest ? unknown : 2 * 0.886 / std::sqrt(static_cast<double>(n)));
  };
  for (int k = 0; k <= 40; ++k) {
    const double threshold = 0.1 * k;
    const auto weaker =
        static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), threshold * view.mean_force,
                                                  [&](double limit, std::size_t c) { return limit < contacts.fn[c]; }) -
                                 sorted.begin());
    force.push_back(threshold);
    push(below, noise_below, sum[weaker], weaker);
    push(above, noise_above, sum.back() - sum[weaker], sorted.size() - weaker);
  }
  texture.numbers["fabric"]["threshold"] = {{"force", force},
                                            {"a_c_below", below},
                                            {"noise_below", noise_below},
                                            {"a_c_above", above},
                                            {"noise_above", noise_above}};
  texture.numbers["fabric"]["threshold"].mark(Trait::curve | Trait::by_forces);
}

}  // namespace arenite::texture
