#include "campaign/study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "campaign/study_folder.hpp"
#include "campaign/sweep.hpp"
#include "core/hash.hpp"
#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/film/film.hpp"
#include "recipe/document.hpp"
#include "recipe/read_tree.hpp"
#include "recipe/reader.hpp"
#include "recipe/recipe.hpp"

namespace arenite::campaign {
namespace {

namespace fs = std::filesystem;

/// Problems of many runs, each once.
class RunProblems {
 public:
  void add(const InputError& error, const StudyRun& run) {
    ++failing_;
    for (const Problem& problem : error.problems()) {
      const auto key = std::tuple(problem.line, problem.column, problem.file, problem.message);
      auto [at, is_new] = found_.try_emplace(key, Found{describe(run), 0});
      ++at->second.runs;
    }
  }
  bool enough() const { return failing_ >= 1000; }
  void raise(std::size_t runs) const {
    if (found_.empty()) return;
    std::vector<Problem> problems;
    for (const auto& [key, found] : found_) {
      const auto& [line, column, file, message] = key;
      std::string where;
      if (found.runs < runs && !found.first.empty())
        where = fmt::format(" (run with {}{})", found.first,
                            found.runs > 1 ? fmt::format(", and {} more", found.runs - 1) : "");
      problems.push_back({file, line, column, message + where});
    }
    throw InputError(std::move(problems));
  }

 private:
  struct Found {
    std::string first;
    std::size_t runs;
  };
  std::map<std::tuple<int, int, std::string, std::string>, Found> found_;
  std::size_t failing_ = 0;
};

const recipe::RecordTable& keys_of(const Study& study) {
  return study.of_films ? recipe::film_keys() : recipe::recipe_keys();
}

/// The tree of the recipe, its overrides applied, by the keys of its kind, which only the tree tells, base and all.
void read_kind_and_tree(Study& study, recipe::Reading& reading) {
  const std::string text = io::read_file(study.file);
  recipe::Reading first = reading;
  study.of_films = recipe::describes_film(recipe::read_tree(text, first, {}, recipe::film_keys(), "composite"));
  study.tree = recipe::read_tree(text, reading, study.overrides, keys_of(study), study.of_films ? "film" : "composite");
  study.notices = reading.notices;
}

/// Seeds change no measurement.
void refuse_seeds(const recipe::Node& sweep, recipe::Reading& reading) {
  for (const char* key : {"replicates", "seeds"})
    if (const recipe::Entry* entry = sweep.find(key))
      add_problem(reading, entry->place, std::string("sweep.") + key,
                  "a film is measured alike with any seed; leave it out");
}

/// Takes [sweep] out of the tree.
Sweep take_sweep(Study& study, recipe::Reading& reading) {
  read_kind_and_tree(study, reading);
  const auto section = study.tree.take("sweep");
  if (!section)
    refuse(study.file, "has no section [sweep], so it is one run: `arenite {} {}`; docs/studies.md describes [sweep]",
           study.of_films ? "film --recipe" : "run", study.file);
  if (study.of_films) refuse_seeds(section->value, reading);
  const recipe::Entry* seed = study.tree.find("seed");
  const bool has_seed = seed && seed->value.kind == recipe::Node::Kind::integer;
  return read_sweep(section->value, reading, has_seed ? static_cast<std::uint64_t>(seed->value.integer) : 1);
}

std::int64_t seed_of(const recipe::Recipe& recipe, Sweep::Seeds seeds, std::int64_t replicate) {
  if (seeds == Sweep::Seeds::consecutive) return static_cast<std::int64_t>(recipe.seed) + replicate;
  HashBuilder hash;
  hash.add("packing", workflow::seed_key(recipe)).add("replicate", replicate);
  return std::stoll(hash.hex().substr(0, 12), nullptr, 16);  // 48 bits, which a double holds exactly
}

InputError problem_at(const recipe::Place& place, const recipe::Reading& reading, std::string message) {
  return InputError({Problem{file_of(place, reading), place.line, place.column, std::move(message)}});
}

/// A swept key with the place that it reaches in the recipe: two keys may call one item by its name and by its number.
struct Reached {
  const Assignment* by;
  std::vector<std::string> parts;
};

/// What a value holds under such a part of a key; nothing where it says nothing of it.
const recipe::Node* inside(const recipe::Node& value, const std::string& part) {
  if (value.kind == recipe::Node::Kind::array) return &value.items.at(std::stoul(part));
  const recipe::Entry* const entry = value.find(part);
  return entry ? &entry->value : nullptr;
}

/// Whether nothing, or not all, is left of what `earlier` set.
bool overwrites(const Reached& later, const Reached& earlier) {
  const auto [own, others] = std::ranges::mismatch(later.parts, earlier.parts);
  if (own == later.parts.end() || others != earlier.parts.end()) return own == later.parts.end();
  const recipe::Node* said = &earlier.by->value;
  for (auto part = own; part != later.parts.end() && said; ++part) said = inside(*said, *part);
  return said != nullptr;
}

recipe::Node with(const Study& study, const Point& point, const recipe::Reading& reading, const recipe::Place& sweep) {
  recipe::Node tree = study.tree;
  std::vector<Reached> reached;
  for (const Assignment& each : point) {
    try {
      reached.push_back({&each, set_value(tree, each.key, each.value, keys_of(study))});
    } catch (const InputError& error) {
      throw problem_at(each.value.place, reading, fmt::format("{}: {}", each.key, error.what()));
    }
    const auto lost = std::ranges::find_if(
        reached, [&](const Reached& other) { return &other != &reached.back() && overwrites(reached.back(), other); });
    if (lost != reached.end())
      throw problem_at(
          sweep, reading,
          fmt::format("sweep: {} and {} set the same place of the recipe; keep one of them", lost->by->key, each.key));
  }
  return tree;
}

bool is_same(const recipe::Place& a, const recipe::Place& b) {
  return std::tie(a.line, a.column, a.file, a.override_text) == std::tie(b.line, b.column, b.file, b.override_text);
}

/// The first value of the later of two points that the earlier does not have from the same place.
recipe::Place where_they_part(const Point& earlier, const Point& later) {
  for (const Assignment& each : later) {
    const auto at = std::ranges::find(earlier, each.key, &Assignment::key);
    if (at == earlier.end() || !is_same(at->value.place, each.value.place)) return each.value.place;
  }
  return later.empty() ? recipe::Place{} : later.back().value.place;
}

class Expansion {
 public:
  Expansion(Study& study, const recipe::Reading& reading, const Sweep& sweep)
      : study_(study),
        reading_(reading),
        sweep_(sweep) {}

  /// The runs of the sweep's combination of that number.
  void add(std::size_t combination) {
    combination_ = combination;
    const Point point = sweep_.combination(combination);
    StudyRun run;
    for (const auto& [key, value] : point) run.values.emplace_back(key, toml_literal(value));
    try {
      const recipe::Node tree = with(study_, point, reading_, sweep_.place);
      if (study_.of_films) return add_film(run, recipe::film_recipe_from(tree, study_.file));
      recipe::Recipe recipe = recipe_from(tree, study_.file);
      if (recipe.packing.method == recipe::PackingParameters::Method::file)
        files_.insert(recipe.beside(recipe.packing.file).string());
      const recipe::Recipe base = recipe;
      for (std::int64_t r = 0; r < std::max<std::int64_t>(sweep_.replicates, 1); ++r) {
        StudyRun replicate = run;
        if (sweep_.replicates > 0) {
          recipe.seed = static_cast<std::uint64_t>(seed_of(base, sweep_.seeds, r));
          replicate.values.emplace_back("seed", std::to_string(recipe.seed));
        }
        finish(std::move(replicate), workflow::plan_of(recipe));
      }
    } catch (const InputError& error) { problems_.add(error, run); }
  }
  bool enough() const { return problems_.enough(); }
  void end(std::size_t combinations) {
    problems_.raise(combinations);
    for (const auto& file : files_) study_.inputs.emplace_back(file, content_hash(io::read_file(file)));
  }

 private:
  void add_film(StudyRun run, const recipe::FilmRecipe& recipe) {
    const fs::path film = recipe.film_named();
    const auto source = io::open_film(film, recipe.choice());
    finish(std::move(run),
           {workflow::planned_stage(1, "film", workflow::film_key(film, *source, recipe, known_), false)});
  }

  void finish(StudyRun run, std::vector<workflow::PlannedStage> stages) {
    run.stages = std::move(stages);
    HashBuilder hash;
    for (const workflow::PlannedStage& stage : run.stages) hash.add(stage.name, stage.hash);
    run.name = hash.hex().substr(0, 16);
    const auto [first, is_new] = first_of_.try_emplace(run.name, study_.runs.size(), combination_);
    if (!is_new && !has_twins_) refuse_twins(first->second, run);
    study_.runs.push_back(std::move(run));
  }

  /// Two runs that are one would count as independent in means over runs: the first such pair is told.
  void refuse_twins(const std::pair<std::size_t, std::size_t>& first, const StudyRun& run) {
    has_twins_ = true;
    const Point earlier = sweep_.combination(first.second), own = sweep_.combination(combination_);
    const std::string one = describe(study_.runs[first.first]), other = describe(run);
    const std::string which = one != other  ? fmt::format("that with {} and that with {}", one, other)
                              : one.empty() ? "both of them the recipe as it stands"
                                            : fmt::format("both with {}", one);
    problems_.add(problem_at(where_they_part(earlier, own), reading_,
                             fmt::format("sweep: two runs are the same, {}; leave out one{}", which,
                                         study_.of_films ? "" : ", or give runs other seeds by sweep.replicates")),
                  {});
  }

  Study& study_;
  const recipe::Reading& reading_;
  const Sweep& sweep_;
  RunProblems problems_;
  std::size_t combination_ = 0;                                                    ///< that runs are made of
  std::unordered_map<std::string, std::pair<std::size_t, std::size_t>> first_of_;  ///< a name: run and combination
  bool has_twins_ = false;
  std::set<std::string> files_;
  workflow::KnownFilms known_;
};

}  // namespace

std::string describe(const StudyRun& run) {
  std::string text;
  for (const auto& [key, value] : run.values) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, value);
  return text;
}

Study read_study(const std::string& file, const std::vector<std::string>& overrides, const fs::path& folder) {
  Study study;
  study.file = file;
  study.overrides = overrides;
  recipe::Reading reading{file, fs::path(file).parent_path().string(), true, {}};
  const bool is_known = !folder.empty() && read_runs(folder / "runs.tsv", study);
  const Sweep sweep = take_sweep(study, reading);
  if (is_known && !study.of_films) return study;
  study.runs.clear(), study.inputs.clear();  // what films hold is seen by reading them
  if (!reading.problems.empty()) throw InputError(std::move(reading.problems));
  study.inputs.emplace_back(file, content_hash(io::read_file(file)));
  for (const auto& base : reading.bases) study.inputs.emplace_back(base, content_hash(io::read_file(base)));
  for (const auto& table : sweep.files) study.inputs.emplace_back(table, content_hash(io::read_file(table)));
  study.keys = sweep.keys();
  if (sweep.replicates > 0) study.keys.emplace_back("seed");
  if (const recipe::Entry* title = study.tree.find("title"); title && title->value.kind == recipe::Node::Kind::text)
    study.title = title->value.text;

  Expansion expansion(study, reading, sweep);
  const std::size_t combinations = sweep.combinations();
  for (std::size_t index = 0; index < combinations && !expansion.enough(); ++index) expansion.add(index);
  expansion.end(combinations);
  if (folder.empty()) return study;
  note_runs_of_version_0_1(folder, study);
  write_runs(folder / "runs.tsv", study);
  return study;
}

namespace {

recipe::Node tree_of(const Study& study, const StudyRun& run) {
  recipe::Node tree = study.tree;
  for (const auto& [key, value] : run.values) set_value(tree, key, recipe::parse_value(value), keys_of(study));
  return tree;
}

}  // namespace

recipe::Recipe recipe_of(const Study& study, const StudyRun& run) {
  return recipe_from(tree_of(study, run), study.file);
}

recipe::FilmRecipe film_recipe_of(const Study& study, const StudyRun& run) {
  return recipe::film_recipe_from(tree_of(study, run), study.file);
}

}  // namespace arenite::campaign
