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
template <int D>
Mobility mobility(const SampleIn<D>& s, const BondSlotIn<D>& b, double share_i = 1, double share_j = 1) {
  const GrainRecord<D>&a = s.record[b.i], &c = s.record[b.j];
  const double normal = share_i / a.mass + share_j / c.mass;
  if (!s.integration.rotations) return {normal, normal, 0};
  const double turn_i = share_i / inertia(a), turn_j = share_j / inertia(c);
  return {normal, normal + b.arm_i * b.arm_i * turn_i + b.arm_j * b.arm_j * turn_j, turn_i + turn_j};
}

void tune_twist(BondSlot& /*slot*/, double /*turning*/, double /*share*/) {}
void tune_twist(BondSlotIn<3>& b, double turning, double share) {
  b.dashpots.twist = turning > 0 ? 2 * share * std::sqrt(b.beam.twist / turning) : 0;
}

/// Dashpots that damp two free grains by that share of the critical damping.
template <int D> void tune_dashpots(const SampleIn<D>& s, BondSlotIn<D>& b, double share) {
  const Mobility m = mobility(s, b);
  b.dashpots.normal = 2 * share * std::sqrt(b.beam.normal / m.normal);
  b.dashpots.shear = 2 * share * std::sqrt(b.beam.shear / m.shear);
  b.dashpots.bending = m.bending > 0 ? 2 * share * std::sqrt(b.beam.bending / m.bending) : 0;
  tune_twist(b, m.bending, share);
}

/// Strength of a bond over that of all; it depends on nothing but its grains and the seed.
template <int D> double strength_of(const BondIn<D>& bond, double scatter, std::int64_t seed) {
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

template <int D> bool is_before(const BondIn<D>& a, const BondIn<D>& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; }

/// How a disk is turned, as a bond remembers it.
double attitude_of(const Sample& s, std::int32_t disk) { return s.angle[disk]; }
Vec3 attitude_of(const SampleIn<3>& s, std::int32_t disk) {
  return vector_of(the<BondsIn<3>>(s).attitudes.now[s.record[disk].grain]);
}

template <int D> BondIn<D> bond_between(const SampleIn<D>& s, std::int32_t i, std::int32_t j, Vec<D> branch) {
  const std::int32_t a = s.record[i].grain, b = s.record[j].grain;
  BondIn<D> bond;
  bond.i = std::min(a, b);
  bond.j = std::max(a, b);
  bond.length = norm(branch);
  bond.normal = (a < b ? 1.0 : -1.0) / bond.length * branch;
  bond.angle_i = attitude_of(s, a < b ? i : j);
  bond.angle_j = attitude_of(s, a < b ? j : i);
  return bond;
}

/// Where the bond is free of stress, as beam_motion asks for it.
void put_rest(const Sample& s, const Bond& bond, BondSlot& b) {
  const Vec2 branch = s.record[b.i].place - s.record[b.j].place - s.domain.way(b.shift);
  b.normal = branch / norm(branch);
  const double turned = std::atan2(cross(bond.normal, b.normal), dot(bond.normal, b.normal));
  b.angle_i = unstrained(bond.angle_i + turned, s.angle[b.i]);
  b.angle_j = unstrained(bond.angle_j + turned, s.angle[b.j]);
}
void put_rest(const SampleIn<3>& /*sample*/, const BondIn<3>& bond, BondSlotIn<3>& b) {
  const geometry::Rotation back_i = geometry::rotation_by(-bond.angle_i), back_j = geometry::rotation_by(-bond.angle_j);
  b.along_i = turned(back_i, bond.normal);
  b.along_j = turned(back_j, bond.normal);
  const geometry::Rotation rest = back_i * inverse(back_j);
  b.rest_cosine = rest.cosine;
  b.rest_sine = rest.sine;
}

template <class Law> Beam beam_of(const Law& law, double length, double radius, const Domain& domain) {
  return law.beam(length, radius, domain.thickness);
}
template <class Law> RoundBeam beam_of(const Law& law, double length, double radius, const DomainIn<3>& /*domain*/) {
  return law.round_beam(length, radius);
}

}  // namespace

template <int D>
BondSlotIn<D> slot_of(const SampleIn<D>& s, std::size_t place, const std::vector<std::int32_t>& number) {
  const BondIn<D>& bond = the<BondsIn<D>>(s).all[place];
  BondSlotIn<D> b;
  b.bond = static_cast<std::int32_t>(place);
  b.i = number[bond.i];
  b.j = number[bond.j];
  const GrainRecord<D>&a = s.record[b.i], &c = s.record[b.j];
  b.shift = s.domain.cells_between(a.place - c.place);
  b.length = bond.length;
  b.arm_i = bond.length * a.radius / (a.radius + c.radius);
  b.arm_j = bond.length - b.arm_i;
  put_rest(s, bond, b);
  s.contact.bonds.visit([&](const auto& law) {
    b.beam = beam_of(law, bond.length, std::min(a.radius, c.radius), s.domain);
    tune_dashpots(s, b, law.damping);
    b.strength = strength_of(bond, law.scatter, law.seed);
  });
  return b;
}

template <int D> BondNumbers<D> lined_up(const std::vector<BondSlotIn<D>>& slots) {
  BondNumbers<D> numbers;
  constexpr std::size_t columns = sizeof(BondRow<D, double>) / sizeof(double);
  numbers.look.resize(slots.size());
  numbers.row.resize((slots.size() + 7) / 8);
  for (std::size_t n = 0; n < slots.size(); ++n) {
    const BondSlotIn<D>& b = slots[n];
    numbers.i.push_back(b.i);
    numbers.j.push_back(b.j);
    if (b.shift != Cells<D>{}) numbers.across.push_back(static_cast<std::int32_t>(n));
    numbers.damped |= b.dashpots.normal > 0;
    const auto one = std::bit_cast<std::array<double, columns>>(static_cast<const BondRow<D, double>&>(b));
    auto* const eight = reinterpret_cast<Eight*>(&numbers.row[n / 8]);
    for (std::size_t q = 0; q < columns; ++q) eight[q][n % 8] = one[q];
  }
  return numbers;
}

template <int D> void bond_near_pairs(SampleIn<D>& s) {
  const double bridged = s.contact.bonds.visit([](const auto& law) { return law.gap; });
  double mean_radius = 0;
  for (std::size_t k = 0; k < s.count; ++k) mean_radius += s.record[k].radius / static_cast<double>(s.count);
  std::vector<BondIn<D>>& all = the<BondsIn<D>>(s).all;
  const std::vector<BondIn<D>> before = all;
  const auto& zone = s.start.grains.zone;
  const bool marked =
      !s.contact.glued_pairs.empty() || std::any_of(zone.begin(), zone.end(), [](std::uint8_t z) { return z > 0; });
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    const GrainRecord<D>&a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
    const Vec<D> branch = a.place - b.place;
    const double reach = (1 + 1e-6) * (a.radius + b.radius) + bridged * mean_radius;
    if (dot(branch, branch) >= reach * reach || (marked && !is_marked_as_glued(s, a.grain, b.grain))) continue;
    const BondIn<D> bond = bond_between(s, s.list.i[p], s.list.owner[p], branch);
    if (!std::binary_search(before.begin(), before.end(), bond, is_before<D>)) all.push_back(bond);
  }
  std::sort(all.begin(), all.end(), is_before<D>);
}

template <int D> void end_bond(SampleIn<D>& s, std::size_t slot) {
  auto& bonds = the<BondsIn<D>>(s);
  bonds.slots[slot].state = BondState::broken;
  bonds.slots[slot].strength = never_holds;
  bonds.numbers.row[slot / 8].strength[slot % 8] = never_holds;
}

template <int D> void renew_bond_dashpots(SampleIn<D>& s) {
  const double share = s.contact.bonds.visit([](const auto& law) { return law.damping; });
  for (BondSlotIn<D>& b : the<BondsIn<D>>(s).slots) tune_dashpots(s, b, share);
  the<BondsIn<D>>(s).numbers = lined_up(the<BondsIn<D>>(s).slots);
}

template <int D> Rates bond_rates(const SampleIn<D>& s) {
  std::vector<double> of_grain(s.count, 0.0);
  for (const BondSlotIn<D>& b : the<BondsIn<D>>(s).slots)
    for (const std::int32_t k : {b.i, b.j}) of_grain[k] += 1;
  Rates rates;
  for (const BondSlotIn<D>& b : the<BondsIn<D>>(s).slots) {
    const Mobility m = mobility(s, b, of_grain[b.i], of_grain[b.j]);
    rates.frequency_squared =
        std::max({rates.frequency_squared, b.beam.normal * m.normal,
                  b.beam.shear * m.shear + b.beam.bending * m.bending, twist_stiffness(b.beam) * m.bending});
    rates.damping =
        std::max({rates.damping, b.dashpots.normal * m.normal,
                  b.dashpots.shear * m.shear + b.dashpots.bending * m.bending, twist_damping(b.dashpots) * m.bending});
  }
  return rates;
}

template <int D> double shortest_bond_time(const SampleIn<D>& s) {
  double fastest = 0;
  for (const BondSlotIn<D>& b : the<BondsIn<D>>(s).slots) {
    const Mobility m = mobility(s, b);
    const GrainRecord<D>&a = s.record[b.i], &c = s.record[b.j];
    const double contact = s.coefficients.pair_stiffness(a, c);
    fastest = std::max({fastest, (b.beam.normal + contact) * m.normal, b.beam.shear * m.shear,
                        b.beam.bending * m.bending, twist_stiffness(b.beam) * m.bending});
  }
  return fastest > 0 ? std::numbers::pi / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

#define ARENITE_OF(D)                                                                                \
  template BondSlotIn<D> slot_of(const SampleIn<D>&, std::size_t, const std::vector<std::int32_t>&); \
  template BondNumbers<D> lined_up(const std::vector<BondSlotIn<D>>&);                               \
  template void end_bond(SampleIn<D>&, std::size_t);                                                 \
  template void renew_bond_dashpots(SampleIn<D>&);                                                   \
  template void bond_near_pairs(SampleIn<D>&);                                                       \
  template Rates bond_rates(const SampleIn<D>&);                                                     \
  template double shortest_bond_time(const SampleIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::dem
