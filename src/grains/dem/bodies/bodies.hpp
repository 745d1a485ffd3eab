#pragma once
#include "core/problems.hpp"
#include "core/threads.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {

// Rigid grains of several disks. The disks are in the list of contacts like any others, but not with those of their own
// body; the forces on them move the body, and it moves them.

void check_shapes(Problems& problems, const Packing& start, const ContactParameters& contact,
                  const IntegrationParameters& integration);

/// The packing with each disk of its grains as a grain; itself where all grains are disks. Contacts stay as they are.
Packing disks_of(const Packing& packing);

/// Fills `given`, `body` and `part` of a sample whose `start` is made by disks_of; nothing where all grains are disks.
void make_bodies(Sample& sample, const Grains& given);

/// The least side of a periodic cell in which no body meets itself, or another twice over its sides, m.
double cell_for_bodies(const Sample& sample);

/// Mass of a disk of `start` that is a grain, or of the body that it belongs to, by density, area and thickness, kg.
double own_mass(const Sample& sample, std::int32_t disk);

/// Gives the bodies the mass that their disks' records have: a record's is that of all that its contacts move.
void take_masses(Sample& sample);

/// Finds the inner numbers of the disks.
void number_parts(Sample& sample);

/// Whether two inner disks can touch each other: they are not of one body, and none is a corner of a polygon, which
/// feet stand for.
bool disks_meet(const Sample& sample, std::int32_t i, std::int32_t j);

/// Wraps the bodies' centres and their disks into a periodic cell.
void wrap_bodies(Sample& sample);

bool has_single_disks(const Sample& sample);

/// A step of all bodies: forces on their disks at the start of the step take them and their disks to its end. False if
/// the list has become stale.
bool move_bodies(Sample& sample, const SweepTask<2>& task, const ThreadPool& pool);

/// Puts the disks of all bodies where these are, with their velocity.
void place_parts(Sample& sample);

/// From the centre of the grain of j, or the wall, to that of i, where `branch` joins the disks, m.
Vec2 between_centres(const Sample& sample, std::size_t slot, Vec2 branch);

/// The places where disks may touch polygons, by disk.
std::vector<Foot> find_feet(const Sample& sample, const ThreadPool& pool);
/// Puts the feet's records where they are now.
void refresh_feet(Sample& sample);
/// The points of boundaries that jut out towards polygons, with their feet. Throws InputError or CannotGoOn for a point
/// that lies within a polygon.
std::vector<Foot> find_point_feet(const Sample& sample);
/// The foot of a slot that joins a disk, or a boundary's point, with a polygon; null of any other.
const Foot* foot_of(const Sample& sample, std::size_t slot);
/// Adds to the slots of feet the torques that their forces have about the disks that take them.
void take_torques_to_owners(Sample& sample, const ThreadPool& pool);
/// Rows of periodic cells from the centre of i's grain to that of j's.
int rows_between(const Sample& sample, std::size_t slot);

/// From the centres of i's and j's bodies to where a slot's force acts on them, m; 0 of a wall and of a disk that is a
/// grain.
template <int D> struct Levers { Vec<D> i, j; };
Levers<2> levers_of(const Sample& sample, std::size_t slot);

/// Torques of a slot on i and j about the points that the levers lead to, N m.
struct Torques {
  double i = 0, j = 0;
};
Torques own_torques(const Sample& sample, std::size_t slot);

// In space there are none.
constexpr const Foot* foot_of(const SampleIn<3>& /*s*/, std::size_t /*slot*/) { return nullptr; }
constexpr Levers<3> levers_of(const SampleIn<3>& /*s*/, std::size_t /*slot*/) { return {}; }
constexpr Vec3 between_centres(const SampleIn<3>& /*s*/, std::size_t /*slot*/, Vec3 branch) { return branch; }

/// The mover that inner disk k is, or is a part of.
template <int D> std::size_t moving(const SampleIn<D>& s, std::int32_t k) {
  const std::int32_t body = body_of(s, s.record[k].grain);
  return body < 0 ? static_cast<std::size_t>(k) : s.count + static_cast<std::size_t>(body);
}

/// Contacts in six directions around each of a body's disks, less those within it, or of polygons that meet each side
/// with a side of their own, two at either end; and the sums of their squared levers along n and t, m^2.
struct Crowd {
  double contacts = 0, normal_levers = 0, tangential_levers = 0;
};
Crowd crowd_around(const Sample& sample, const Body& body);

/// The least mass that a contact of a body feels, its rotation included, kg.
double lightest_mass(const Sample& sample, const Body& body);

/// Gives a grain this place, angle and motion.
template <int D>
void put_grain(GrainsIn<D>& grains, std::size_t grain, Vec<D> place, Turning<D> angle, const Motion<D>& motion) {
  grains.position[grain] = place;
  grains.angle[grain] = angle;
  grains.velocity[grain] = motion.velocity;
  grains.omega[grain] = motion.omega;
}

/// Whether a contact of the caller's packing is the one of a slot that joins the same grains.
bool is_of_slot(const Sample& sample, const Contacts& contacts, std::size_t contact, std::size_t slot);

}  // namespace arenite::dem
