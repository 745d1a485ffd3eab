#include "report/course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workflow/run.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::report {

namespace {

double signed_anisotropy(const texture::Texture& t, std::string_view name) {
  const auto* fabric = texture::find(t.fabric, name);
  return fabric ? fabric->a_c_signed.value : texture::unknown;
}

double value(const texture::ByName<texture::Estimate>& values, std::string_view name) {
  const auto* estimate = texture::find(values, name);
  return estimate ? estimate->value : texture::unknown;
}

CoursePoint point(const Frame& frame, const Domain& start, texture::Options options) {
  options.rev_sizes = options.rev_places = 1;
  const texture::Texture t = texture::measure(frame.packing, options);
  const Domain& now = frame.packing.domain;
  CoursePoint p;
  p.label = frame.label;
  p.time = frame.time;
  p.strain_x = 1 - now.width() / start.width();
  p.strain_y = 1 - now.height() / start.height();
  p.volume_strain = 1 - now.area() / start.area();
  p.pressure = t.stress.pressure;
  p.deviator = t.stress.deviator;
  p.ratio = p.deviator / p.pressure;
  p.solid_fraction = t.solid_fraction.value;
  p.coordination = value(t.coordination.mean, "all");
  p.bearing_coordination = value(t.coordination.mean, "all without rattlers");
  p.rattlers = t.coordination.rattlers.value;
  p.anisotropy = signed_anisotropy(t, "all");
  p.strong_anisotropy = signed_anisotropy(t, "strong");
  p.weak_anisotropy = signed_anisotropy(t, "weak");
  if (const auto* all = texture::find(t.force.compressive, "all")) p.strong_share = all->share_above.value;
  p.deviator_on_strong = t.stress.strong_deviator_share.value;
  p.mobilisation = frame.equilibrium.mobilisation;
  return p;
}

}  // namespace

std::vector<CoursePoint> course(const std::vector<StageResult>& stages) {
  std::vector<CoursePoint> points;
  const Frame* before = nullptr;
  for (const StageResult& stage : stages) {
    if (stage.frames.empty()) continue;
    const Domain& start = (before ? *before : stage.frames.front()).packing.domain;
    const texture::Options options = study::texture_options(stage.provenance);
    for (const Frame& frame : stage.frames) {
      points.push_back(point(frame, start, options));
      points.back().stage = stage.name;
    }
    before = &stage.frames.back();
  }
  return points;
}

}  // namespace arenite::report
