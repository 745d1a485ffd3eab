#pragma once
#include "grains/fields/loading.hpp"

namespace arenite::fields {

/// What kind of test a stage is, by what was done to its sample.
enum class TestKind {
  none,       ///< none of these: a packing, a compression from all sides
  biaxial,    ///< compressed along one axis between sides that give way
  shear,      ///< sheared along its sides or with its cell
  uniaxial,   ///< loaded along one axis and free across it, or drawn apart
  oedometer,  ///< compressed between sides that stand still
  cycles,     ///< loaded or strained to and fro
  discharge,  ///< what passes is counted, as below a silo
  collapse,   ///< spreads under its weight
  deposit,    ///< came to rest under its weight, with a free surface
  drum        ///< turned with its boundary, so that its surface keeps a slope
};
TestKind kind_of(const Test& test);
/// Of spheres: a biaxial test is triaxial in space.
TestKind kind_of(const SphereResult& stage);

/// "biaxial", ..; empty where it is none.
const char* name_of(TestKind kind);

}  // namespace arenite::fields
