#include "grains/dem/save.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/walls.hpp"

namespace arenite {

template <int D>
inline constexpr bool without_gaps<dem::HeldGrainIn<D>> = sizeof(dem::HeldGrainIn<D>) ==
                                                          2 * sizeof(std::int32_t) + sizeof(Vec<D>);
template <> inline constexpr bool without_gaps<dem::Body> = sizeof(dem::Body) == 13 * sizeof(double);
template <>
inline constexpr bool without_gaps<dem::BodyDisk> = sizeof(dem::BodyDisk) ==
                                                    2 * sizeof(std::int32_t) + sizeof(Vec2) + sizeof(Cells<2>);
template <> inline constexpr bool without_gaps<geometry::Rotation> = sizeof(geometry::Rotation) == 4 * sizeof(double);

namespace dem {
namespace {

/// "a-dem-", in space "b-dem-", and the version of a state; changes with what `Members` and the parts list.
template <int D> constexpr std::uint64_t version = D == 2 ? 0x3530 : 0x3730;
template <int D> constexpr std::uint64_t family = 0x2d6d65642d61 + (D - 2);
template <int D> constexpr std::uint64_t mark = family<D> | version<D> << 48;
/// Of a state that has its grains and what came and went: "x" and the version's last digit.
template <int D> constexpr std::uint64_t mark_with_grains = family<D> | ((version<D> & 0xff00) | 0x78) << 48;

/// Takes members to an archive or from it, one after another, so that one list of them serves both ways.
template <class Archive> class Members {
 public:
  explicit Members(Archive& archive) : archive_(archive) {}
  template <class... Member> void operator()(Member&... member) { (take(member), ...); }
  static constexpr bool reads() { return std::is_same_v<Archive, ByteReader>; }
  /// What is read must be so.
  static void expect(bool sound) {
    if (reads() && !sound) ByteReader::fail();
  }

 private:
  std::size_t left() const {
    if constexpr (reads()) return archive_.left();
    else return 0;
  }

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
  void take(Vec3& v) { (*this)(v.x, v.y, v.z); }

  template <int D> void take(GrainRecord<D>& r) {
    (*this)(r.place, r.velocity, r.omega, r.radius, r.mass, r.material, r.grain);
  }
  template <int D> void take(SlotForce<D>& f) { (*this)(f.on_i, f.torque_i, f.torque_j); }
  template <class Record> void take_count(std::vector<Record>& records) {
    auto count = static_cast<std::uint64_t>(records.size());
    take(count);
    if (!reads()) return;
    expect(count <= left() / sizeof(double));
    records.resize(count);
  }
  template <class Record> void take_all(std::vector<Record>& records) {
    take_count(records);
    for (Record& each : records) take(each);
  }
  template <int D> void take(std::vector<GrainRecord<D>>& records) { take_all(records); }
  template <int D> void take(std::vector<SlotForce<D>>& forces) { take_all(forces); }

  template <int D> void take(WallIn<D>& wall) { (*this)(wall.position, wall.velocity, wall.force, wall.shear_force); }
  template <int D> void take(WallBodyIn<D>& w) {
    auto state = static_cast<std::uint8_t>((w.rough ? 1 : 0) | (w.open ? 2 : 0) | (w.skin ? 4 : 0));
    (*this)(w.drive.kind, w.drive.value, w.mass, w.impedance, w.sample_mass, w.drift, w.rate, w.acceleration, w.higher,
            w.drive.slide, w.slid, state);
    w.rough = (state & 1) != 0;
    w.open = (state & 2) != 0;
    w.skin = (state & 4) != 0;
  }
  void take(Energies& e) {
    for (const EnergyTerm& term : energy_terms) take(e.*term.value);
  }
  /// What bonds remember and how they ended; what they hold now follows. Column by column, for a record may have gaps.
  template <int D> void take(std::vector<BondIn<D>>& bonds) {
    take_count(bonds);
    for (BondIn<D>& b : bonds)
      (*this)(b.i, b.j, b.broken, b.length, b.normal, b.angle_i, b.angle_j, b.energy, b.load, b.time, b.place);
  }

  /// When the list was made, which decides on its skin; that of disks is always the same.
  void take_listed_step(Sample& /*sample*/) {}
  void take_listed_step(SampleIn<3>& s) { take(s.listed_step); }

  template <int D> void take(SampleIn<D>& s) {
    (*this)(s.dt, s.steps_before, s.time_before);
    (*this)(s.mass_scaling, s.inertial_number, s.step, s.lag, s.friction, s.wall_friction, s.drag, s.gravity, s.glue,
            s.settled);
    (*this)(s.domain.wall, s.domain.tilt, s.listed_domain.wall, s.listed_domain.tilt);
    (*this)(s.skin, s.builds, s.shear_rate, s.sheared, s.listed_sheared, s.wall);
    take_listed_step(s);
    apply_open(s);
    (*this)(s.velocity, s.omega, s.angle, s.acceleration, s.alpha, s.listed, s.higher, s.glued_pairs, s.tally);
    each_part(s, [&](auto& part) { part.transfer(s, *this); });
  }

  void take(Batch& batch) { (*this)(batch.grains, batch.mass); }
  void take(ExchangeAccount& account) {
    (*this)(account.next_id, account.first_id, account.tries, account.inserted, account.removed, account.waiting);
    take_all(account.through);
  }

  /// The slots' contents; their number follows from the list.
  template <int D> void take(ContactListIn<D>& list) {
    (*this)(list.strength, list.memory);
    if (!list.normal_memory.empty()) take(list.normal_memory);
    if (!list.rolling_memory.empty()) take(list.rolling_memory);
    if (!list.twist_memory.empty()) take(list.twist_memory);
    (*this)(list.force, list.glue);
  }

  Archive& archive_;
};

/// Grains that are no longer those which the sample was made of, and the account of that.
template <class Archive, int D> void transfer_grains(Members<Archive>& members, SampleIn<D>& s) {
  GrainsIn<D>& g = s.start.grains;
  members(g.id, g.position, g.radius, g.material, g.zone, s.largest_radius, s.exchanged, s.tally.exchanged);
  if (!members.reads()) return;
  const std::size_t n = g.id.size();
  members.expect(n > 0 && g.position.size() == n && g.radius.size() == n && g.material.size() == n &&
                 g.zone.size() == n);
  g.resize(n);
  s.count = n;
  s.exchanged.kept = true;
}

}  // namespace

template <int D> std::vector<std::uint8_t> save_sample(const SampleIn<D>& sample) {
  ByteWriter write;
  Members members(write);
  auto& s = const_cast<SampleIn<D>&>(sample);  // the writer does not change what it is given
  std::array<std::uint64_t, 3> header{s.exchanged.kept ? mark_with_grains<D> : mark<D>, s.count, 0};
  std::memcpy(&header[2], &s.dt_at_start, sizeof s.dt_at_start);
  std::vector<GrainRecord<D>> disks(s.record.begin(), s.record.begin() + static_cast<std::ptrdiff_t>(s.count));
  members(header);
  if (s.exchanged.kept) transfer_grains(members, s);
  members(disks, s, s.list);
  each_part(s, [&](auto& part) { part.transfer_listed(s, members); });
  return std::move(write.bytes);
}

template <int D> void restore_sample(SampleIn<D>& sample, const std::vector<std::uint8_t>& bytes) {
  ByteReader read(bytes);
  Members members(read);
  SampleIn<D> s = sample;
  std::array<std::uint64_t, 3> header{};
  std::uint64_t step = 0;
  members(header);
  std::memcpy(&step, &s.dt_at_start, sizeof step);
  members.expect((header[0] & 0xffffffffffff) == family<D>);
  const bool has_grains = header[0] == mark_with_grains<D>;
  if (header[0] != mark<D> && !has_grains)
    throw InputError(
        "the stored state was written by another version of the program; compute the stage that it "
        "belongs to again, in another folder");
  if (!has_grains && s.exchanged.kept)
    throw InputError("the stored state is one from before grains came in or left; restore it into a sample made anew");
  if (has_grains) transfer_grains(members, s);
  if (header[1] != s.count || header[2] != step)
    throw InputError("the stored state belongs to another sample or time step (" + std::to_string(header[1]) +
                     " grains; here " + std::to_string(s.count) + ")");
  members(s.record, s);
  members.expect(s.record.size() == s.count && s.alpha.size() == s.count && s.listed.along[0].size() == s.count);
  s.laws = laws_between_steps(s);

  // The list as it was built: disks and container put back to where they were then.
  const std::vector<GrainRecord<D>> disks = s.record;
  const DomainIn<D> domain = s.domain;
  s.domain = s.listed_domain;
  for (std::size_t k = 0; k < s.count; ++k) s.record[k].place = s.listed[k];
  list_contacts(s);
  const std::size_t slots = s.list.size(), forces = s.list.force.size();
  members(s.list);
  members.expect(s.list.force.size() == forces && s.list.memory.size() == slots);
  each_part(s, [&](auto& part) { part.transfer_listed(s, members); });
  members.expect(read.at_end());
  s.domain = domain;
  std::copy(disks.begin(), disks.end(), s.record.begin());
  refresh_ghosts(s);
  each_part(s, [&](auto& part) { part.go_on(s); });
  sample = std::move(s);
}

template <int D> std::uint64_t state_hash(const SampleIn<D>& sample) {
  const auto bytes = save_sample(sample);
  return XXH3_64bits(bytes.data(), bytes.size());
}

#define ARENITE_OF(D)                                                           \
  template std::vector<std::uint8_t> save_sample(const SampleIn<D>&);           \
  template void restore_sample(SampleIn<D>&, const std::vector<std::uint8_t>&); \
  template std::uint64_t state_hash(const SampleIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace dem
}  // namespace arenite
