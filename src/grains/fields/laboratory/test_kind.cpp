#include "grains/fields/laboratory/test_kind.hpp"

#include <algorithm>
#include <cmath>

#include "grains/fields/free_surface.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_in_space.hpp"
#include "grains/fields/state_curves.hpp"

namespace arenite::fields {
namespace {

bool is_cyclic(const StageResult& stage) {
  const auto* cycle = stage.cycles.find("cycle");
  return (cycle && cycle->size() > 3) || whole_cycles(stage).size() > 1;
}

/// Compressed along one axis by more than its volume tells.
bool is_biaxial(const Test& test) {
  const auto of = loading_of(test);
  return of && std::abs(of->curves["shear_strain"].back()) > std::abs(of->curves["volumetric_strain"].back());
}

TestKind kind_by_sides(const Test& test) {
  const auto curves = test_curves(test);
  if (!curves) return TestKind::none;
  if (curves->sheared) return TestKind::shear;
  if (!curves->confined) return TestKind::uniaxial;
  if (is_oedometric(test, *curves)) return TestKind::oedometer;
  return is_biaxial(test) ? TestKind::biaxial : TestKind::none;
}

}  // namespace

TestKind kind_of(const Test& test) {
  if (test.stage.snapshots.empty()) return TestKind::none;
  const Numbers& numbers = test.stage.texture;
  if (numbers.at_path("/discharge")) return TestKind::discharge;
  if (is_cyclic(test.stage)) return TestKind::cycles;
  if (numbers.at_path("/surface") && in_drum(test.stage.snapshots.back().packing.domain)) return TestKind::drum;
  if (numbers.at_path("/surface/runout_m")) return TestKind::collapse;
  const TestKind kind = kind_by_sides(test);
  return kind == TestKind::none && numbers.at_path("/surface/solid_fraction") ? TestKind::deposit : kind;
}

TestKind kind_of(const SphereResult& stage) {
  if (stage.snapshots.empty()) return TestKind::none;
  const Numbers& numbers = stage.texture;
  if (numbers.at_path("/discharge")) return TestKind::discharge;
  if (numbers.at_path("/surface") && in_drum(stage.snapshots.back().packing.domain)) return TestKind::drum;
  if (numbers.at_path("/surface/runout_m")) return TestKind::collapse;
  if (const auto curves = test_curves(stage))
    return curves->sheared ? TestKind::shear : curves->confined ? TestKind::biaxial : TestKind::uniaxial;
  return numbers.at_path("/surface/solid_fraction") ? TestKind::deposit : TestKind::none;
}

const char* name_of(TestKind kind) {
  switch (kind) {
    case TestKind::none: return "";
    case TestKind::biaxial: return "biaxial";
    case TestKind::shear: return "shear";
    case TestKind::uniaxial: return "uniaxial";
    case TestKind::oedometer: return "oedometer";
    case TestKind::cycles: return "cycles";
    case TestKind::discharge: return "discharge";
    case TestKind::collapse: return "collapse";
    case TestKind::deposit: return "deposit";
    case TestKind::drum: return "drum";
  }
  return "";
}

}  // namespace arenite::fields
