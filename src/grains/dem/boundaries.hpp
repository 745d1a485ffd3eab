#pragma once
#include <vector>

#include "core/problems.hpp"
#include "grains/dem/sample.hpp"

// Boundaries of straight segments that move as they are told. A contact with one is a slot like a wall's, joined with an element: a point or a segment.
namespace arenite::dem {

/// What disks can touch of the domain's boundaries, in the order of their numbers.
std::vector<Element> elements_of(const Domain& domain);

/// Finds boundaries that make no sense: too few points, points that coincide, a periodic frame.
void check_boundaries(Problems& problems, const Domain& domain);

/// Elements of present boundaries nearer to a disk's rim than the skin.
class NearElements {
 public:
  explicit NearElements(const Sample& sample);
  /// In the order of their numbers.
  void find(const DiskRecord& disk, std::vector<std::int32_t>& near) const;

 private:
  struct Box {
    Vec2 low, high;
  };
  const Sample& sample_;
  std::vector<Box> box_;  ///< around each boundary
};

/// Moves and turns the boundaries by a time, s.
void move_boundaries(Domain& domain, double time);

/// The farthest way of a point of the boundaries between two states, m.
double farthest_moved(const Domain& then, const Domain& now);

/// Speed of the fastest point of the boundaries, m/s.
double fastest_point(const Domain& domain);

/// A disk that rolls from a segment over a corner goes on with the springs that it has: the contact that begins takes them from its neighbour along
/// the boundary that ends.
void hand_over_memories(Sample& sample);

/// Throws CannotGoOn, naming grain, boundary and step, if the centre of a listed disk has gone through a segment since the list was built.
void check_crossings(const Sample& sample);

/// Forces of the grains on the boundaries, and their torques about the centres.
void sum_boundary_forces(Sample& sample);

/// Walls are absent where they are open, else as they were given.
void apply_open(Sample& sample);

/// The boundary of a partner j < wall_partner(top).
inline std::size_t boundary_index(const Sample& s, std::int32_t j) { return static_cast<std::size_t>(s.element[static_cast<std::size_t>(-5 - j)].boundary); }
inline const Boundary& boundary_of(const Sample& s, std::int32_t j) { return s.domain.boundaries[boundary_index(s, j)]; }

}  // namespace arenite::dem
