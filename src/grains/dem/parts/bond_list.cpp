#include "grains/dem/parts/bond_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "grains/dem/glue.hpp"

namespace arenite::dem {
namespace {

/// 1 over the masses that two disks move with in a bond's three strains: 1/kg, 1/kg and 1/(kg m^2).
struct Mobility {
  double normal, shear, bending;
};
Mobility mobility(const Sample& s, const BondSlot& b, double share_i = 1, double share_j = 1) {
  const DiskRecord &a = s.record[b.i], &c = s.record[b.j];
  const double normal = share_i / a.mass + share_j / c.mass;
  if (!s.integration.rotations) return {normal, normal, 0};
  const double turn_i = share_i / inertia(a), turn_j = share_j / inertia(c);
  return {normal, normal + b.arm_i * b.arm_i * turn_i + b.arm_j * b.arm_j * turn_j, turn_i + turn_j};
}

/// Dashpots that damp two free grains by that share of the critical damping.
void tune_dashpots(const Sample& s, BondSlot& b, double share) {
  const Mobility m = mobility(s, b);
  b.dashpots.normal = 2 * share * std::sqrt(b.beam.normal / m.normal);
  b.dashpots.shear = 2 * share * std::sqrt(b.beam.shear / m.shear);
  b.dashpots.bending = m.bending > 0 ? 2 * share * std::sqrt(b.beam.bending / m.bending) : 0;
}

/// Strength of a bond over that of all; it depends on nothing but its grains and the seed.
double strength_of(const Bond& bond, double scatter, std::int64_t seed) {
  if (!(scatter > 0)) return 1;
  return std::max(
      1 + scatter * RandomStream(static_cast<std::uint64_t>(seed), Purpose::bonds, pair_key(bond.i, bond.j)).normal(),
      0.1);
}

/// This angle, or one whole turns away, that is nearest to an angle of now.
double unstrained(double angle, double now) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle + turn * std::nearbyint((now - angle) / turn);
}

/// A strength that no stress is within: the loop hands the bond over, which then has no force.
constexpr double never_holds = -std::numeric_limits<double>::infinity();

bool is_before(const Bond& a, const Bond& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; }

Bond bond_between(const Sample& s, std::int32_t i, std::int32_t j, Vec2 branch) {
  const std::int32_t a = s.record[i].grain, b = s.record[j].grain;
  Bond bond;
  bond.i = std::min(a, b);
  bond.j = std::max(a, b);
  bond.length = norm(branch);
  bond.normal = (a < b ? 1.0 : -1.0) / bond.length * branch;
  bond.angle_i = s.angle[a < b ? i : j];
  bond.angle_j = s.angle[a < b ? j : i];
  return bond;
}

}  // namespace

BondSlot slot_of(const Sample& s, std::size_t place, const std::vector<std::int32_t>& number) {
  const Bond& bond = the<Bonds>(s).all[place];
  BondSlot b;
  b.bond = static_cast<std::int32_t>(place);
  b.i = number[bond.i];
  b.j = number[bond.j];
  const DiskRecord &a = s.record[b.i], &c = s.record[b.j];
  b.shift = s.domain.cells_between(a.place - c.place);
  b.length = bond.length;
  b.arm_i = bond.length * a.radius / (a.radius + c.radius);
  b.arm_j = bond.length - b.arm_i;
  const Vec2 branch = a.place - c.place - s.domain.way(b.shift);
  b.normal = branch / norm(branch);
  const double turned = std::atan2(cross(bond.normal, b.normal), dot(bond.normal, b.normal));
  b.angle_i = unstrained(bond.angle_i + turned, s.angle[b.i]);
  b.angle_j = unstrained(bond.angle_j + turned, s.angle[b.j]);
  s.contact.bonds.visit([&](const auto& law) {
    b.beam = law.beam(bond.length, std::min(a.radius, c.radius), s.domain.thickness);
    tune_dashpots(s, b, law.damping);
    b.strength = strength_of(bond, law.scatter, law.seed);
  });
  return b;
}

BondNumbers lined_up(const std::vector<BondSlot>& slots) {
  BondNumbers numbers;
  numbers.look.resize(slots.size());
  for (std::size_t n = 0; n < slots.size(); ++n) {
    const BondSlot& b = slots[n];
    numbers.i.push_back(b.i);
    numbers.j.push_back(b.j);
    if (b.shift.x != 0 || b.shift.y != 0) numbers.across.push_back(static_cast<std::int32_t>(n));
    numbers.damped |= b.dashpots.normal > 0;
    const auto values = std::bit_cast<std::array<double, bond_columns>>(static_cast<const BondRow<double>&>(b));
    for (std::size_t q = 0; q < bond_columns; ++q) numbers.column.along[q].push_back(values[q]);
  }
  return numbers;
}

void bond_near_pairs(Sample& s) {
  const double bridged = s.contact.bonds.visit([](const auto& law) { return law.gap; });
  double mean_radius = 0;
  for (std::size_t k = 0; k < s.count; ++k) mean_radius += s.record[k].radius / static_cast<double>(s.count);
  const std::vector<Bond> before = the<Bonds>(s).all;
  const auto& zone = s.start.grains.zone;
  const bool marked =
      !s.contact.glued_pairs.empty() || std::any_of(zone.begin(), zone.end(), [](std::uint8_t z) { return z > 0; });
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const DiskRecord &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
    const Vec2 branch = a.place - b.place;
    const double reach = (1 + 1e-6) * (a.radius + b.radius) + bridged * mean_radius;
    if (dot(branch, branch) >= reach * reach || (marked && !is_marked_as_glued(s, a.grain, b.grain))) continue;
    const Bond bond = bond_between(s, s.list.i[p], s.list.owner[p], branch);
    if (!std::binary_search(before.begin(), before.end(), bond, is_before)) the<Bonds>(s).all.push_back(bond);
  }
  std::sort(the<Bonds>(s).all.begin(), the<Bonds>(s).all.end(), is_before);
}

void end_bond(Sample& s, std::size_t slot) {
  the<Bonds>(s).slots[slot].state = BondSlot::State::broken;
  the<Bonds>(s).slots[slot].strength = the<Bonds>(s).numbers.columns().strength[slot] = never_holds;
}

void renew_bond_dashpots(Sample& s) {
  const double share = s.contact.bonds.visit([](const auto& law) { return law.damping; });
  for (BondSlot& b : the<Bonds>(s).slots) tune_dashpots(s, b, share);
  the<Bonds>(s).numbers = lined_up(the<Bonds>(s).slots);
}

Rates bond_rates(const Sample& s) {
  std::vector<double> of_grain(s.count, 0.0);
  for (const BondSlot& b : the<Bonds>(s).slots)
    for (const std::int32_t k : {b.i, b.j}) of_grain[k] += 1;
  Rates rates;
  for (const BondSlot& b : the<Bonds>(s).slots) {
    const Mobility m = mobility(s, b, of_grain[b.i], of_grain[b.j]);
    rates.frequency_squared =
        std::max(rates.frequency_squared,
                 std::max(b.beam.normal * m.normal, b.beam.shear * m.shear + b.beam.bending * m.bending));
    rates.damping = std::max(rates.damping, std::max(b.dashpots.normal * m.normal,
                                                     b.dashpots.shear * m.shear + b.dashpots.bending * m.bending));
  }
  return rates;
}

double shortest_bond_time(const Sample& s) {
  double fastest = 0;
  for (const BondSlot& b : the<Bonds>(s).slots) {
    const Mobility m = mobility(s, b);
    const DiskRecord &a = s.record[b.i], &c = s.record[b.j];
    const double contact = s.coefficients.pair_stiffness(a, c);
    fastest =
        std::max({fastest, (b.beam.normal + contact) * m.normal, b.beam.shear * m.shear, b.beam.bending * m.bending});
  }
  return fastest > 0 ? std::numbers::pi / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

}  // namespace arenite::dem
