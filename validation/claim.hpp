#pragma once
#include <limits>
#include <string>
#include <vector>

#include "validation/value.hpp"

namespace arenite::validation {

class Results;

/// How a check ends.
enum class Outcome {
  holds,
  fails,
  undecided,  ///< the interval of our value contains the bound, or its error is not known
  unknown     ///< runs that decide it are missing
};
const char* word_for(Outcome outcome);  ///< "holds", "fails", "undecided", "unknown"

/// The subject of a check.
enum class Kind {
  trend,   ///< direction or existence of an effect: the claim in words
  number,  ///< size: the source's own numbers
  source,  ///< whether the source's own tables support its words
  beside   ///< reported with the claim; decides nothing
};
const char* word_for(Kind kind);  ///< "trend", "number", "source", "beside"

/// The claimed range of a number, ends excluded.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// One number compared with the claim of the source.
struct Check {
  std::string what;    ///< "z at ratio 10, law S"
  std::string source;  ///< what the source has, as text
  std::string unit;    ///< of ours
  std::string wanted;  ///< what must be true of ours, as text
  Value ours;
  Range range;  ///< the same as `wanted`, where it is one
  Outcome outcome = Outcome::unknown;
  Kind kind = Kind::trend;
};

/// How a number depends on the choices that its source leaves open, varied one at a time.
struct Sensitivity {
  struct Entry {
    std::string choice;  ///< "without friction"; empty: as the study has it
    Value value;
    Outcome outcome = Outcome::unknown;  ///< whether it is as wanted
  };
  std::string what, wanted;  ///< wanted of it, as text; empty if nothing is
  Range range;
  std::vector<Entry> entries;  ///< the first as the study has it
};

/// How a claim ends.
enum class Verdict { reproduced, trend_reproduced, undecided, not_reproduced, source_inconsistent, unknown };
const char* word_for(Verdict verdict);  ///< "reproduced", "trend reproduced, numbers not", ...

/// What is said of a claim.
struct Judgement {
  std::vector<Check> checks;
  std::string ours;                        ///< beside the source's number, as short as can be; empty: that of the deciding check
  std::string decides;                     ///< the fact that decides it, if it is no choice: a sentence
  std::vector<std::string> findings;       ///< what else is worth telling: sentences with numbers
  std::vector<Sensitivity> sensitivities;  ///< to friction, damping and what else is not stated

  /// A source whose tables contradict its words is inconsistent; otherwise a trend that fails decides, then what is missing,
  /// then what is undecided, then the numbers. A claim of numbers alone stands and falls with them.
  Verdict verdict() const;
};

/// The check that decides its verdict: of the first that ends like it; the first of all if it is reproduced. nullptr if it has none.
const Check* deciding_check(const Judgement& judgement);
/// One sentence: the fact or the choice that decides.
std::string what_decides(const Judgement& judgement);

/// One claim of a source. `id` begins with T (thesis) or P (paper).
struct Claim {
  const char* id;
  const char* where;  ///< chapter and figure of the source
  const char* sentence;
  const char* number;                ///< the source's number, as short as can be; "-" where it has none
  std::vector<std::string> studies;  ///< whose runs decide it
  const char* figure;                ///< that shows it on the page of the first of these; "" if none
  Judgement (*judge)(const Results&);
};

/// Where a claim's figure is in the ledger's folder: "thesis-ch4/study.html#coordination"; empty if it has none.
std::string figure_place(const Claim& claim);

/// All claims, in the order of the sources.
const std::vector<Claim>& claims();

}  // namespace arenite::validation
