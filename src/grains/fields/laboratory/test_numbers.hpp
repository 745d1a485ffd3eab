#pragma once
#include "grains/fields/loading.hpp"

namespace arenite::fields {

/// What a test says by its history, as `arenite show` and the page have it, each with unit and sentence and with an
/// error where one is known: "critical_state" (test_curves.hpp); "peak" of a biaxial or shear test; "uniaxial"
/// strength, modulus and broken bonds; "oedometer"; "cycles". Empty where it is no test. They are stored with the
/// stage, among its other numbers.
Numbers test_numbers(const Test& test);
Numbers test_numbers(const SphereResult& stage);

/// Those of them among the numbers that are stored with a stage of disks or spheres.
Numbers test_among(const Numbers& stored);

/// As they are stored or, of a result that is older than such numbers, by the history of its stage.
Numbers test_of(const Test& test);
Numbers test_of(const SphereResult& stage);

}  // namespace arenite::fields
