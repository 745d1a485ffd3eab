#pragma once
#include <string_view>

#include "core/problems.hpp"
#include "io/raw_sample.hpp"

namespace arenite::io {

/// Spheres written by YADE's export.text or export.textExt: "#format x_y_z_r" (or x_y_z_r_matId, x_y_z_r_attrs,
/// id_x_y_z_r_matId), then one sphere a line. The plane is x-y, or x-z or y-z where y or x is the same for all.
/// Without ids spheres are numbered from 0 in their order.
RawGrains read_yade_spheres(std::string_view text, const UnitFactors& units, Problems& problems);

/// Interactions written by YADE's VTKExporter.exportInteractions with what = {'normalForce': 'i.phys.normalForce',
/// 'shearForce': 'i.phys.shearForce'}: both centres of every interaction and the force on the second body. The file has
/// no ids, so ends are matched with the centres of `grains`; an end that is no grain's centre is a wall.
RawContacts read_yade_interactions(std::string_view text, const RawGrains& grains, const UnitFactors& units, Problems& problems);

}  // namespace arenite::io
