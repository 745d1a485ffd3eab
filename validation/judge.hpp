#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "validation/claim.hpp"
#include "validation/results.hpp"

namespace arenite::validation {

/// A claim and what the runs say of it.
struct Judged {
  const Claim* claim;
  Judgement judgement;
};

/// How many runs of a study are done, and the days on which the first and the last of these ended, "2026-01-31"; empty
/// where there are none.
struct StudyState {
  std::string name;
  std::size_t runs = 0, done = 0;
  std::string first_day = {}, last_day = {};
};

/// A ledger: what was judged, by what.
struct Ledger {
  std::vector<StudyState> studies;
  std::vector<Judged> claims;
};

/// Names of the studies that decide the claims of a source: 'T' (thesis) or 'P' (paper), each once.
std::vector<std::string> studies_of(char source);

/// Judges the claims of a source ('T' or 'P') by what is there.
Ledger judge(char source, Results results);

}  // namespace arenite::validation
