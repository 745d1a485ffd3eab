#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

using Complex = std::complex<double>;
constexpr double degrees = 180 / std::numbers::pi;

/// Mean length of the resultant of n random unit vectors: sqrt(pi)/2 / sqrt(n).
double resultant_noise(std::size_t n) { return 0.5 * std::sqrt(std::numbers::pi / static_cast<double>(n)); }

/// arg(z)/m in degrees, in [0, 360/m).
double phase(Complex z, int m) {
  const double angle = std::arg(z) / m * degrees;
  return angle < 0 ? angle + 360.0 / m : angle;
}

/// Sums over contacts: the powers of u = exp(2 i theta), and the normal equations that fit F_n and F_t by A + B cos 2 theta + C sin 2 theta.
enum Term { count, c2, s2, c4, s4, c6, s6, cc, cs, ss, fn, fn_c, fn_s, ft, ft_c, ft_s, terms };

void add_contact(const Contacts& contacts, std::size_t c, double* sums) {
  const double nx = contacts.normal[c].x, ny = contacts.normal[c].y;
  const Complex u{nx * nx - ny * ny, 2 * nx * ny}, u2 = u * u, u3 = u2 * u;
  const double x = u.real(), y = u.imag(), n = contacts.fn[c], t = contacts.ft[c];
  const double values[terms] = {1, x, y, u2.real(), u2.imag(), u3.real(), u3.imag(), x * x, x * y, y * y, n, n * x, n * y, t, t * x, t * y};
  for (int k = 0; k < terms; ++k) sums[k] += values[k];
}

enum Result { phi_xx, phi_xy, phi_yy, a_c, theta_c, a_c_signed, a_n, theta_n, a_t, amplitude2, phase2, amplitude4, phase4, amplitude6, phase6, results };
const std::vector<double> periods = [] {
  std::vector<double> p(results, 0.0);
  p[theta_c] = p[theta_n] = p[phase2] = 180;
  p[phase4] = 90;
  p[phase6] = 60;
  return p;
}();

/// Anisotropies of force by least squares over directions, so that they do not inherit the anisotropy of the counts.
void fit_forces(const std::vector<double>& s, std::vector<double>& r) {
  Eigen::Matrix3d normal;
  normal << s[count], s[c2], s[s2], s[c2], s[cc], s[cs], s[s2], s[cs], s[ss];
  const Eigen::ColPivHouseholderQR<Eigen::Matrix3d> qr(normal);
  if (qr.rank() < 3) return;
  const Eigen::Vector3d n = qr.solve(Eigen::Vector3d(s[fn], s[fn_c], s[fn_s]));
  const Eigen::Vector3d t = qr.solve(Eigen::Vector3d(s[ft], s[ft_c], s[ft_s]));
  r[a_n] = std::hypot(n[1], n[2]) / n[0];
  r[theta_n] = phase({n[1], n[2]}, 2);
  r[a_t] = std::hypot(t[1], t[2]) / n[0];
}

std::vector<double> evaluate(const std::vector<double>& s, double load_axis) {
  std::vector<double> r(results, unknown);
  const double n = s[count];
  if (n < 1) return r;
  const Complex second{s[c2] / n, s[s2] / n};
  r[phi_xx] = 0.5 * (1 + second.real());
  r[phi_yy] = 0.5 * (1 - second.real());
  r[phi_xy] = 0.5 * second.imag();
  r[a_c] = 2 * std::abs(second);
  r[theta_c] = phase(second, 2);
  r[a_c_signed] = 2 * (second * std::polar(1.0, -2 * load_axis)).real();
  for (int k = 0; k < 3; ++k) {
    const Complex z{s[c2 + 2 * k] / n, s[s2 + 2 * k] / n};
    r[amplitude2 + 2 * k] = std::abs(z);
    r[phase2 + 2 * k] = phase(z, 2 * (k + 1));
  }
  if (n > 3) fit_forces(s, r);
  return r;
}

void fill_sectors(const View& view, const Items& items, Fabric& f) {
  const auto sectors = static_cast<std::size_t>(view.options.sectors);
  f.sectors.assign(sectors, 0.0);
  f.sector_force.assign(sectors, 0.0);
  for (const std::size_t c : items) {
    double angle = std::atan2(view.pairs().normal[c].y, view.pairs().normal[c].x) * degrees;
    if (angle < 0) angle += 180;
    // A direction on an edge, as in a lattice, goes to the sector above it whatever its last bit says.
    const auto s = static_cast<std::size_t>(std::floor((angle + 1e-9) / (180.0 / view.options.sectors))) % sectors;
    f.sectors[s] += 1;
    f.sector_force[s] += view.pairs().fn[c];
  }
  for (std::size_t s = 0; s < sectors; ++s)
    if (f.sectors[s] > 0) f.sector_force[s] /= f.sectors[s];
}

Fabric fabric_of(const View& view, const Items& items) {
  const auto r = jackknife_of_sums(
      items, view.contact_block, terms, [&](std::size_t c, double* sums) { add_contact(view.pairs(), c, sums); },
      [&](const std::vector<double>& s) { return evaluate(s, view.load_axis); }, periods);
  Fabric f;
  f.contacts = items.size();
  f.phi.value = {r[phi_xx].value, r[phi_xy].value, r[phi_xy].value, r[phi_yy].value};
  f.phi.error = {r[phi_xx].error, r[phi_xy].error, r[phi_xy].error, r[phi_yy].error};
  f.a_c = r[a_c];
  f.theta_c_deg = r[theta_c];
  f.a_c_signed = r[a_c_signed];
  f.a_n = r[a_n];
  f.theta_n_deg = r[theta_n];
  f.a_t = r[a_t];
  const double noise = resultant_noise(items.size());
  f.noise = 2 * noise;
  for (std::size_t k = 0; k < 3; ++k) f.modes[k] = {2 * static_cast<int>(k + 1), r[amplitude2 + 2 * k], r[phase2 + 2 * k], noise};
  fill_sectors(view, items, f);
  return f;
}

/// The set itself and its strong and weak contacts; empty ones are left out.
void add_sets(const View& view, const std::string& name, const Items& items, ByName<Fabric>& fabric) {
  Items strong, weak;
  for (const std::size_t c : items) (view.strong(c) ? strong : weak).push_back(c);
  const std::string prefix = name == "all" ? "" : name + " ";
  if (!items.empty()) fabric.emplace_back(name, fabric_of(view, items));
  if (!strong.empty()) fabric.emplace_back(prefix + "strong", fabric_of(view, strong));
  if (!weak.empty()) fabric.emplace_back(prefix + "weak", fabric_of(view, weak));
}

/// Strong and weak are told apart by the mean force of the whole network; a contact that pulls is weak.
void measure_fabric(const View& view, Texture& texture) {
  add_sets(view, "all", view.contacts, texture.fabric);
  for (const auto& [name, items] : contacts_by_type(view)) add_sets(view, name, items, texture.fabric);
}

/// Signed a_c of the contacts that carry at most, and more than, a multiple of the mean force, from 0 to 4 by 0.1.
void measure_threshold(const View& view, Texture& texture) {
  if (view.contacts.empty() || view.mean_force <= 0) return;
  constexpr std::size_t fewest = 10;
  const auto& contacts = view.pairs();
  Items sorted = view.contacts;
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return contacts.fn[a] < contacts.fn[b]; });
  std::vector<double> sum{0};  // of cos 2(theta - theta_load) over the weakest k contacts
  for (const std::size_t c : sorted) {
    const Vec2 n = contacts.normal[c], load{std::cos(view.load_axis), std::sin(view.load_axis)};
    sum.push_back(sum.back() + 2 * dot(n, load) * dot(n, load) - 1);
  }
  ThresholdCurve& curve = texture.threshold;
  const auto push = [](std::vector<double>& a, std::vector<double>& noise, double total, std::size_t n) {
    a.push_back(n < fewest ? unknown : 2 * total / static_cast<double>(n));
    noise.push_back(n < fewest ? unknown : 2 * 0.886 / std::sqrt(static_cast<double>(n)));
  };
  for (int k = 0; k <= 40; ++k) {
    const double threshold = 0.1 * k;
    const auto below = static_cast<std::size_t>(
        std::upper_bound(sorted.begin(), sorted.end(), threshold * view.mean_force, [&](double force, std::size_t c) { return force < contacts.fn[c]; }) -
        sorted.begin());
    curve.threshold.push_back(threshold);
    push(curve.below, curve.below_noise, sum[below], below);
    push(curve.above, curve.above_noise, sum.back() - sum[below], sorted.size() - below);
  }
}

constexpr Declared<Fabric> fabric_numbers[] = {
    {"contacts", "", "Contacts of the set", &Fabric::contacts},
    {"a_c", "", "Contact anisotropy a_c, 2 (phi_1 - phi_2), T eq. 1.8; 0: contacts in all directions alike", &Fabric::a_c},
    {"theta_c_deg", "deg", "Direction of most contacts, from x", &Fabric::theta_c_deg},
    {"phi", "", "Fabric tensor <n (x) n>, T eq. 1.6", &Fabric::phi},
    {"a_c_signed", "", "a_c cos 2(theta_c - theta_load): positive along the load", &Fabric::a_c_signed},
    {"a_c_noise", "", "a_c that as many random directions give", &Fabric::noise},
    {"a_n", "", "Anisotropy of the mean normal force", &Fabric::a_n},
    {"theta_n_deg", "deg", "Direction of the largest normal forces, from x", &Fabric::theta_n_deg},
    {"a_t", "", "Anisotropy of the mean tangential force", &Fabric::a_t}};

constexpr Declared<Mode> mode_numbers[] = {{"amplitude", "", "|<exp(i m theta)>| of contact orientations", &Mode::amplitude},
                                           {"phase_deg", "deg", "Direction of its maximum, in [0, 360/m)", &Mode::phase_deg},
                                           {"noise", "", "Amplitude that as many random directions give", &Mode::noise}};

Numbers set_numbers(const Fabric& f, bool curves) {
  Numbers j = tree_of(f, fabric_numbers);
  for (const Mode& mode : f.modes) j["modes"][std::to_string(mode.m)] = tree_of(mode, mode_numbers);
  if (curves) {
    j["sectors"] = f.sectors;
    j["sector_force_N"] = f.sector_force;
  }
  return j;
}

void put_fabric(const Texture& t, Numbers& to, bool curves) {
  if (t.fabric.empty()) return;
  to["fabric"] = by_set(t.fabric, "sets", [&](const Fabric& f) { return set_numbers(f, curves); });
  put(to["fabric"], "load_axis_deg", t.load_axis_deg, "deg", "Direction of the load, from x, that signs refer to");
}

void put_threshold(const Texture& t, Numbers& to, bool curves) {
  const ThresholdCurve& curve = t.threshold;
  if (!curves || curve.threshold.empty()) return;
  to["fabric"]["threshold"] = {{"force", curve.threshold},
                               {"a_c_below", curve.below},
                               {"noise_below", curve.below_noise},
                               {"a_c_above", curve.above},
                               {"noise_above", curve.above_noise}};
}

}  // namespace

extern const Statistic fabric{measure_fabric, put_fabric}, threshold{measure_threshold, put_threshold};

}  // namespace arenite::texture
