#pragma once
#include <cstdint>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A boundary that has a mass moves under forces.
struct BoundaryBody {
  double mass = 0;  ///< kg; 0: it moves as it is told
  Vec2 force;       ///< of the drive, N
  Vec2 rate;        ///< integrated velocity, m/s (half a step behind under Verlet)
};

/// What a disk can touch of a boundary: one of its points, or the segment from there to the next. The number of an
/// element is its place among those of all boundaries (Domain::elements).
struct Element {
  std::int32_t boundary = 0, point = 0;
  bool segment = false;
};

/// Boundaries of straight segments that move as they are told. A contact with one is a slot like a wall's, joined with
/// an element: a point or a segment.
struct Boundaries : PartOf<2> {
  std::vector<Element> element;          ///< of the domain's boundaries
  std::vector<BoundaryBody> body;        ///< by boundary
  std::vector<geometry::Rectangle> box;  ///< around each as the list was built

  /// Refuses too few points, points that coincide, segments longer than a periodic cell.
  static void check(Problems& problems, const Packing& start, const ContactParameters& contact,
                    const IntegrationParameters& integration);
  void make(Sample& sample, const Packing& given);
  double way_since_listed(const Sample& sample) const;
  /// Throws CannotGoOn, naming grain, boundary and step, if the centre of a listed disk has gone through a segment
  /// since the list was built.
  void check_list(const Sample& sample) const;
  /// Puts boundaries whose middle has left a periodic cell back by whole cells.
  void wrap(Sample& sample);
  void number(Sample& sample);
  /// The elements of present boundaries nearer to a disk's rim than the skin, in the order of their numbers.
  void find_near(const Sample& sample, std::size_t disk, std::vector<std::int32_t>& partners) const;
  /// A disk that rolls from a segment over a corner goes on with the springs that it has: the contact that begins takes
  /// them from its neighbour along the boundary that ends.
  void before_forces(Sample& sample);
  /// Forces of the grains on the boundaries, and their torques about the centres.
  void add_forces(Sample& sample, const ThreadPool& pool = ThreadPool());
  bool meet(const Sample& sample, std::size_t slot, Kinematics<2>& kinematics) const;
  double spin_of(const Sample& sample, std::int32_t partner) const;
  bool drives(const Sample& sample) const;
  /// A step of Verlet of the boundaries with a mass.
  void kick(Sample& sample, double kick, double ahead);
  void move(Sample& sample, double time);
  void bring_to_now(const Sample& sample, Domain& domain) const;
  void go_to_present(Sample& sample, const Domain& now);
  double fastest_point(const Sample& sample) const;
  void add_energy(const Sample& sample, Energies& energies) const;
  template <class Members> void transfer(Sample& sample, Members& members) {
    std::vector<std::size_t> points;
    each_of(sample, [&](const Boundary& boundary) { points.push_back(boundary.points.size()); });
    each_of(sample,
            [&](Boundary& b) { members(b.points, b.present, b.velocity, b.centre, b.force, b.spin, b.torque); });
    for (BoundaryBody& each : body)
      if (each.mass > 0) members(each.force, each.rate);
    std::size_t n = 0;
    each_of(sample, [&](const Boundary& boundary) { members.expect(boundary.points.size() == points[n++]); });
  }

 private:
  /// Those of now, then those as they were when the list was built.
  template <class S, class See> static void each_of(S& sample, const See& see) {
    for (auto* domain : {&sample.domain, &sample.listed_domain})
      for (Boundary& boundary : domain->boundaries) see(boundary);
  }
};

/// Force on a boundary that has a mass, its weight included, N; its velocity now, m/s, of one that has none as it is
/// told.
Vec2 force_on(const Sample& sample, std::size_t boundary);
Vec2 velocity_of(const Sample& sample, std::size_t boundary);

/// Throws InputError for sides of a periodic cell that are driven, or sheared, where there are boundaries, which stay
/// as they are.
void check_still_cell(const Sample& sample, const WallDrives& drives, bool sheared);
inline void check_still_cell(const SampleIn<3>& /*sample*/, const WallDrivesIn<3>& /*drives*/, bool /*sheared*/) {}

/// How the domain's boundaries move from now on; InputError for a name that none has.
void set_boundaries(Sample& sample, const std::vector<BoundaryMotion>& motions, const ThreadPool& pool = ThreadPool());

}  // namespace arenite::dem
