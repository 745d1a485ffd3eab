#pragma once
#include <string>

namespace arenite::test {

inline const std::string spheres_of_glass = R"(title = "small sample of spheres"
seed = 3
dimension = 3
[materials.glass]
density = "2500 kg/m^3"
stiffness = "100 kN/m"
[packing]
grains = 150
[[populations]]
material = "glass"
ratio = 1
size = { law = "uniform", min = "3.5 mm", max = "4.5 mm" }
)";

/// Pressed without friction in a periodic cell: a run of half a second.
inline const std::string small_spheres = spheres_of_glass + R"([container]
width = "22 mm"
depth = "22 mm"
periodic_x = true
periodic_y = true
periodic_z = true
[contact]
friction = 0
[[stages]]
name = "compress"
right = { pressure = "10 kPa" }
top = { pressure = "10 kPa" }
front = { pressure = "10 kPa" }
)";

/// Pressed between six walls, and then by the top alone while the four sides keep their pressure.
inline const std::string small_triaxial = spheres_of_glass + R"([container]
width = "22 mm"
depth = "22 mm"
[contact]
friction = 0.4
wall_friction = 0
[[stages]]
name = "confine"
friction = 0
left = { pressure = "10 kPa" }
right = { pressure = "10 kPa" }
back = { pressure = "10 kPa" }
front = { pressure = "10 kPa" }
bottom = { pressure = "10 kPa" }
top = { pressure = "10 kPa" }
[[stages]]
name = "axial"
left = { pressure = "10 kPa" }
right = { pressure = "10 kPa" }
back = { pressure = "10 kPa" }
front = { pressure = "10 kPa" }
top = { velocity = "20 mm/s" }
duration = "0.06 s"
snapshots = 2
)";

}  // namespace arenite::test
