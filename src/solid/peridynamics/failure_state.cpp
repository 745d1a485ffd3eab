#include "solid/peridynamics/failure_state.hpp"

#include <utility>

#include "core/bytes.hpp"

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

}  // namespace arenite::peridynamics
