#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// A rigid grain of several disks, which go where it goes.
struct Body {
  std::int32_t first = 0, count = 0;  ///< its disks, by their place in Sample::start
  std::int64_t filled = 0;            ///< see Shapes; a whole number of words, for a state is told by its bytes
  double gyration = 0, mass = 0;      ///< m, kg
  Vec2 place;                         ///< of the centre of mass
  double angle = 0;
  Motion<2> own, seen;  ///< integrated velocities, less the affine motion of a periodic cell; those that the forces see
  double inertia() const { return mass * gyration * gyration; }
};

/// A disk of a body, or one for itself.
struct BodyDisk {
  std::int32_t grain = 0, body = -1;  ///< the caller's index; -1 for a grain that is a disk
  Vec2 place;                         ///< from the centre of mass where the body's angle is 0, m
  Cells<2> shift;                     ///< between the disk and its body's centre
};

/// Where a disk may touch a polygon: the point of the polygon's core nearest to the disk's centre, seen as a disk of
/// the polygon's rounding that goes with it. Its record stands behind those of the ghosts, and its slot joins the disk
/// with it. Each corner meets the other polygon by itself, so the energy is a sum over corners of squared distances
/// from convex cores, and the force runs on without a jump from a side over a corner. A boundary's point that juts out
/// has a foot, too, like a corner without radius.
struct Foot {
  std::int32_t touches = 0, body = 0;  ///< inner number of the disk, or boundary_partner of the point; the polygon
  Cells<2> shift;                      ///< from the body's centre to the image that is meant
  Vec2 lever;                          ///< from the body's centre, m
};

/// Rigid grains of several disks. The disks are in the list of contacts like any others, but not with those of their
/// own body; the forces on them move the body, and it moves them.
struct Bodies : PartOf<2> {
  Grains caller;  ///< the caller's grains, where some are no disks: `start` then has their disks, and "grain" within
                  ///< means a disk
  std::vector<Body> body;
  std::vector<BodyDisk> part;      ///< by disk of `start`; empty where all grains are disks
  std::vector<std::int32_t> disk;  ///< the disks' inner numbers; renewed with the list
  std::vector<Vec2> lever;         ///< by inner number: from the centre of a disk's body to its own; empty like `part`
  std::vector<Foot> foot, point_foot;  ///< of disks and of boundaries' points; records of the latter are the last ones

  static void check(Problems& problems, const Packing& start, const ContactParameters& contact,
                    const IntegrationParameters& integration);
  void make(Sample& sample, const Packing& given);
  /// In which no body meets itself, or another twice over its sides.
  double least_cell(const Sample& sample) const;
  void wrap(Sample& sample);
  void number(Sample& sample);
  void list_pairs(Sample& sample, const ThreadPool& pool);
  void list_others(Sample& sample);
  /// Disks of one body do not meet, nor do corners of polygons, which feet stand for.
  bool lets_meet(const Sample& sample, std::int32_t i, std::int32_t j) const {
    return part.empty() || can_meet(sample, i, j);
  }
  bool is_foot(const Sample& sample, std::size_t slot) const { return foot_of(sample, slot) != nullptr; }
  void refresh(Sample& sample);
  /// Adds to the slots of feet the torques that their forces have about the disks that take them.
  void add_forces(Sample& sample, const ThreadPool& pool);
  void raise_rates(const Sample& sample, const SlopesOf<2>& slopes, Rates& rates) const;
  double shortest_time(const Sample& sample, const std::function<double(double)>& tangent) const;
  /// A step of all bodies: forces on their disks at the start of the step take them and their disks to its end.
  bool follow(Sample& sample, const SweepTask<2>& task, const ThreadPool& pool);
  bool moves_all_disks(const Sample& sample) const;
  void note_present(const Sample& sample);
  void go_to_present(Sample& sample, const Domain& now);
  void shear(Sample& sample, const std::function<double(double)>& faster_at);
  /// Gives the bodies the mass that their disks' records have: a record's is that of all that its contacts move.
  void take_masses(const Sample& sample);

  const Grains* given() const { return part.empty() ? nullptr : &caller; }
  std::int32_t body_of(std::int32_t of) const { return part.empty() ? -1 : part[of].body; }
  std::int32_t grain_of(std::int32_t of) const { return part.empty() ? of : part[of].grain; }
  std::size_t bodies() const { return body.size(); }
  void put_mover(std::size_t of, Mover<2>& mover) const;
  void put_load(const Sample& sample, std::size_t of, Load<2>& load) const;
  void put_levers(const Sample& sample, std::size_t slot, Levers<2>& levers) const {
    if (!part.empty()) levers = levers_at(sample, slot);
  }
  void report_contact(const Sample& sample, std::size_t slot, bool swapped, Packing& out) const;
  template <class Members> void transfer(Sample& /*sample*/, Members& members) {
    if (part.empty()) return;
    const std::size_t bodies = body.size(), disks = part.size();
    members(body, part);
    members.expect(body.size() == bodies && part.size() == disks);
  }

  /// The foot of a slot that joins a disk, or a boundary's point, with a polygon; null of any other.
  const Foot* foot_of(const Sample& sample, std::size_t slot) const;

 private:
  std::vector<Motion<2>> present;  ///< of the bodies, between note_present and go_to_present

  bool can_meet(const Sample& sample, std::int32_t i, std::int32_t j) const;
  Levers<2> levers_at(const Sample& sample, std::size_t slot) const;
};

/// Puts the disks of all bodies where these are, with their velocity.
void place_parts(Sample& sample);

/// Rows of periodic cells from the centre of i's grain to that of j's.
int rows_between(const Sample& sample, std::size_t slot);

/// Torques of a slot on i and j about the points that the levers lead to, N m.
struct Torques {
  double i = 0, j = 0;
};
Torques own_torques(const Sample& sample, std::size_t slot);

}  // namespace arenite::dem
