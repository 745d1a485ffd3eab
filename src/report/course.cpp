#include "report/course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "texture/texture.hpp"

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

CoursePoint point(const Frame& frame, const Domain& start) {
  texture::Options options;
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
  p.rattlers = t.coordination.rattlers.value;
  p.anisotropy = signed_anisotropy(t, "all");
  p.strong_anisotropy = signed_anisotropy(t, "strong");
  p.weak_anisotropy = signed_anisotropy(t, "weak");
  if (const auto* all = texture::find(t.force.compressive, "all")) p.strong_share = all->share_above.value;
  p.deviator_on_strong = t.stress.strong_deviator_share.value;
  p.mobilisation = frame.equilibrium.mobilisation;
  return p;
}

struct Column {
  const char* name;
  const char* unit;
  double CoursePoint::*member;
};

constexpr Column columns[] = {
    {"time", "s", &CoursePoint::time},
    {"strain_x", "1", &CoursePoint::strain_x},
    {"strain_y", "1", &CoursePoint::strain_y},
    {"volume_strain", "1", &CoursePoint::volume_strain},
    {"p", "Pa", &CoursePoint::pressure},
    {"q", "Pa", &CoursePoint::deviator},
    {"q_over_p", "1", &CoursePoint::ratio},
    {"solid_fraction", "1", &CoursePoint::solid_fraction},
    {"z", "1", &CoursePoint::coordination},
    {"rattlers", "1", &CoursePoint::rattlers},
    {"a_c", "1", &CoursePoint::anisotropy},
    {"a_c_strong", "1", &CoursePoint::strong_anisotropy},
    {"a_c_weak", "1", &CoursePoint::weak_anisotropy},
    {"strong_share", "1", &CoursePoint::strong_share},
    {"q_on_strong", "1", &CoursePoint::deviator_on_strong},
    {"mobilisation", "1", &CoursePoint::mobilisation},
};

}  // namespace

std::vector<CoursePoint> course(const std::vector<StageResult>& stages) {
  std::vector<CoursePoint> points;
  const Frame* before = nullptr;
  for (const StageResult& stage : stages) {
    if (stage.frames.empty()) continue;
    const Domain& start = (before ? *before : stage.frames.front()).packing.domain;
    for (const Frame& frame : stage.frames) {
      points.push_back(point(frame, start));
      points.back().stage = stage.name;
    }
    before = &stage.frames.back();
  }
  return points;
}

std::string course_csv(const std::filesystem::path& result) {
  std::vector<StageResult> stages;
  for (const auto& file : io::stage_files(result))
    if (io::sealed_kind(file) != "field") stages.push_back(io::read_stage(file));
  if (stages.empty()) throw InputError(result.string(), 0, "holds fields on nodes, which have no course; leave out --states");
  std::string names = "stage,label", units = ",";
  for (const Column& column : columns) {
    names += fmt::format(",{}", column.name);
    units += fmt::format(",{}", column.unit);
  }
  std::string text = names + "\n" + units + "\n";
  for (const CoursePoint& p : course(stages)) {
    text += fmt::format("{},{}", p.stage, p.label);
    for (const Column& column : columns) text += std::isfinite(p.*column.member) ? fmt::format(",{:.6g}", p.*column.member + 0.0) : ",";
    text += "\n";
  }
  return text;
}

}  // namespace arenite::report
