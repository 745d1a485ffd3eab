#pragma once
#include <vector>

#include "io/export/export.hpp"

namespace arenite::io {

/// As of disks: a file of grains and one of contacts a state, of a bonded sample also one of bonds and one of cracks,
/// and what joins them.
std::vector<NamedBytes> vtk_spheres(const ExportSpheres& from);

}  // namespace arenite::io
