#include "grains/dem/setup.hpp"

#include <cstring>
#include <string>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/cohesion.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

/// "a-dem-04"; changes with what `transfer` lists. States behind a shortened step and those with bonds have more to say: "a-dem-0t", "a-dem-0b",
/// "a-dem-0u" with both.
constexpr std::uint64_t mark(bool shortened, bool bonded) {
  constexpr char last[2][2] = {{'4', 'b'}, {'t', 'u'}};
  return 0x302d6d65642d61 | static_cast<std::uint64_t>(last[shortened][bonded]) << 56;
}

template <class Archive> void transfer(Archive& a, Vec2& v) { a(v.x), a(v.y); }

template <class Archive> void transfer(Archive& a, bool& truth) {
  std::uint8_t byte = truth;
  a(byte);
  truth = byte != 0;
}

template <class Archive, class Choice>
requires std::is_enum_v<Choice>
void transfer(Archive& a, Choice& choice) {
  auto number = static_cast<std::int32_t>(choice);
  a(number);
  choice = static_cast<Choice>(number);
}

template <class Archive> void transfer(Archive& a, Wall& wall) {
  for (auto* v : {&wall.position, &wall.velocity, &wall.force, &wall.shear_force}) a(*v);
}

template <class Archive> void transfer(Archive& a, WallBody& body) {
  transfer(a, body.drive.kind);
  for (auto* v : {&body.drive.value, &body.mass, &body.impedance, &body.sample_mass, &body.drift, &body.rate, &body.acceleration}) a(*v);
  for (auto& v : body.higher) a(v);
  auto state = static_cast<std::uint8_t>((body.rough ? 1 : 0) | (body.open ? 2 : 0));
  a(body.drive.slide), a(body.slid), a(state);
  body.rough = (state & 1) != 0;
  body.open = (state & 2) != 0;
}

template <class Archive> void transfer(Archive& a, Boundary& boundary) {
  a(boundary.points), transfer(a, boundary.present);
  for (Vec2* v : {&boundary.velocity, &boundary.centre, &boundary.force}) transfer(a, *v);
  a(boundary.spin), a(boundary.torque);
}

template <class Archive> void transfer(Archive& a, Energies& e) {
  for (const EnergyTerm& term : energy_terms) a(e.*term.value);
}

/// One list of members for both ways.
template <class Archive> void transfer(Archive& a, Sample& s) {
  transfer(a, s.mass_scaling);
  a(s.inertial_number), a(s.step), a(s.lag), a(s.friction), a(s.wall_friction), a(s.drag);
  transfer(a, s.gravity), transfer(a, s.glue), transfer(a, s.settled), transfer(a, s.balance.open);
  for (auto& wall : s.domain.wall) transfer(a, wall);
  a(s.domain.tilt);
  for (auto& wall : s.listed_domain.wall) transfer(a, wall);
  a(s.listed_domain.tilt), a(s.skin), a(s.builds), a(s.shear_rate), a(s.sheared), a(s.listed_sheared), a(s.held);
  for (auto& body : s.wall) transfer(a, body);
  apply_open(s);
  for (Domain* domain : {&s.domain, &s.listed_domain})
    for (Boundary& boundary : domain->boundaries) transfer(a, boundary);
  for (BoundaryBody& body : s.boundary)
    if (body.mass > 0) transfer(a, body.force), transfer(a, body.rate);
  each_motion_array(s, a);
  for (auto& v : s.listed.along) a(v);
  for (auto& higher : s.higher)
    for (auto& v : higher.along) a(v);
  a(s.live_bonds);
  if (!s.part.empty()) a(s.body), a(s.part);
  transfer(a, s.tally);
  a(s.balance.known);
  for (auto& w : s.balance.powers)
    for (const auto term : work_terms) a(w.*term);
}

template <class Archive> void transfer_step(Archive& a, Sample& s) { a(s.dt), a(s.steps_before), a(s.time_before); }

/// What bonds remember and how they ended; what they hold now follows. Column by column, for a record may have gaps.
template <class Archive> void transfer(Archive& a, std::vector<Bond>& bonds) {
  auto count = static_cast<std::uint64_t>(bonds.size());
  a(count);
  if constexpr (std::is_same_v<Archive, ByteReader>) {
    if (count > a.left() / sizeof(double)) ByteReader::fail();
    bonds.resize(count);
  }
  for (Bond& b : bonds) {
    a(b.i), a(b.j), transfer(a, b.broken);
    for (double* v : {&b.length, &b.normal.x, &b.normal.y, &b.angle_i, &b.angle_j, &b.energy, &b.load, &b.time, &b.place.x, &b.place.y}) a(*v);
  }
}

/// Bonds that broke since the list was built keep their places in it.
std::vector<std::int32_t> broken_in_list(const Sample& s) {
  std::vector<std::int32_t> bonds;
  for (const BondSlot& b : s.bond_slots)
    if (b.state == BondSlot::State::broken) bonds.push_back(b.bond);
  return bonds;
}

void read_bonds(ByteReader& read, Sample& s, std::vector<std::int32_t>& broken) {
  transfer(read, s.bonds), read(broken);
  for (const Bond& b : s.bonds)
    if (b.i < 0 || b.j < 0 || static_cast<std::size_t>(std::max(b.i, b.j)) >= s.count) ByteReader::fail();
  for (const std::int32_t b : broken)
    if (b < 0 || static_cast<std::size_t>(b) >= s.bonds.size()) ByteReader::fail();
}

/// The list as it was built, with what has broken since.
void list_with_bonds(Sample& s, const std::vector<std::int32_t>& broken) {
  const std::vector<Bond> bonds = s.bonds;
  for (const std::int32_t b : broken) s.bonds[b].broken = BondBreak::none;
  list_contacts(s);
  s.bonds = bonds;
  for (std::size_t n = 0; n < s.bond_slots.size(); ++n)
    if (s.bonds[s.bond_slots[n].bond].broken != BondBreak::none) end_bond(s, n);
}

/// The slots' contents; their number follows from the list.
template <class Archive> void transfer(Archive& a, ContactList& list) {
  for (auto* v : {&list.strength, &list.memory}) a(*v);
  if (!list.normal_memory.empty()) a(list.normal_memory);
  if (!list.rolling_memory.empty()) a(list.rolling_memory);
  if (!list.pull.empty()) a(list.pull);
  a(list.force);
  a(list.bond);
}

}  // namespace

std::vector<std::uint8_t> save_sample(const Sample& sample) {
  ByteWriter write;
  auto& s = const_cast<Sample&>(sample);  // the writer does not change what it is given
  const bool shortened = s.dt != s.dt_at_start;
  const bool bonded = !s.bonds.empty();
  std::uint64_t header[3] = {mark(shortened, bonded), s.count, 0};
  std::memcpy(&header[2], &s.dt_at_start, sizeof s.dt_at_start);
  for (auto& v : header) write(v);
  std::vector<DiskRecord> disks(s.record.begin(), s.record.begin() + static_cast<std::ptrdiff_t>(s.count));
  if (shortened) transfer_step(write, s);
  if (bonded) transfer(write, s.bonds), write(broken_in_list(s));
  write(disks);
  transfer(write, s);
  transfer(write, s.list);
  return std::move(write.bytes);
}

void restore_sample(Sample& sample, const std::vector<std::uint8_t>& bytes) {
  ByteReader read(bytes);
  Sample s = sample;
  std::uint64_t header[3] = {}, step = 0;
  for (auto& v : header) read(v);
  std::memcpy(&step, &s.dt_at_start, sizeof step);
  const bool bonded = header[0] == mark(false, true) || header[0] == mark(true, true), shortened = header[0] == mark(true, bonded);
  if (header[0] != mark(shortened, bonded)) ByteReader::fail();
  if (header[1] != s.count || header[2] != step)
    throw InputError("the stored state belongs to another sample or time step (" + std::to_string(header[1]) + " grains; here " + std::to_string(s.count) +
                     ")");
  if (shortened) transfer_step(read, s);
  std::vector<std::int32_t> broken;
  s.bonds.clear();
  if (bonded) read_bonds(read, s, broken);
  read(s.record);
  if (s.record.size() != s.count) ByteReader::fail();
  transfer(read, s);
  if (s.alpha.size() != s.count || s.listed.along[0].size() != s.count) ByteReader::fail();
  if (s.body.size() != sample.body.size() || s.part.size() != sample.part.size()) ByteReader::fail();
  for (std::size_t b = 0; b < s.domain.boundaries.size(); ++b)
    for (const Domain* domain : {&s.domain, &s.listed_domain})
      if (domain->boundaries[b].points.size() != sample.domain.boundaries[b].points.size()) ByteReader::fail();
  s.laws = laws_between_steps(s);

  // The list as it was built: disks and frame put back to where they were then.
  const std::vector<DiskRecord> disks = s.record;
  const Domain domain = s.domain;
  s.domain = s.listed_domain;
  for (std::size_t k = 0; k < s.count; ++k) s.record[k].place = s.listed[k];
  number_held(s);
  list_with_bonds(s, broken);
  const std::size_t slots = s.list.size(), pulls = s.list.pull.size();
  transfer(read, s.list);
  if (s.list.force.size() != slots + 1 + s.bond_slots.size() || s.list.memory.size() != slots || s.list.pull.size() != pulls || !read.at_end())
    ByteReader::fail();
  find_pull_curves(s);
  s.domain = domain;
  std::copy(disks.begin(), disks.end(), s.record.begin());
  refresh_ghosts(s);
  if (s.balance.open) {  // a snapshot of the same state has the same bits; Gear's powers are older
    const EnergyBalance stored = s.balance;
    open_balance(s);
    s.balance.powers = stored.powers;
    s.balance.known = stored.known;
  }
  sample = std::move(s);
}

}  // namespace arenite::dem
