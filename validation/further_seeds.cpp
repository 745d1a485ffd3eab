#include "validation/further_seeds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "campaign/study_folder.hpp"
#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"
#include "recipe/document.hpp"

namespace arenite::validation {
namespace {

constexpr double beyond_the_estimate = 1.25;  ///< so that a round that is wanted mostly is the last

std::string in_cell(const Where& where) {
  std::string text;
  for (const auto& [key, value] : where) text += fmt::format("{}{}={}", text.empty() ? "" : ";", key, value);
  return text;
}

Where from_cell(std::string_view cell) {
  Where where;
  while (!cell.empty()) {
    const std::string_view part = cell.substr(0, cell.find(';'));
    cell.remove_prefix(std::min(part.size() + 1, cell.size()));
    const auto equals = part.find('=');
    if (equals != part.npos) where.emplace_back(part.substr(0, equals), part.substr(equals + 1));
  }
  return where;
}

/// A swept value as tables of results have it: without quotes and unit.
std::string bare(const std::string& literal) {
  const recipe::Node value = recipe::parse_value(literal);
  const std::string text = value.kind == recipe::Node::Kind::text ? value.text : literal;
  const std::string first = text.substr(0, text.find(' '));
  return io::to_number(first) ? first : text;
}

bool has(const campaign::StudyRun& run, const std::string& key, const std::string& wanted) {
  const auto at = std::ranges::find(run.values, key, [](const auto& value) { return value.first; });
  if (at == run.values.end()) return false;
  const std::string value = bare(at->second);
  const auto number = io::to_number(value), other = io::to_number(wanted);
  return value == wanted || (number && other && *number == *other);
}

bool fits(const campaign::StudyRun& run, const Where& where) {
  return std::ranges::all_of(where, [&](const auto& value) { return has(run, value.first, value.second); });
}

/// The swept values, without the seed.
auto combination_of(const campaign::StudyRun& run) {
  auto values = run.values;
  std::erase_if(values, [](const auto& value) { return value.first == "seed"; });
  return values;
}

/// Runs at the beginning that differ in their seed alone.
std::size_t seeds_of(const campaign::Study& study) {
  const auto first = combination_of(study.runs.front());
  const auto other = std::ranges::find_if(study.runs, [&](const auto& run) { return combination_of(run) != first; });
  return static_cast<std::size_t>(other - study.runs.begin());
}

/// Whether all that `draw` has is among what `extension` draws.
bool covers(const Draw& extension, const Draw& draw) {
  return extension.study == draw.study && std::ranges::all_of(extension.where, [&](const auto& value) {
           return std::ranges::count(draw.where, value) > 0;
         });
}

std::size_t seeds_now(const Draw& draw, const SeededStudy& study, const SeedPlan& plan) {
  std::size_t now = study.own_seeds();
  for (const Extension& extension : plan)
    if (covers(extension.draw, draw)) now = std::max(now, extension.seeds);
  return now;
}

}  // namespace

SeedPlan read_plan(const std::filesystem::path& file) {
  SeedPlan plan;
  if (!std::filesystem::exists(file)) return plan;
  const std::string text = io::read_file(file);
  Problems problems(file.string());
  const io::Table table = io::read_table(text, "", problems);
  problems.raise();
  for (const auto& row : table.rows) {
    const auto seeds = row.cells.size() == 3 ? io::to_integer(row.cells[2]) : std::nullopt;
    if (!seeds || *seeds < 1 || *seeds > 1'000'000)
      throw InputError(file.string(), row.line,
                       "must hold a study, its values and the number of seeds; take the file away to begin anew");
    plan.push_back({{std::string(row.cells[0]), from_cell(row.cells[1])}, static_cast<std::size_t>(*seeds)});
  }
  return plan;
}

void write_plan(const std::filesystem::path& file, const SeedPlan& plan) {
  std::string text = "study,where,seeds\n";
  for (const Extension& extension : plan)
    text += fmt::format("{},{},{}\n", extension.draw.study, io::quoted_cell(in_cell(extension.draw.where)),
                        extension.seeds);
  io::write_atomically(file, text);
}

SeededStudy::SeededStudy(const StudySource& source, const std::filesystem::path& folder, bool small,
                         const std::vector<std::string>& overrides, const SeedPlan& plan)
    : folder_(folder),
      planned_(unpack_study(source, folder, small, overrides)),
      seconds_a_run_(source.seconds_a_run) {
  own_runs_ = planned_.runs.size();
  own_seeds_ = seeds_of(planned_);
  std::size_t most = own_seeds_;
  for (const Extension& extension : plan) {
    if (extension.draw.study != source.name) continue;
    plan_.push_back(extension);
    most = std::max(most, extension.seeds);
  }
  if (most == own_seeds_) return;
  auto more = overrides;
  more.push_back(fmt::format("sweep.replicates={}", most));
  const campaign::Study all = unpack_study(source, folder, small, more);
  for (std::size_t seed = own_seeds_; seed < most; ++seed)
    for (std::size_t at = seed; at < all.runs.size(); at += most) {
      const bool is_planned = std::ranges::any_of(plan_, [&](const Extension& extension) {
        return seed < extension.seeds && fits(all.runs[at], extension.draw.where);
      });
      if (!is_planned) continue;
      further_.push_back({planned_.runs.size(), seed});
      planned_.runs.push_back(all.runs[at]);
    }
}

campaign::Study SeededStudy::whole() const {
  const campaign::StudyFolder files(folder_);
  std::set<std::size_t> kept;
  for (const Extension& extension : plan_)
    for (std::size_t seed = own_seeds_; seed < extension.seeds; ++seed) {
      std::vector<std::size_t> runs;
      for (const auto& [run, its_seed] : further_)
        if (its_seed == seed && fits(planned_.runs[run], extension.draw.where)) runs.push_back(run);
      const bool all_ended = std::ranges::all_of(runs, [&](std::size_t run) {
        const auto status = campaign::read_status(files, planned_.runs[run].name);
        return status && status->settled();
      });
      if (all_ended) kept.insert(runs.begin(), runs.end());
    }
  campaign::Study study = planned_;
  study.runs.resize(own_runs_);
  for (const std::size_t run : kept) study.runs.push_back(planned_.runs[run]);
  return study;
}

std::size_t SeededStudy::runs_a_seed(const Where& where) const {
  const auto own = std::span(planned_.runs).first(own_runs_);
  return static_cast<std::size_t>(std::ranges::count_if(own, [&](const auto& run) { return fits(run, where); })) /
         own_seeds_;
}

std::vector<SeedsWanted> seeds_wanted(const Ledger& ledger, const SeedPlan& plan,
                                      const std::function<const SeededStudy*(const std::string&)>& study) {
  std::vector<SeedsWanted> all;
  for (const auto& [claim, judgement] : ledger.claims) {
    if (judgement.verdict() != Verdict::undecided || decider_of(judgement) != Decider::seeds) continue;
    for (const Check& check : judgement.checks) {
      if (check.kind == Kind::beside || check.outcome != Outcome::undecided || check.decider != Decider::none) continue;
      const double factor = seeds_factor(check);
      if (factor >= most_times_seeds) continue;
      SeedsWanted wanted{claim->id, check.what, {}};
      std::vector<Extension> have;
      for (const Draw& draw : check.draws.empty() ? std::vector<Draw>{{claim->studies.front(), {}}} : check.draws)
        if (const SeededStudy* seeded = study(draw.study); seeded && seeded->runs_a_seed(draw.where) > 0)
          have.push_back({draw, seeds_now(draw, *seeded, plan)});
      if (have.empty()) continue;
      // Draws that go together, such as those with and without glue, are brought to the same number of seeds.
      const auto there = static_cast<double>(std::ranges::min(have, {}, &Extension::seeds).seeds);
      const double needed = std::isfinite(factor) ? there * factor : 2 * there;
      const double next = std::clamp(std::ceil(beyond_the_estimate * needed), there + 1, 2 * there + 1);
      for (const auto& [draw, now] : have) {
        const double more = std::max(needed, there + 1) - static_cast<double>(now);
        const SeededStudy& drawn = *study(draw.study);
        const double runs = std::max(more, 0.0) * static_cast<double>(drawn.runs_a_seed(draw.where));
        wanted.runs += runs;
        wanted.seconds += runs * drawn.seconds_a_run();
        if (static_cast<double>(now) < next) wanted.next.push_back({draw, static_cast<std::size_t>(next)});
      }
      all.push_back(std::move(wanted));
    }
  }
  std::ranges::stable_sort(all, {}, &SeedsWanted::seconds);
  return all;
}

std::string in_words(const Draw& draw) {
  std::string text;
  for (const auto& [key, value] : draw.where) text += fmt::format("{}{} = {}", text.empty() ? " (" : ", ", key, value);
  return draw.study + text + (text.empty() ? "" : ")");
}

}  // namespace arenite::validation
