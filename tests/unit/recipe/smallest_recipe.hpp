#pragma once
#include <string>

namespace arenite::recipe {

/// All that a recipe must have.
inline const std::string smallest = R"([container]
width = "350 mm"
thickness = "60 mm"
[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"
[[populations]]
material = "POM"
count = 10
diameter = "16.4 mm"
[[stages]]
name = "load"
bottom = { force = "50 kN" }
)";

}  // namespace arenite::recipe
