#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/hash.hpp"
#include "io/disk/file.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {
namespace {

/// All that names of results follow from: the stages of a simulation, or the changed keys of a film.
std::string names_of(const std::string& file) {
  std::string names;
  try {
    for (const PlannedStage& stage : plan_of(recipe::read_recipe(file))) names += stage.name + " " + stage.hash + "\n";
  } catch (const InputError&) { return changed_keys(recipe::read_film_recipe(file)); }
  return names;
}

/// The table has of every recipe its bytes' hash and that of its names, as they were when the table was written: a
/// recipe that has changed since says nothing.
TEST(NamesOfResults, AreForRecipesOfTheRepositoryWhatTheyWere) {
  const std::filesystem::path root(ARENITE_SOURCE_DIR);
  std::ifstream table(root / "tests/unit/workflow/names_of_results.txt");
  int compared = 0;
  for (std::string file, bytes, names; table >> file >> bytes >> names;) {
    const std::string path = (root / file).string();
    if (!std::filesystem::exists(path) || content_hash(io::read_file(path)) != bytes) continue;
    EXPECT_EQ(content_hash(names_of(path)), names)
        << file << ": a new key at its default, or a section of defaults, renames nothing; if the same recipe gives "
        << "other bits, write the table anew";
    ++compared;
  }
  EXPECT_GT(compared, 20) << "the table is out of date";
}

}  // namespace
}  // namespace arenite::workflow
