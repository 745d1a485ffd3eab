#pragma once
#include <string>

namespace arenite::test {

/// 60 disks at random places; the table [packing] is left open.
inline const std::string small_packing_recipe = R"(title = "small sample"
seed = 3
[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"
[[populations]]
material = "POM"
count = 60
size = { law = "uniform", min = "10 mm", max = "16 mm" }
[container]
width = "100 mm"
thickness = "60 mm"
[packing]
method = "random"
)";

/// The same, loosely pressed, cemented and pulled on 64 x 64 nodes: a run of some hundredths of a second.
inline const std::string small_cemented_recipe = small_packing_recipe + R"(solid_fraction = 0.7
[contact]
friction_law = "cundall_strack"
[[stages]]
name = "prepare"
top = { force = "100 N" }
[cement]
kind = "bridges"
width = 0.3
[grid]
nodes = 64
[[loads]]
name = "tension"
)";

/// Two packings under three widths of bridges.
inline const std::string small_study = small_cemented_recipe + R"([sweep]
replicates = 2
[sweep.grid]
"cement.width" = [0.2, 0.3, 0.4]
)";

}  // namespace arenite::test
