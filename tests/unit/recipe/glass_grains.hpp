#pragma once
#include <string>

namespace arenite::recipe::testing {

inline const std::string glass_grains = R"([materials.glass]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[[populations]]
material = "glass"
count = 10
diameter = "5 mm"
)";

}  // namespace arenite::recipe::testing
