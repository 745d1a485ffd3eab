#pragma once
#include "grains/fields/loading.hpp"

namespace arenite::fields {

/// What a test says by its history, as `arenite show` and the page have it, each with unit and sentence and with an
/// error where one is known: "critical_state" (test_curves.hpp); "peak" of a biaxial or shear test; "uniaxial"
/// strength, modulus and broken bonds; "oedometer"; "cycles". Empty where it is no test.
Numbers test_numbers(const Test& test);

}  // namespace arenite::fields
