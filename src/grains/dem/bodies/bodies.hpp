#pragma once
#include "core/problems.hpp"
#include "core/threads.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

// Rigid grains of several disks. The disks are in the list of contacts like any others, but not with those of their own body; the forces on them move
// the body, and it moves them.

void check_shapes(Problems& problems, const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration);

/// The packing with each disk of its grains as a grain; itself where all grains are disks. Contacts stay as they are.
Packing disks_of(const Packing& packing);

/// Fills `given`, `body` and `part` of a sample whose `start` is made by disks_of; nothing where all grains are disks.
void make_bodies(Sample& sample, const Grains& given);

/// The skin of the list by the sizes of the grains, m.
double skin_of_bodies(const Sample& sample);

/// The least side of a periodic cell in which no body meets itself, or another twice over its sides, m.
double cell_for_bodies(const Sample& sample);

/// Mass of a body by density, area and thickness, kg.
double own_mass_of(const Sample& sample, const Body& body);

/// Gives the bodies the mass that their disks' records have: a record's is that of all that its contacts move.
void take_masses(Sample& sample);

/// Finds the inner numbers of the disks.
void number_parts(Sample& sample);

/// Takes the pairs of one body's own disks and those with corners of polygons, which feet stand for, out of the partners of disk k, from `from` on.
void drop_own_disks(const Sample& sample, std::size_t k, std::vector<std::int32_t>& partner, std::size_t from);

/// Wraps the bodies' centres and their disks into a periodic cell.
void wrap_bodies(Sample& sample);

bool has_single_disks(const Sample& sample);

/// A step of all bodies: forces on their disks at the start of the step take them and their disks to its end. False if the list has become stale.
bool move_bodies(Sample& sample, const SweepTask& task, const ThreadPool& pool);

/// Puts the disks of all bodies where these are, with their velocity.
void place_parts(Sample& sample);

/// On a mover by its contacts.
Load load_on(const Sample& sample, std::size_t mover);

/// From the centre of the grain of j, or the wall, to that of i, where `branch` joins the disks, m.
Vec2 between_centres(const Sample& sample, std::size_t slot, Vec2 branch);

/// The places where disks may touch polygons, by disk.
std::vector<Foot> find_feet(const Sample& sample, const ThreadPool& pool);
/// Puts the feet's records where they are now.
void refresh_feet(Sample& sample);
/// The foot of a slot; null of any other.
const Foot* foot_of(const Sample& sample, std::size_t slot);
/// The points of boundaries that jut out towards polygons, with their feet. Throws InputError or CannotGoOn for a point that lies within a polygon.
std::vector<Foot> find_point_feet(const Sample& sample);
/// The foot of a slot that joins a polygon with a boundary's point; null of any other.
const Foot* point_foot_of(const Sample& sample, std::size_t slot);
/// Adds to the slots of feet the torques that their forces have about the disks that take them.
void take_torques_to_owners(Sample& sample, const ThreadPool& pool);
/// Rows of periodic cells from the centre of i's grain to that of j's.
int rows_between(const Sample& sample, std::size_t slot);

/// From the centre of i's body to where the slot's force begins, m; 0 of a disk that is a grain. Torque on i about that point, N m.
Vec2 own_lever(const Sample& sample, std::size_t slot);
double own_torque_i(const Sample& sample, std::size_t slot);

/// From the centre of j's body to where its force of a slot acts, m; 0 of a wall and of a disk that is a grain.
Vec2 partner_lever(const Sample& sample, std::size_t slot);

/// Torque of a slot on j about the point that partner_lever leads to, N m.
double own_torque_j(const Sample& sample, std::size_t slot);

/// The mover that inner disk k is, or is a part of.
std::size_t moving(const Sample& sample, std::int32_t k);

/// Contacts in six directions around each of a body's disks, less those within it, or of polygons that meet each side with a side of their own, two at
/// either end; and the sums of their squared levers along n and t, m^2.
struct Crowd {
  double contacts = 0, normal_levers = 0, tangential_levers = 0;
};
Crowd crowd_around(const Sample& sample, const Body& body);

/// The least mass that a contact of a body feels, its rotation included, kg.
double lightest_mass(const Sample& sample, const Body& body);

/// Gives a grain this place, angle and motion.
void put_grain(Grains& grains, std::size_t grain, Vec2 place, double angle, const Motion& motion);

/// Where the arms begin of the contact that was added last, which is the slot's, perhaps with i and j swapped.
void add_levers(const Sample& sample, std::size_t slot, bool swapped, Contacts& contacts);

/// Whether a contact of the caller's packing is the one of a slot that joins the same grains.
bool is_of_slot(const Sample& sample, const Contacts& contacts, std::size_t contact, std::size_t slot);

}  // namespace arenite::dem
