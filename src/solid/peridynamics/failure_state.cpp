// How a test hands out its state, as a value and as bytes, and takes it back.
#include <tuple>
#include <utility>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/failure.hpp"

namespace arenite::peridynamics {
namespace {

constexpr std::uint64_t mark = 0x32302d6c6c75702d;  // "-pull-02"; changes with what `transfer` lists

template <class Archive> void transfer(Archive& a, DamageState& s) {
  std::uint64_t broken = s.broken;
  for (double* v : {&s.strain, &s.stress, &s.work, &s.elastic, &s.released, &s.bond_energy}) a(*v);
  a(broken);
  s.broken = broken;
}

template <class Archive> void transfer(Archive& a, BrokenBond& b) {
  a(b.x), a(b.y), a(b.direction), a(b.type), a(b.strain);
}

void resize(ByteWriter&, std::uint64_t, const auto&) {}
template <class T> void resize(ByteReader& read, std::uint64_t size, std::vector<T>& list) {
  if (size > read.left()) ByteReader::fail();
  list.resize(size);
}

template <class Archive, class T> void transfer(Archive& a, std::vector<T>& list) {
  std::uint64_t size = list.size();
  a(size);
  resize(a, size, list);
  for (T& each : list) transfer(a, each);
}

/// One list of members for both ways.
template <class Archive> void transfer(Archive& a, FailureState& s) {
  a(s.width), a(s.height), a(s.rounds);
  for (int* count : {&s.solves, &s.iterations}) {
    std::int64_t wide = *count;
    a(wide);
    *count = static_cast<int>(wide);
  }
  for (auto* words : {&s.words, &s.parted, &s.words_at_setup, &s.strongest_words}) a(*words);
  for (auto* u : {&s.u.x, &s.u.y, &s.strongest_u.x, &s.strongest_u.y}) a(*u);
  for (double* v : {&s.strength, &s.modulus, &s.energy_defect, &s.share, &s.strongest_strain}) a(*v);
  transfer(a, s.now);
  transfer(a, s.curve);
  transfer(a, s.broken);
}

auto changed_by_solve(auto& s) {
  return std::tie(s.words, s.parted, s.words_at_setup, s.u, s.solves, s.iterations, s.share);
}

bool fits(const FailureState& s, const PhaseMap& map, std::size_t padded, bool closes) {
  if (s.parted.size() != (closes ? padded : 0)) return false;
  for (const std::size_t size : {s.words.size(), s.words_at_setup.size(), s.u.x.size(), s.u.y.size()})
    if (size != padded) return false;
  const std::size_t strongest = s.strength > 0 ? padded : 0;
  for (const std::size_t size : {s.strongest_words.size(), s.strongest_u.x.size(), s.strongest_u.y.size()})
    if (size != strongest) return false;
  return s.width == map.width && s.height == map.height;
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const FailureState& state) {
  ByteWriter write;
  write(mark);
  transfer(write, const_cast<FailureState&>(state));  // the writer does not change what it is given
  return std::move(write.bytes);
}

FailureState failure_state_of(const std::vector<std::uint8_t>& bytes) {
  ByteReader read(bytes);
  std::uint64_t first = 0;
  read(first);
  if (first != mark) ByteReader::fail();
  FailureState state;
  transfer(read, state);
  if (!read.at_end()) ByteReader::fail();
  return state;
}

/// Notes what the solve of a round changes, where somebody may ask for the state before it.
void FailureTest::hold() {
  if (!options_.keep) return;
  changed_by_solve(before_) = changed_by_solve(state_);
  before_.words = bonds_.words;
}

FailureState FailureTest::state() const {
  FailureState s = state_;  // this round's solve will be done again
  changed_by_solve(s) = changed_by_solve(before_);
  return s;
}

void FailureTest::resume(const FailureState& s) {
  if (!fits(s, map_, bonds_.words.size(), closes_))
    throw InputError(
        "the stored state of a test belongs to a phase map of another size; run the load again from its start");
  state_ = s;
  bonds_.words = s.words;
  // The set-up lags behind the bonds: it is that of the bonds that it was once made for.
  resisting_.words = s.words_at_setup;
  classify_groups(resisting_, 0, map_.height - 1);
  auto aggregates = cut_into_aggregates(map_, resisting_, prescribed_);
  Buffer<Tie> tie;
  if (prune(resisting_, aggregates, prescribed_, tie).carrying == 0)
    throw InputError("in the stored state of a test the clamps are not connected; run the load again from its start");
  solver_.emplace(resisting_, std::move(aggregates), prescribed_);
}

}  // namespace arenite::peridynamics
