#include "validation/further_seeds.hpp"

#include <gtest/gtest.h>

#include <set>

#include "campaign/study_folder.hpp"
#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "support/temporary_folder.hpp"
#include "validation/checks.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> small_sweep{
    "sweep.replicates=2", "sweep.grid={ \"contact.surface_energy\" = [\"1.060 kN/mm\", \"0.5 kN/mm\"] }"};
const Where glued{{"contact.surface_energy", "1.06"}};

/// The glued agglomerate with two glues and two seeds.
SeededStudy seeded(const test::TemporaryFolder& folder, const SeedPlan& plan) {
  return {*find_study("thesis-ch6"), folder.path() / "thesis-ch6", false, small_sweep, plan};
}

std::string value_of(const campaign::StudyRun& run, const std::string& key) {
  for (const auto& [name, value] : run.values)
    if (name == key) return value;
  return {};
}

void end(const test::TemporaryFolder& folder, const campaign::StudyRun& run) {
  const campaign::StudyFolder files(folder.path() / "thesis-ch6");
  std::filesystem::create_directories(files.run(run.name));
  campaign::write_status(files, run.name, {campaign::RunState::Kind::done, 1, {}});
}

TEST(FurtherSeeds, AddRunsAndChangeNone) {
  const test::TemporaryFolder folder;
  const SeededStudy own = seeded(folder, {});
  ASSERT_EQ(own.planned().runs.size(), 4u);
  EXPECT_EQ(own.own_seeds(), 2u);
  EXPECT_EQ(own.runs_a_seed({}), 2u);
  EXPECT_EQ(own.runs_a_seed(glued), 1u);
  const SeededStudy more =
      seeded(folder, {{{"thesis-ch6", glued}, 4}, {{"thesis-ch6", {}}, 3}, {{"thesis-ch5", {}}, 9}});
  ASSERT_EQ(more.planned().runs.size(), 4u + 1 + 1 + 1);
  for (std::size_t run = 0; run < 4; ++run) EXPECT_EQ(more.planned().runs[run].name, own.planned().runs[run].name);
  EXPECT_EQ(value_of(more.planned().runs[4], "seed"), "3") << "seed by seed";
  EXPECT_EQ(value_of(more.planned().runs[5], "seed"), "3");
  EXPECT_EQ(value_of(more.planned().runs[6], "seed"), "4");
  EXPECT_EQ(value_of(more.planned().runs[6], "contact.surface_energy"), "\"1.060 kN/mm\"");
  std::set<std::string> names;
  for (const auto& run : more.planned().runs) names.insert(run.name);
  EXPECT_EQ(names.size(), 7u);
}

TEST(FurtherSeeds, CountWhenAllRunsOfASeedHaveEnded) {
  const test::TemporaryFolder folder;
  const SeededStudy more = seeded(folder, {{{"thesis-ch6", {}}, 3}});
  ASSERT_EQ(more.planned().runs.size(), 6u);
  EXPECT_EQ(more.whole().runs.size(), 4u);
  end(folder, more.planned().runs[4]);
  EXPECT_EQ(more.whole().runs.size(), 4u) << "half a seed";
  end(folder, more.planned().runs[5]);
  EXPECT_EQ(more.whole().runs.size(), 6u);
}

TEST(FurtherSeeds, ArePlannedInAFile) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "further-seeds.csv";
  EXPECT_TRUE(read_plan(file).empty());
  const SeedPlan plan{{{"thesis-ch6", {{"a.b", "1.06"}, {"c", "full"}}}, 12}, {{"paper", {}}, 7}};
  write_plan(file, plan);
  const SeedPlan again = read_plan(file);
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].draw, plan[0].draw);
  EXPECT_EQ(again[0].seeds, 12u);
  EXPECT_EQ(again[1].draw, plan[1].draw);
  io::write_atomically(file, "study,where,seeds\npaper,,many\n");
  EXPECT_THROW(read_plan(file), InputError);
}

/// A ledger of one claim with these checks, of the agglomerate unless they say otherwise.
Ledger ledger_of(std::vector<Check> checks) {
  static const Claim claim{"T0", "", "", "-", {"thesis-ch6"}, "", nullptr};
  Judgement judgement;
  judgement.checks = std::move(checks);
  return {{}, {{&claim, judgement}}};
}

TEST(FurtherSeeds, ComeNextWhereFewestDecide) {
  const test::TemporaryFolder folder;
  const SeededStudy study = seeded(folder, {});
  const auto find = [&](const std::string& name) { return name == "thesis-ch6" ? &study : nullptr; };
  const Check far = positive("far", "", {1, 0.9, 40}),
              near = drawn({{"thesis-ch6", glued}}, positive("near", "", {1, 0.55, 40}));
  const Check hopeless = positive("hopeless", "", {0.001, 1, 40}), certain = positive("certain", "", {5, 1, 40});
  const auto wanted = seeds_wanted(ledger_of({far, hopeless, certain, near, beside(far)}), {}, find);
  ASSERT_EQ(wanted.size(), 2u);
  EXPECT_EQ(wanted[0].what, "near");
  EXPECT_EQ(wanted[0].next[0].draw.where, glued);
  EXPECT_EQ(wanted[0].next[0].seeds, 4u) << "1.2 times two seeds, and a quarter more, and whole";
  EXPECT_EQ(wanted[1].what, "far");
  EXPECT_EQ(wanted[1].next[0].seeds, 5u) << "at most twice as many and one";
  // After these the next ones are counted from there.
  const auto later = seeds_wanted(ledger_of({far}), {{{"thesis-ch6", {}}, 9}}, find);
  EXPECT_GT(later[0].next[0].seeds, 9u);
  // Draws that go together are brought to the same number: the glued ones have four already.
  const Check paired = drawn({{"thesis-ch6", glued}, {"thesis-ch6", {{"contact.surface_energy", "0.5"}}}},
                             positive("paired", "", {1, 0.55, 40}));
  const auto level = seeds_wanted(ledger_of({paired}), {{{"thesis-ch6", glued}, 4}}, find);
  ASSERT_EQ(level[0].next.size(), 1u);
  EXPECT_EQ(level[0].next[0].draw.where.front().second, "0.5");
  EXPECT_EQ(level[0].next[0].seeds, 4u);
  // What choices or the grid decide, no seed is drawn for.
  Check by_grid = far;
  by_grid.decider = Decider::grid;
  EXPECT_TRUE(seeds_wanted(ledger_of({by_grid}), {}, find).empty());
}

TEST(FurtherSeeds, ComeFirstWhereTheyAreCheapNotWhereTheyAreFew) {
  const test::TemporaryFolder folder;
  const SeededStudy cheap = seeded(folder, {}),
                    dear(*find_study("thesis-ch4-r"), folder.path() / "thesis-ch4-r", false, {}, {});
  ASSERT_GT(dear.seconds_a_run(), 10 * cheap.seconds_a_run());
  const auto find = [&](const std::string& name) { return name == "thesis-ch6" ? &cheap : &dear; };
  const Check few = drawn({{"thesis-ch4-r", {}}}, positive("few", "", {1, 0.55, 40})),
              many = positive("many", "", {1, 0.9, 40});
  const auto wanted = seeds_wanted(ledger_of({few, many}), {}, find);
  ASSERT_EQ(wanted.size(), 2u);
  EXPECT_EQ(wanted[0].what, "many");
  EXPECT_LT(wanted[0].seconds, wanted[1].seconds);
}

}  // namespace
}  // namespace arenite::validation
