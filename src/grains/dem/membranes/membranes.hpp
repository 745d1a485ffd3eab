#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/membranes/skin.hpp"
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A side that is a membrane: nodes from one platen to the other, the points of a boundary of the domain, which grains
/// touch as they touch any.
struct Membrane {
  int side = 0;
  Skin skin;
  double node_mass = 0;         ///< kg
  bool slides = false;          ///< its ends, along the platens
  double may_stretch = 1;       ///< strain beyond which it would tear
  double stretched = 0;         ///< the largest strain of a segment so far
  std::vector<Vec2> rate;       ///< of the nodes: integrated velocity, m/s (half a step behind under Verlet)
  std::vector<Vec2> velocity;   ///< that the forces see
  std::vector<Vec2> of_grains;  ///< forces of now, N: of the grains on the nodes,
  SkinForces own;               ///< and those of the skin, drag among what brakes
  std::size_t boundary = 0;     ///< its number among the domain's
  std::size_t first = 0;        ///< nodes of the membranes before it

  std::size_t nodes() const { return rate.size(); }
  /// Whether a node moves along an axis as forces have it, and not with its platen.
  bool is_free(std::size_t node, int axis) const {
    return (node > 0 && node + 1 < nodes()) || (slides && axis == axis_of(side));
  }
  Vec2 force(std::size_t node) const {
    return of_grains[node] + own.pressed[node] + own.pulled[node] + own.braked[node];
  }
};

/// What a slot touches of a membrane: a node, and how far on towards the next one.
struct TouchedSkin {
  const Membrane* of = nullptr;
  std::size_t node = 0, next = 0;
  double share = 0;
};

/// Membranes. While there is one, the plane of its side is where a straight wall would enclose the same area, and the
/// force on that side is what the grains do to the membrane.
struct Membranes : PartOf<2> {
  std::vector<Membrane> list;  ///< in the order of their boundaries, which stand behind all others

  /// That of a boundary, or on a side; nullptr where there is none.
  const Membrane* of_boundary(std::size_t boundary) const;
  const Membrane* on_side(int side) const;
  std::size_t nodes() const { return list.empty() ? 0 : list.back().first + list.back().nodes(); }

  void add_forces(Sample& sample, const ThreadPool& pool = ThreadPool());
  void add_to_walls(Sample& sample) const;
  void raise_rates(const Sample& sample, const SlopesOf<2>& slopes, Rates& rates) const;
  void kick(Sample& sample, double kick, double ahead);
  void move(Sample& sample, double time);
  void add_energy(const Sample& sample, Energies& energies) const;
  bool lets_drift(const Sample& sample, int axis) const;
  /// Integrated velocities are brought to the present.
  void note_present(const Sample& sample);
  template <class Members> void transfer(Sample& sample, Members& members) {
    auto count = static_cast<std::uint64_t>(list.size());
    if (is_any(sample)) members(count);
    else count = 0;
    if (members.reads()) make_room(sample, count);
    for (Membrane& m : list) {
      members(m.side, m.node_mass, m.slides, m.may_stretch, m.stretched);
      members(m.skin.stiffness, m.skin.rest, m.skin.pressure, m.skin.towards, m.skin.dashpot);
      members(m.rate, m.velocity, m.of_grains, m.own.pressed, m.own.pulled, m.own.braked);
      const std::size_t n = m.rate.size();
      members.expect(m.side >= 0 && m.side < sides && n > 2 && m.velocity.size() == n && m.of_grains.size() == n &&
                     m.own.pressed.size() == n && m.own.pulled.size() == n && m.own.braked.size() == n);
    }
    if (members.reads()) add_boundaries(sample);
  }

 private:
  static bool is_any(const Sample& sample);
  /// For a state that is read: so many membranes in the place of those of now; their boundaries, with no places yet.
  void make_room(Sample& sample, std::uint64_t count);
  void add_boundaries(Sample& sample);
};

TouchedSkin touched_skin(const Sample& sample, std::size_t slot, const Kinematics<2>& kinematics);

/// Velocity of a place on a segment of a membrane, m/s.
inline Vec2 velocity_at(const Membrane& m, std::size_t node, double share) {
  return share > 0 ? (1 - share) * m.velocity[node] + share * m.velocity[node + 1] : m.velocity[node];
}

/// Name of the boundary that a membrane on a side is.
std::string membrane_name(int side);

/// Mean normal forces across x and y, N: the sum over all that bears the grains along an axis of place times force,
/// over the extent. Where both sides are rigid it is the mean of their forces.
Vec2 mean_forces(const Sample& sample);

/// Pressures outside of the membranes from now on, Pa, by side; a side that gets one for the first time becomes a
/// membrane in the place of its wall, which must have been taken away (InputError where it cannot be one, or is to be
/// none any more).
void set_membranes(Sample& sample, const BySide<std::optional<double>>& pressure, const SkinParameters& of,
                   const ThreadPool& pool = ThreadPool());

/// The pressure outside of the membrane on a side from now on, Pa; the forces of now stay until they are found anew.
void press_membrane(Sample& sample, int side, double pressure);

}  // namespace arenite::dem
