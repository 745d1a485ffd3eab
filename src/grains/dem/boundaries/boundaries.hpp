#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A boundary that has a mass moves under forces.
template <int D> struct BoundaryBodyIn {
  double mass = 0;  ///< kg; 0: it moves as it is told
  Vec<D> force;     ///< of the drive, N
  Vec<D> rate;      ///< integrated velocity, m/s (half a step behind under Verlet)
};
using BoundaryBody = BoundaryBodyIn<2>;

/// What a grain can touch of a boundary. The number of an element is its place among those of all boundaries
/// (Vessel::elements).
template <int D> struct ElementIn;
/// In the plane one of its points, or the segment from there to the next.
template <> struct ElementIn<2> {
  std::int32_t boundary = 0, point = 0;
  bool segment = false;
};
using Element = ElementIn<2>;
/// In space one of its faces.
template <> struct ElementIn<3> {
  std::int32_t boundary = 0, point = 0, corners = 0;  ///< the face's corners are so many points from that one on
  double seam = 0;                                    ///< places that are nearer to each other are one, m
  std::vector<std::int32_t> meeting;                  ///< elements of the same boundary that it meets
};

/// The smallest upright box around points.
template <int D> struct BoxAround { Vec<D> low, high; };

/// Rigid boundaries, of straight segments and in space of flat faces, that move as they are told or have a mass. A
/// contact with one is a slot like a wall's, joined with an element.
template <int D> struct BoundariesIn : PartOf<D> {
  std::vector<ElementIn<D>> element;    ///< of the domain's boundaries
  std::vector<BoundaryBodyIn<D>> body;  ///< by boundary
  std::vector<BoxAround<D>> box;        ///< around each as the list was built

  /// Refuses too few points, points that coincide, faces that are not flat and convex, what is longer than a periodic
  /// cell.
  static void check(Problems& problems, const PackingIn<D>& start, const ContactParameters& contact,
                    const IntegrationParameters& integration);
  void make(SampleIn<D>& sample, const PackingIn<D>& given);
  double way_since_listed(const SampleIn<D>& sample) const;
  /// Throws CannotGoOn, naming grain, boundary and step, if the centre of a listed grain has gone through one since the
  /// list was built.
  void check_list(const SampleIn<D>& sample) const;
  /// Puts boundaries whose middle has left a periodic cell back by whole cells.
  void wrap(SampleIn<D>& sample);
  void number(SampleIn<D>& sample);
  /// The elements of present boundaries nearer to a grain's rim than the skin, in the order of their numbers.
  void find_near(const SampleIn<D>& sample, std::size_t disk, std::vector<std::int32_t>& partners) const;
  /// A grain that rolls from one element over to the next goes on with the springs that it has: the contact that begins
  /// takes them from its neighbour along the boundary that ends.
  void before_forces(SampleIn<D>& sample);
  /// Forces of the grains on the boundaries, and their torques about the centres.
  void add_forces(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());
  bool meet(const SampleIn<D>& sample, std::size_t slot, Kinematics<D>& kinematics) const;
  Turning<D> spin_of(const SampleIn<D>& sample, std::int32_t partner) const;
  bool drives(const SampleIn<D>& sample) const;
  /// A step of Verlet of the boundaries with a mass.
  void kick(SampleIn<D>& sample, double kick, double ahead);
  void move(SampleIn<D>& sample, double time);
  void bring_to_now(const SampleIn<D>& sample, DomainIn<D>& domain) const;
  void go_to_present(SampleIn<D>& sample, const DomainIn<D>& now);
  double fastest_point(const SampleIn<D>& sample) const;
  void add_energy(const SampleIn<D>& sample, Energies& energies) const;
  template <class Members> void transfer(SampleIn<D>& sample, Members& members) {
    std::vector<std::size_t> points;
    each_of(sample, [&](const BoundaryIn<D>& boundary) { points.push_back(boundary.points.size()); });
    each_of(sample,
            [&](BoundaryIn<D>& b) { members(b.points, b.present, b.velocity, b.centre, b.force, b.spin, b.torque); });
    for (BoundaryBodyIn<D>& each : body)
      if (each.mass > 0) members(each.force, each.rate);
    std::size_t n = 0;
    each_of(sample, [&](const BoundaryIn<D>& boundary) { members.expect(boundary.points.size() == points[n++]); });
  }

 private:
  /// Those of now, then those as they were when the list was built.
  template <class S, class See> static void each_of(S& sample, const See& see) {
    for (auto* domain : {&sample.domain, &sample.listed_domain})
      for (BoundaryIn<D>& boundary : domain->boundaries) see(boundary);
  }
};
using Boundaries = BoundariesIn<2>;

/// Force on a boundary that has a mass, its weight included, N; its velocity now, m/s, of one that has none as it is
/// told.
template <int D> Vec<D> force_on(const SampleIn<D>& sample, std::size_t boundary);
template <int D> Vec<D> velocity_of(const SampleIn<D>& sample, std::size_t boundary);

}  // namespace arenite::dem
