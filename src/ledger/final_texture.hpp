#pragma once
#include "ledger/results.hpp"
#include "model/packing.hpp"
#include "texture/texture.hpp"

namespace arenite::ledger {

/// The last state of a run, from its stage file; `rev` says whether the REV study is wanted, which takes longest.
struct FinalState {
  Packing packing;
  texture::Texture texture;
};
/// Throws InputError if the run's files are not there.
FinalState final_state(const Run& run, bool rev = false);

/// How often two samples of one law would differ as much in their cumulative shares (Kolmogorov and Smirnov); NaN where one
/// is empty.
double chance_of_one_law(std::vector<double> a, std::vector<double> b);

}  // namespace arenite::ledger
