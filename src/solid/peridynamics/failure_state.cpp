#include "solid/peridynamics/failure_state.hpp"

#include <utility>

#include "core/bytes.hpp"

namespace arenite::peridynamics {
namespace {

/// "-pull-03", and "-rend-01" in space; they change with what `transfer` lists.
template <int D> constexpr std::uint64_t mark = D == 2 ? 0x33302d6c6c75702d : 0x31302d646e65722d;

template <class Archive> void transfer(Archive& a, DamageState& s) {
  std::uint64_t broken = s.broken;
  for (double* v : {&s.strain, &s.stress, &s.work, &s.elastic, &s.released, &s.bond_energy}) a(*v);
  a(broken);
  s.broken = broken;
}

template <class Archive> void transfer(Archive& a, BrokenBond& b) {
  a(b.x), a(b.y), a(b.z), a(b.direction), a(b.type), a(b.strain);
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
template <class Archive, int D> void transfer(Archive& a, FailureStateIn<D>& s) {
  for (std::int32_t& n : s.size) a(n);
  a(s.rounds);
  for (int* count : {&s.solves, &s.iterations}) {
    std::int64_t wide = *count;
    a(wide);
    *count = static_cast<int>(wide);
  }
  for (auto* words : {&s.words, &s.parted, &s.words_at_setup, &s.strongest_words})
    for (auto& buffer : buffers(*words)) a(buffer);
  for (auto* u : {&s.u, &s.strongest_u})
    for (int axis = 0; axis < D; ++axis) a((*u)[axis]);
  for (double* v : {&s.strength, &s.modulus, &s.energy_defect, &s.share, &s.strongest_strain}) a(*v);
  transfer(a, s.now);
  transfer(a, s.curve);
  transfer(a, s.broken);
}

}  // namespace

template <int D> std::vector<std::uint8_t> to_bytes(const FailureStateIn<D>& state) {
  ByteWriter write;
  write(mark<D>);
  transfer(write, const_cast<FailureStateIn<D>&>(state));  // the writer does not change what it is given
  return std::move(write.bytes);
}

template <int D> FailureStateIn<D> failure_state_of(const std::vector<std::uint8_t>& bytes) {
  ByteReader read(bytes);
  std::uint64_t first = 0;
  read(first);
  if (first != mark<D>) ByteReader::fail();
  FailureStateIn<D> state;
  transfer(read, state);
  if (!read.at_end()) ByteReader::fail();
  return state;
}

#define ARENITE_OF(D)                                                    \
  template std::vector<std::uint8_t> to_bytes(const FailureStateIn<D>&); \
  template FailureStateIn<D> failure_state_of<D>(const std::vector<std::uint8_t>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::peridynamics
