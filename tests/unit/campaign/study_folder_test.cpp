#include "campaign/study_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

#include "campaign/collect.hpp"
#include "campaign/run_study.hpp"
#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "support/numbers_of.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/store.hpp"

namespace arenite::campaign {
namespace {

using Kind = RunState::Kind;

/// Runs of three loads each on few packings.
Study synthetic(std::size_t runs, std::size_t runs_of_a_packing) {
  Study study;
  study.keys = {"cement.width", "seed"};
  for (std::size_t r = 0; r < runs; ++r) {
    StudyRun run;
    run.name = "run" + std::to_string(r);
    run.values = {{"cement.width", std::to_string(r % runs_of_a_packing)},
                  {"seed", std::to_string(r / runs_of_a_packing)}};
    run.stages = {{"packing", "p" + std::to_string(r / runs_of_a_packing), "01", false},
                  {"load", "l" + std::to_string(r), "02", true}};
    study.runs.push_back(std::move(run));
  }
  return study;
}

TEST(Shards, AreAPartitionIntoEqualPartsWithThePackingsTogether) {
  const Study study = synthetic(103, 6);
  for (const std::size_t shards : {1u, 2u, 4u, 7u, 200u}) {
    std::vector<int> seen(study.runs.size(), 0);
    for (std::size_t s = 0; s < shards; ++s) {
      const auto part = shard_of(study, s, shards);
      EXPECT_LE(part.size(), 103 / shards + 1);
      EXPECT_GE(part.size() + 1, 103 / shards);
      for (const std::size_t run : part) ++seen[run];
    }
    EXPECT_EQ(seen, std::vector<int>(study.runs.size(), 1)) << shards;
  }
}

TEST(Journal, TheLastWordOnEachOfTwentyThousandRunsCounts) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  {
    const io::AppendLog one(place.journal()), two(place.journal());
    for (int r = 0; r < 20'000; ++r) note_state(one, "run" + std::to_string(r), {Kind::running, 0, {}});
    for (int r = 0; r < 20'000; ++r)
      note_state(two, "run" + std::to_string(r),
                 r % 100 == 0 ? RunState{Kind::failed, 1, "no\treason\nat all"} : RunState{Kind::done, 2.5, {}});
  }
  const auto states = read_states(place);
  ASSERT_EQ(states.size(), 20'000u);
  EXPECT_EQ(states.at("run199").kind, Kind::done);
  EXPECT_EQ(states.at("run199").seconds, 2.5);
  EXPECT_EQ(states.at("run200").kind, Kind::failed);
  EXPECT_EQ(states.at("run200").reason, "no reason at all");
}

TEST(Journal, ARunThatItsProcessLeftIsNotRunning) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  const io::AppendLog journal(place.journal());
  note_state(journal, "a", {Kind::running, 0, {}});
  EXPECT_EQ(read_states(place).at("a").kind, Kind::waiting);
  std::filesystem::create_directories(place.lock("a").parent_path());
  const auto lock = io::FileLock::try_take(place.lock("a"));
  EXPECT_EQ(read_states(place).at("a").kind, Kind::running);
}

TEST(Journal, AClockThatIsAheadDoesNotDecide) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  std::filesystem::create_directories(place.journal());
  std::filesystem::create_directories(place.run("a"));
  std::ofstream(place.journal() / "1.log")
      << "99999999999999999\ta\trunning\t0\t\n99999999999999999\ta\tfailed\t1\tno memory\n";
  std::ofstream(place.journal() / "2.log") << "17\ta\trunning\t0\t\n18\ta\tdone\t2.5\t\n";
  write_status(place, "a", {Kind::done, 2.5, {}});
  EXPECT_EQ(read_states(place).at("a").kind, Kind::done);
  EXPECT_EQ(read_states(place).at("a").seconds, 2.5);
  std::filesystem::create_directories(place.lock("a").parent_path());
  const auto lock = io::FileLock::try_take(place.lock("a"));
  EXPECT_EQ(read_states(place).at("a").kind, Kind::running);
}

TEST(Journal, ALineThatWasCutShortIsPassedOver) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  std::filesystem::create_directories(place.journal());
  std::ofstream(place.journal() / "1.log") << "17\ta\tdone\t1\t\n18\ta\tfail";
  EXPECT_EQ(read_states(place).at("a").kind, Kind::done);
}

TEST(FileLock, IsHeldByOneAndGoneWithItsProcess) {
  const test::TemporaryFolder folder;
  const auto file = folder / "lock";
  {
    const auto lock = io::FileLock::try_take(file);
    ASSERT_TRUE(lock);
    EXPECT_TRUE(io::FileLock::is_held(file));
    EXPECT_FALSE(io::FileLock::try_take(file));
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  const pid_t child = fork();
  if (child == 0) {
    const auto lock = io::FileLock::try_take(file);
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(io::FileLock::is_held(file));
  EXPECT_TRUE(io::FileLock::try_take(file));
}

TEST(Store, CountsWhatWasComputedAndWhatThatSavedOthers) {
  const test::TemporaryFolder folder;
  const workflow::Store store(folder / "store");
  const workflow::PlannedStage packing{"packing", "abcdef", "01-packing-abcdef.h5", false},
      load{"load", "ab0000", "02-load-ab0000.h5", true};
  std::ofstream(folder / "made") << "bytes";
  EXPECT_FALSE(store.fetch(packing.hash, folder / "taken"));
  store.note(workflow::Store::Event::begun, packing, 1.5);
  store.put(packing.hash, folder / "made");
  store.note(workflow::Store::Event::computed, packing, 2);
  store.note(workflow::Store::Event::computed, load, 10);
  for (int k = 0; k < 3; ++k) store.note(workflow::Store::Event::reused, packing);
  ASSERT_TRUE(store.fetch(packing.hash, folder / "taken"));
  std::stringstream text;
  text << std::ifstream(folder / "taken").rdbuf();
  EXPECT_EQ(text.str(), "bytes");
  const auto account = workflow::read_account(folder / "store");
  EXPECT_EQ(account.computed, 2u);
  EXPECT_EQ(account.reused, 3u);
  EXPECT_EQ(account.seconds_saved, 10.5);
  EXPECT_EQ(account.seconds_computed, 13.5);
  EXPECT_EQ(account.by_name.at("packing").sum, 3.5);
}

TEST(FlatNumbers, HaveDottedNamesAndTheirErrors) {
  const Numbers tree =
      test::numbers_of(R"({"a": {"value": 1.5, "error": 0.1}, "b": {"c": 2, "words": "x", "curve": [1, 2, 3, 4, 5]},
    "sigma": {"value": [[1, 2], [3, 4]], "error": [[0.1, 0.2], [0.3, null]]}, "stages": [{"name": "load", "n": 7}],
    "none": null, "provenance": {"seed": 1}})");
  std::string text;
  for (const auto& [name, e, meaning] : flat_numbers(tree))
    text += name + "=" + std::to_string(e.value).substr(0, 3) +
            (std::isfinite(e.error) ? "+-" + std::to_string(e.error).substr(0, 3) : "") + " ";
  EXPECT_EQ(
      text,
      "a=1.5+-0.1 b.c=2.0 sigma.0.0=1.0+-0.1 sigma.0.1=2.0+-0.2 sigma.1.0=3.0+-0.3 sigma.1.1=4.0 stages.load.n=7.0 ");
}

TEST(Collect, HeadsHaveTheUnitsThatTheNamesDoNotSay) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  const Study study = synthetic(1, 1);
  const std::filesystem::path run = place.run(study.runs[0].name);
  std::filesystem::create_directories(run);
  Numbers j;
  statistics::put(j, "stress", {{"value", {1.0, 2.0}}, {"error", {0.5, nullptr}}}, "Pa", "Mean stress");
  statistics::put(j, "modulus_Pa", 3.0, "Pa", "Apparent modulus");
  statistics::put(j, "toughness_Pa_m0.5", Numbers{{"matrix", 4.0}}, "Pa m^0.5", "Fracture toughness");
  statistics::put(j, "work_J_per_m", 5.0, "J/m", "Work of the load");
  statistics::put(j, "rate_grains_s", 6.0, "1/s", "Rate of discharge");
  statistics::put(j, "z", 7.0, "", "Coordination number");
  keep_numbers(run, j);
  write_status(place, study.runs[0].name, {Kind::done, 1, {}});
  const auto table = collect(study, place);
  const std::string csv = table.csv(), head = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(
      head.ends_with(",stress.0 [Pa],stress.0_error [Pa],stress.1 "
                     "[Pa],modulus_Pa,toughness_Pa_m0.5.matrix,work_J_per_m,rate_grains_s,z"))
      << head;
  EXPECT_EQ(test::numbers_of(table.json())[0]["numbers"]["stress.0"],
            (Numbers{{"value", 1.0}, {"error", 0.5}, {"unit", "Pa"}}));
  EXPECT_TRUE(averaged(table, {study.keys[0]}).csv().find(",stress.0 [Pa],") != std::string::npos);
}

TEST(Collect, MeansOverReplicatesCarryTheStandardErrorOfTheScatter) {
  const test::TemporaryFolder folder;
  const StudyFolder place(folder.path());
  Study study = synthetic(6, 2);
  for (auto& run : study.runs) run.values[0].second = "\"" + run.values[0].second + " mm\"";
  for (std::size_t r = 0; r < 5; ++r) {
    std::filesystem::create_directories(place.run(study.runs[r].name));
    keep_numbers(place.run(study.runs[r].name), {{"x", {{"value", r}, {"error", 0.5}}}});
    write_status(place, study.runs[r].name, {Kind::done, 1, {}});
  }
  const auto table = collect(study, place);
  EXPECT_EQ(
      table.csv(),
      "run,status,cement.width [mm],seed,x,x_error\nrun0,done,0,0,0,0.5\nrun1,done,1,0,1,0.5\nrun2,done,0,1,2,0.5\n"
      "run3,done,1,1,3,0.5\nrun4,done,0,2,4,0.5\nrun5,waiting,1,2,,\n");
  // 0, 2, 4: mean 2, standard deviation 2, error 2/sqrt(3); 1, 3: mean 2, standard deviation sqrt(2), error 1.
  const auto means = averaged(table, {"cement.width"});
  ASSERT_EQ(means.rows.size(), 2u);
  EXPECT_EQ(means.rows[0].runs, 3u);
  EXPECT_EQ(means.rows[0].numbers[0].value, 2);
  EXPECT_NEAR(means.rows[0].numbers[0].error, 2 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(means.rows[1].numbers[0].error, 1, 1e-15);
  EXPECT_TRUE(means.csv().starts_with("cement.width [mm],runs,x,x_error\n0,3,2,1.15470")) << means.csv();
  EXPECT_THROW(averaged(table, {"cement.widht"}), InputError);
}

TEST(StudyFolder, RunsOfVersion01AreLeftWithASentence) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "study.toml";
  std::ofstream(file) << test::small_study;
  const StudyFolder place(folder / "out");
  std::filesystem::create_directories(place.run("fedcba9876543210"));
  std::ofstream(place.run("fedcba9876543210") / "numbers.json") << "{\"x\": 7}";
  write_status(place, "fedcba9876543210", {Kind::done, 1, {}});
  const Study study = read_study(file, {}, folder / "out");
  ASSERT_EQ(study.notices.size(), 1u);
  EXPECT_EQ(study.notices[0], "runs of version 0.1 in " + (folder / "out/runs").string() +
                                  " (1) are not reused; all runs are computed again beside them");
  EXPECT_EQ(result_of(place, study.runs[1]).state.kind, Kind::waiting);
}

TEST(StudyFolder, NumbersThatAreNotFiniteAreKeptAsUnknown) {
  const test::TemporaryFolder folder;
  keep_numbers(folder.path(), {{"a", std::nan("")}, {"b", {1.5, 2}}, {"c", "word"}});
  const Numbers read = numbers_of(folder.path());
  EXPECT_FALSE(read["a"].is_known());
  EXPECT_EQ(to_json(read), "{\"a\":null,\"b\":[1.5,2],\"c\":\"word\"}");
}

}  // namespace
}  // namespace arenite::campaign
