#pragma once
#include <string>
#include <vector>

#include "model/sphere_pack.hpp"
#include "model/voxel_map.hpp"
#include "solid/cement/cement.hpp"

namespace arenite::grid {

/// The voxels of a pack's box, at their middles, by phase and by grain: `voxels` of them along its longest side. Where
/// spheres overlap a voxel goes to the one with the smaller power distance (distance^2 - radius^2). Labels are places
/// in the pack; images carry those of their spheres. Throws InputError for a periodic box whose sides are no whole
/// numbers of voxels, and for no spheres.
VoxelMap rasterise_spheres(const SpherePack& pack, const SphereCement& cement, int voxels);

/// The same with the matrix that parameters ask for; a saturation is met by the width of bridges or menisci or the
/// thickness of a coating, to less than a voxel. `parameter` is what was used. Throws InputError where none reaches it.
VoxelMap cemented_voxels(const SpherePack& pack, cement::CementParameters parameters, int voxels, double& parameter);

/// Whether so many voxels along the longest side of a pack's box are whole numbers along the others.
bool is_whole_in_voxels(const SpherePack& pack, int voxels);

/// Cuts a box out of spheres: its lowest and its highest corner, m. Spheres around it stay, for what they hold may
/// reach into it. Throws InputError for a pack that repeats itself, whose box is its period, and where no sphere
/// reaches in.
void cut_out(SpherePack& pack, const std::vector<double>& box);

/// What is wrong where no voxel has the cement that was asked for; empty where some have.
std::string doubt_about_cement(const cement::CementParameters& parameters, const VoxelMap& map);

/// S_m: matrix over what is not grain; 0 where all is grain.
double saturation_of(const VoxelMap& map);

}  // namespace arenite::grid
