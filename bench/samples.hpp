#pragma once
#include "grains/dem/engine.hpp"

namespace arenite::bench {

/// The case of the comparison with LAMMPS: radii 4 to 8 mm, one material, linear law, mu = 0.3, coordination about 4.
dem::ContactParameters contact_parameters();

/// Bonds that never break, between all grains less than a twentieth of their mean radius apart.
dem::ParallelBond bond();

/// 4000 disks between four walls, compacted by the engine at mu = 0 to P/k = 1e-3 and brought to rest with friction.
const Packing& walls_4000();

/// 4000 disks in a periodic cell, made in the same way.
const Packing& periodic_4000();

/// The periodic sample five by five times, 100 000 disks.
const Packing& periodic_100000();

/// 4000 grains in a periodic cell, two by two times a jammed one: two disks each, 1.4 times as long as wide; pentagons
/// with rounded corners.
const Packing& clumps_4000();
const Packing& polygons_4000();

/// 4000, 100 000 and 1 000 000 spheres, radii 4 to 8 mm, in a periodic cell: 1000 compacted at mu = 0.02 to P d/k =
/// 1e-3 and brought to rest with friction, two by two, five by five by four, and ten times along each axis.
const PackingIn<3>& spheres_4000();
const PackingIn<3>& spheres_100000();
const PackingIn<3>& spheres_1000000();

}  // namespace arenite::bench
