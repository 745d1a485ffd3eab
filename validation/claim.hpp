#pragma once
#include <limits>
#include <string>
#include <vector>

#include "validation/draw.hpp"
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

/// What decides how a check or a claim ends.
enum class Decider {
  none,      ///< nothing that was tried
  seeds,     ///< more of them
  grid,      ///< its nodes and its crop
  protocol,  ///< how samples are made and loaded: friction, damping, equilibrium, load
  reading,   ///< of a sentence or a rule of the source that can be read in two ways
  source,    ///< its own tables
  lost,      ///< what the source did not keep
  runs       ///< those that are missing
};
const char* word_for(Decider decider);  ///< "none found", "seeds", "grid", ..., "lost data", "missing runs"

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
  Decider decider = Decider::none;  ///< where the claim itself knows it; otherwise choices and errors tell
  std::vector<Draw> draws = {};     ///< further seeds that would help; empty: of all runs of the claim's first study
  double outside = usual_side;  ///< chance below which a value outside of the range fails: less for the worst of many
};

/// How a number depends on the choices that its source leaves open, varied one at a time.
struct Sensitivity {
  struct Entry {
    std::string choice;  ///< "without friction"; empty: as the study has it
    Value value;
    Outcome outcome = Outcome::unknown;  ///< whether it is as wanted
    Decider kind = Decider::protocol;    ///< of the choice: grid, protocol or reading
  };
  std::string what, wanted;  ///< wanted of it, as text; empty if nothing is
  Range range;
  std::vector<Entry> entries;  ///< the first as the study has it
};

/// How a claim ends.
enum class Verdict {
  reproduced,
  trend_reproduced,
  undecided,
  not_reproduced,
  source_inconsistent,
  not_testable,  ///< the source did not keep what a test needs
  unknown
};
const char* word_for(Verdict verdict);  ///< "reproduced", "trend reproduced, numbers not", ...
inline constexpr Verdict all_verdicts[] = {Verdict::reproduced,     Verdict::trend_reproduced,    Verdict::undecided,
                                           Verdict::not_reproduced, Verdict::source_inconsistent, Verdict::not_testable,
                                           Verdict::unknown};

/// What is said of a claim.
struct Judgement {
  std::vector<Check> checks;
  std::string ours;        ///< beside the source's number, as short as can be; empty: that of the deciding check
  std::string decides;     ///< the fact that decides it, if it is no choice: a sentence
  std::string untestable;  ///< why no run can test it: a sentence; empty: runs can
  std::vector<std::string> findings;       ///< what else is worth telling: sentences with numbers
  std::vector<Sensitivity> sensitivities;  ///< to friction, damping and what else is not stated

  /// A source whose tables contradict its words is inconsistent, and what no run can test is not testable; otherwise a
  /// trend that fails decides, then what is missing, then what is undecided, then the numbers. A claim of numbers alone
  /// stands and falls with them.
  Verdict verdict() const;
};

/// The check that decides its verdict: of the first that ends like it; the first of all if it is reproduced. nullptr if
/// it has none.
const Check* deciding_check(const Judgement& judgement);
/// What kind of thing decides its verdict: what the deciding check says of itself; otherwise the choices that turn a
/// number that is not as wanted beyond the errors of both. A number that is undecided and that grids move from one end
/// of its range to the other is decided by the grid; any other that is undecided, by seeds.
Decider decider_of(const Judgement& judgement);
/// One sentence: the fact or the choice that decides.
std::string what_decides(const Judgement& judgement);
/// How many times as many seeds would decide a check if its value stayed where it is, at most most_times_seeds; NaN
/// where that cannot be told.
double seeds_factor(const Check& check);
inline constexpr double most_times_seeds = 100;

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
