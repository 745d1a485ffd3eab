#pragma once
#include <vector>

#include "thermal/imaging/circles.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {

/// Marks the disks of a fitted model that the picture does not bear out: little contrast, little rim, not flat, a size
/// that makes up next to nothing (dirt), or on top of a better disk. With `strict` rims and flatness are also held
/// against those of the median disk by area, which tells a cluster of small grains from one large grain once most are
/// found.
std::vector<char> refuted_disks(const DiskModel& model, const CircleOptions& options, bool strict);

}  // namespace arenite::imaging
