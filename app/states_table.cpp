#include "states_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "report/course.hpp"

namespace arenite::app {
namespace {

using report::CoursePoint;

struct Column {
  const char* head;
  double CoursePoint::*member;
};

/// Anisotropies have a sign here, against the axis of loading (of greatest compression where there are several); `show` without --states prints how large they are.
constexpr Column columns[] = {
    {"time [s]", &CoursePoint::time},
    {"strain_x", &CoursePoint::strain_x},
    {"strain_y", &CoursePoint::strain_y},
    {"volume_strain", &CoursePoint::volume_strain},
    {"p [Pa]", &CoursePoint::pressure},
    {"q [Pa]", &CoursePoint::deviator},
    {"q_over_p", &CoursePoint::ratio},
    {"solid_fraction", &CoursePoint::solid_fraction},
    {"z", &CoursePoint::coordination},
    {"z_without_rattlers", &CoursePoint::bearing_coordination},
    {"rattlers", &CoursePoint::rattlers},
    {"a_c_signed", &CoursePoint::anisotropy},
    {"a_c_signed_strong", &CoursePoint::strong_anisotropy},
    {"a_c_signed_weak", &CoursePoint::weak_anisotropy},
    {"strong_share", &CoursePoint::strong_share},
    {"q_on_strong", &CoursePoint::deviator_on_strong},
    {"mobilisation", &CoursePoint::mobilisation},
};

std::vector<StageResult> stages_of(const std::filesystem::path& result) {
  std::vector<StageResult> stages;
  for (const auto& file : io::stage_files(result)) {
    const std::string kind = io::sealed_kind(file);
    if (kind != "field" && kind != "film") stages.push_back(io::read_stage(file));
  }
  if (stages.empty()) throw InputError(result.string(), 0, "holds no stages of loading, so there is no course through them; leave out --states");
  return stages;
}

}  // namespace

std::string states_table(const std::filesystem::path& result) {
  std::string text = "stage,label";
  for (const Column& column : columns) text += fmt::format(",{}", column.head);
  text += "\n";
  for (const CoursePoint& p : report::course(stages_of(result))) {
    text += fmt::format("{},{}", p.stage, p.label);
    for (const Column& column : columns) text += std::isfinite(p.*column.member) ? fmt::format(",{:.6g}", p.*column.member + 0.0) : ",";
    text += "\n";
  }
  return text;
}

}  // namespace arenite::app
