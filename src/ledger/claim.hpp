#pragma once
#include <string>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::ledger {

class Results;

enum class Holds { yes, no, unknown };  ///< unknown: the runs that decide it are missing
const char* word_for(Holds holds);      ///< "holds", "fails", "unknown"

/// One number held against what the source says of it.
struct Check {
  std::string what;                     ///< "z(all) from ratio 1 to 10, S"
  std::string source;                   ///< what the source has, as text
  std::string ours_unit;
  std::string tolerance;                ///< what must be true of ours, as text
  double ours = statistics::unknown;
  double error = statistics::unknown;   ///< standard error over runs; NaN if there is none
  Holds holds = Holds::unknown;
};

/// A claim holds if all its checks do; one that fails decides, one that is unknown leaves it open.
struct Verdict {
  std::vector<Check> checks;
  Holds holds() const;                  ///< unknown without checks
};

/// How a number hangs on what its source leaves open, one choice at a time.
struct Sensitivity {
  struct Entry {
    std::string choice;                 ///< "without friction"; empty: as the study has it
    double value = statistics::unknown, error = statistics::unknown;
    Holds holds = Holds::unknown;       ///< whether it is as wanted
  };
  std::string what;
  std::string wanted;                   ///< of it, as text; empty if nothing is
  std::vector<Entry> entries;           ///< the first as the study has it
};

/// What is said of a claim.
struct Judgement {
  Verdict stated;                       ///< as the source states it
  Verdict sharpened;                    ///< with the state, law and statistic under which a check has meaning
  std::vector<std::string> findings;    ///< what decides it: sentences with numbers
  std::vector<Sensitivity> sensitivities;  ///< to friction, damping and what else is not stated
};

/// One claim of a source. `id` begins with T (thesis) or P (paper).
struct Claim {
  const char* id;
  const char* where;                    ///< chapter and figure of the source
  const char* sentence;
  std::vector<std::string> studies;     ///< whose runs decide it
  const char* figure;                   ///< that shows it on the page of the first of these; "" if none
  Judgement (*judge)(const Results&);
};

/// Where a claim's figure is in the ledger's folder: "thesis-ch4/study.html#coordination"; empty if it has none.
std::string figure_place(const Claim& claim);

/// All claims, in the order of the sources.
const std::vector<Claim>& claims();

}  // namespace arenite::ledger
