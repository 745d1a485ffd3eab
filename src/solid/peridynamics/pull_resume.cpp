// How a pull hands out its state and takes it back.
#include <algorithm>

#include "core/error.hpp"
#include "solid/peridynamics/pull.hpp"

namespace arenite::peridynamics {

namespace {

template <class T>
void put(const Buffer<T>& from, std::vector<T>& to) {
  to.assign(from.data(), from.data() + from.size());
}

template <class T>
void put(const std::vector<T>& from, Buffer<T>& to) {
  std::copy_n(from.data(), from.size(), to.data());
}

bool fits(const PullState& s, const PhaseMap& map, std::size_t padded) {
  for (const std::size_t size : {s.words.size(), s.words_at_setup.size(), s.ux.size(), s.uy.size()})
    if (size != padded) return false;
  const std::size_t strongest = s.strength > 0 ? padded : 0;
  for (const std::size_t size : {s.strongest_words.size(), s.strongest_ux.size(), s.strongest_uy.size()})
    if (size != strongest) return false;
  return s.width == map.width && s.height == map.height;
}

}  // namespace

/// Notes what the solve of a round changes, where somebody may ask for the state before it.
void Pull::hold() {
  if (!options_.keep) return;
  held_.width = map_.width;
  held_.height = map_.height;
  held_.rounds = rounds_;
  held_.solves = result_.solves;
  held_.iterations = result_.iterations;
  held_.share = share_;
  put(bonds_.words, held_.words);
  put(words_at_setup_, held_.words_at_setup);
  put(u_.x, held_.ux);
  put(u_.y, held_.uy);
}

PullState Pull::state() const {
  PullState s = held_;
  s.now = now_;
  s.curve = result_.curve;
  s.broken = result_.broken;
  s.strength = result_.strength;
  s.modulus = result_.modulus;
  s.energy_defect = result_.energy_defect;
  put(strongest_.words, s.strongest_words);
  put(strongest_.u.x, s.strongest_ux);
  put(strongest_.u.y, s.strongest_uy);
  s.strongest_strain = strongest_.strain;
  return s;
}

void Pull::resume(const PullState& s) {
  if (!fits(s, map_, bonds_.words.size()))
    throw InputError("the stored state of a pull belongs to a phase map of another size; run the load again from its start");
  const auto take = [&](const std::vector<std::uint32_t>& words) {
    put(words, bonds_.words);
    classify_groups(bonds_, 0, map_.height - 1);
  };
  // The set-up lags behind the bonds: it is that of the bonds that it was once made for.
  take(s.words_at_setup);
  if (!prepare()) throw InputError("the stored state of a pull ties no clamps; run the load again from its start");
  take(s.words);
  put(s.ux, u_.x);
  put(s.uy, u_.y);
  rounds_ = s.rounds;
  result_.solves = static_cast<int>(s.solves);
  result_.iterations = static_cast<int>(s.iterations);
  share_ = s.share;
  now_ = s.now;
  result_.curve = s.curve;
  result_.broken = s.broken;
  result_.strength = s.strength;
  result_.modulus = s.modulus;
  result_.energy_defect = s.energy_defect;
  strongest_ = {Buffer<std::uint32_t>(s.strongest_words.size()), Field<double>(s.strongest_words.size()),
                s.strongest_strain};
  put(s.strongest_words, strongest_.words);
  put(s.strongest_ux, strongest_.u.x);
  put(s.strongest_uy, strongest_.u.y);
}

}  // namespace arenite::peridynamics
