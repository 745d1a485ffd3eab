#include <cstring>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {
namespace {

/// "a-dem-04"; changes with what `Members` lists. States behind a shortened step and those with bonds have more to say:
/// "a-dem-0t", "a-dem-0b", "a-dem-0u" with both.
constexpr std::uint64_t mark(bool shortened, bool bonded) {
  constexpr char last[2][2] = {{'4', 'b'}, {'t', 'u'}};
  return 0x302d6d65642d61 | static_cast<std::uint64_t>(last[shortened][bonded]) << 56;
}

/// Takes members to an archive or from it, one after another, so that one list of them serves both ways.
template <class Archive> class Members {
 public:
  explicit Members(Archive& archive) : archive_(archive) {}
  template <class... Member> void operator()(Member&... member) { (take(member), ...); }

 private:
  /// A number or a vector of plain values; a truth or a choice by its number.
  template <class T> void take(T& value) {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
      auto number = static_cast<std::conditional_t<std::is_enum_v<T>, std::int32_t, std::uint8_t>>(value);
      archive_(number);
      value = static_cast<T>(number);
    } else {
      archive_(value);
    }
  }
  template <class T, std::size_t n> void take(std::array<T, n>& all) {
    for (T& each : all) take(each);
  }
  template <int n> void take(Components<n>& components) { take(components.along); }
  void take(Vec2& v) { (*this)(v.x, v.y); }

  void take(Wall& wall) { (*this)(wall.position, wall.velocity, wall.force, wall.shear_force); }
  void take(WallBody& w) {
    auto state = static_cast<std::uint8_t>((w.rough ? 1 : 0) | (w.open ? 2 : 0));
    (*this)(w.drive.kind, w.drive.value, w.mass, w.impedance, w.sample_mass, w.drift, w.rate, w.acceleration, w.higher,
            w.drive.slide, w.slid, state);
    w.rough = (state & 1) != 0;
    w.open = (state & 2) != 0;
  }
  void take(std::vector<Boundary>& boundaries) {
    for (Boundary& b : boundaries) (*this)(b.points, b.present, b.velocity, b.centre, b.force, b.spin, b.torque);
  }
  void take(std::vector<BoundaryBody>& bodies) {
    for (BoundaryBody& body : bodies)
      if (body.mass > 0) (*this)(body.force, body.rate);
  }
  void take(Energies& e) {
    for (const EnergyTerm& term : energy_terms) take(e.*term.value);
  }
  void take(WorkTerms& w) {
    for (const auto term : work_terms) take(w.*term);
  }

  /// What bonds remember and how they ended; what they hold now follows. Column by column, for a record may have gaps.
  void take(std::vector<Bond>& bonds) {
    auto count = static_cast<std::uint64_t>(bonds.size());
    take(count);
    if constexpr (std::is_same_v<Archive, ByteReader>) {
      if (count > archive_.left() / sizeof(double)) ByteReader::fail();
      bonds.resize(count);
    }
    for (Bond& b : bonds)
      (*this)(b.i, b.j, b.broken, b.length, b.normal, b.angle_i, b.angle_j, b.energy, b.load, b.time, b.place);
  }

  void take(Sample& s) {
    (*this)(s.mass_scaling, s.inertial_number, s.step, s.lag, s.friction, s.wall_friction, s.drag, s.gravity, s.glue,
            s.settled, s.balance.open);
    (*this)(s.domain.wall, s.domain.tilt, s.listed_domain.wall, s.listed_domain.tilt);
    (*this)(s.skin, s.builds, s.shear_rate, s.sheared, s.listed_sheared, s.held, s.wall);
    apply_open(s);
    (*this)(s.domain.boundaries, s.listed_domain.boundaries, s.boundary);
    (*this)(s.velocity, s.omega, s.angle, s.acceleration, s.alpha, s.listed, s.higher, s.live_bonds);
    if (!s.part.empty()) (*this)(s.body, s.part);
    (*this)(s.tally, s.balance.known, s.balance.powers);
  }

  /// The slots' contents; their number follows from the list.
  void take(ContactList& list) {
    (*this)(list.strength, list.memory);
    for (auto* memory : {&list.normal_memory, &list.rolling_memory, &list.pull})
      if (!memory->empty()) take(*memory);
    (*this)(list.force, list.bond);
  }

  Archive& archive_;
};

/// Bonds that broke since the list was built keep their places in it.
std::vector<std::int32_t> broken_in_list(const Sample& s) {
  std::vector<std::int32_t> bonds;
  for (const BondSlot& b : s.bond_slots)
    if (b.state == BondSlot::State::broken) bonds.push_back(b.bond);
  return bonds;
}

void check_bonds(const Sample& s, const std::vector<std::int32_t>& broken) {
  for (const Bond& b : s.bonds)
    if (b.i < 0 || b.j < 0 || static_cast<std::size_t>(std::max(b.i, b.j)) >= s.count) ByteReader::fail();
  for (const std::int32_t b : broken)
    if (b < 0 || static_cast<std::size_t>(b) >= s.bonds.size()) ByteReader::fail();
}

void check_sizes(const Sample& s, const Sample& wanted) {
  bool alike = s.record.size() == s.count && s.alpha.size() == s.count && s.listed.along[0].size() == s.count &&
               s.body.size() == wanted.body.size() && s.part.size() == wanted.part.size();
  for (std::size_t b = 0; b < s.domain.boundaries.size(); ++b)
    for (const Domain* domain : {&s.domain, &s.listed_domain})
      alike = alike && domain->boundaries[b].points.size() == wanted.domain.boundaries[b].points.size();
  if (!alike) ByteReader::fail();
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

}  // namespace

std::vector<std::uint8_t> save_sample(const Sample& sample) {
  ByteWriter write;
  Members members(write);
  auto& s = const_cast<Sample&>(sample);  // the writer does not change what it is given
  const bool shortened = s.dt != s.dt_at_start, bonded = !s.bonds.empty();
  std::array<std::uint64_t, 3> header{mark(shortened, bonded), s.count, 0};
  std::memcpy(&header[2], &s.dt_at_start, sizeof s.dt_at_start);
  members(header);
  std::vector<std::int32_t> broken = broken_in_list(s);
  std::vector<DiskRecord> disks(s.record.begin(), s.record.begin() + static_cast<std::ptrdiff_t>(s.count));
  if (shortened) members(s.dt, s.steps_before, s.time_before);
  if (bonded) members(s.bonds, broken);
  members(disks, s, s.list);
  return std::move(write.bytes);
}

void restore_sample(Sample& sample, const std::vector<std::uint8_t>& bytes) {
  ByteReader read(bytes);
  Members members(read);
  Sample s = sample;
  std::array<std::uint64_t, 3> header{};
  std::uint64_t step = 0;
  members(header);
  std::memcpy(&step, &s.dt_at_start, sizeof step);
  const bool bonded = header[0] == mark(false, true) || header[0] == mark(true, true),
             shortened = header[0] == mark(true, bonded);
  if (header[0] != mark(shortened, bonded)) ByteReader::fail();
  if (header[1] != s.count || header[2] != step)
    throw InputError("the stored state belongs to another sample or time step (" + std::to_string(header[1]) +
                     " grains; here " + std::to_string(s.count) + ")");
  std::vector<std::int32_t> broken;
  s.bonds.clear();
  if (shortened) members(s.dt, s.steps_before, s.time_before);
  if (bonded) members(s.bonds, broken);
  check_bonds(s, broken);
  members(s.record, s);
  check_sizes(s, sample);
  s.laws = laws_between_steps(s);

  // The list as it was built: disks and container put back to where they were then.
  const std::vector<DiskRecord> disks = s.record;
  const Domain domain = s.domain;
  s.domain = s.listed_domain;
  for (std::size_t k = 0; k < s.count; ++k) s.record[k].place = s.listed[k];
  number_held(s);
  list_with_bonds(s, broken);
  const std::size_t slots = s.list.size(), pulls = s.list.pull.size();
  members(s.list);
  if (s.list.force.size() != slots + 1 + s.bond_slots.size() || s.list.memory.size() != slots ||
      s.list.pull.size() != pulls || !read.at_end())
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
