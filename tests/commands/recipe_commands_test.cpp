#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>

#include "io/disk/file.hpp"
#include "support/program.hpp"
#include "support/small_study.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::contains;
using test::shell;
using test::slurp;
using test::TemporaryFolder;

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Check, PrintsTheResolvedRecipeWhichChecksAsTheSame) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string(), resolved = (folder / "b.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto first = arenite("check " + recipe);
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_TRUE(contains(first.out, "restitution = 0.5\n"));
  std::ofstream(resolved) << first.out;
  const auto second = arenite("check " + resolved);
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
}

TEST(Check, OverridesMayBeRepeatedAndStandBeforeTheRecipe) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto changed = arenite("check --set seed=77 --set 'stages.1.bottom.force=60 kN' " + recipe);
  EXPECT_EQ(changed.status, 0) << changed.err;
  EXPECT_TRUE(contains(changed.out, "seed = 77\n"));
  EXPECT_TRUE(contains(changed.out, "bottom = { force = \"60 kN\" }\n"));
}

TEST(Check, BadRecipeGivesOneLineAProblemOnStderrAndStatusTwo) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto refused =
      arenite("check " + recipe + " --set container.width=350 --set sed=3 --set 'contact.friction=-1'");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(lines_of(refused.err), 3) << refused.err;
  EXPECT_TRUE(contains(refused.err, "did you mean seed?"));
}

TEST(Check, WhatIsNoFileIsBadInput) {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty.toml").flush();
  for (const auto& file : {(folder / "none.toml").string(), folder.path().string(), (folder / "empty.toml").string()}) {
    const auto refused = arenite("check " + file);
    EXPECT_EQ(refused.status, 2) << file;
    EXPECT_EQ(lines_of(refused.err), 1) << refused.err;
    EXPECT_TRUE(contains(refused.err, file)) << refused.err;
  }
}

TEST(Check, ReadsARecipeOfAFilmAsWhatItIs) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "film.toml").string(), resolved = (folder / "b.toml").string();
  ASSERT_EQ(arenite("init film " + recipe).status, 0);
  const auto first = arenite("check " + recipe);
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_TRUE(contains(first.out, "[lockin]\n"));
  std::ofstream(resolved) << first.out;
  EXPECT_EQ(arenite("check " + resolved).out, first.out);
  const auto slip = arenite("check " + recipe + " --set lockin.frequency=3");
  EXPECT_EQ(slip.status, 2);
  EXPECT_EQ(lines_of(slip.err), 1) << slip.err;
  const auto refused = arenite("run " + recipe);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(lines_of(refused.err), 1) << refused.err;
  EXPECT_TRUE(contains(refused.err, "film.toml: is the recipe of a film (`arenite film FILM --recipe ")) << refused.err;
}

TEST(Check, QuietPrintsWhatIsWrongAlone) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto right = arenite("check --quiet " + recipe), wrong = arenite("check --quiet --set sed=3 " + recipe);
  EXPECT_EQ(right.status, 0);
  EXPECT_EQ(right.out + right.err, "");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(lines_of(wrong.err), 1) << wrong.err;
}

TEST(Check, PredictsTheRunOnStderrAndAsNumbers) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto text = arenite("check " + recipe);
  EXPECT_EQ(text.status, 0);
  for (const char* part : {"time step ", "prepare ", "load ", "total ", "warning: stage load: grains overlap"})
    EXPECT_TRUE(contains(text.err, part)) << part;
  const auto json = nlohmann::json::parse(arenite("check --json " + recipe).out);
  EXPECT_EQ(json["grains"], 705);
  EXPECT_GT(json["time_step_s"], 0);
  EXPECT_LE(json["time_step_s"], json["largest_stable_step_s"]);
  ASSERT_EQ(json["stages"].size(), 2u);
  EXPECT_EQ(json["stages"][1]["exact"], false);
  EXPECT_NEAR(json["stages"][1]["pressure_Pa"].get<double>(), 50e3 / (0.35 * 0.06), 1);
  EXPECT_TRUE(contains(json["recipe"], "restitution = 0.5\n"));
}

TEST(Check, OfAStudyTellsItsRunsKeysAndWhatEachWillBe) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "study.toml").string();
  io::write_atomically(recipe, test::small_packing_recipe + R"(solid_fraction = 0.7
[[stages]]
name = "shear"
right = { pressure = "20 kPa" }
top = { velocity = "10 mm/s" }
duration = "1 s"
snapshots = 5
[sweep.grid]
"stages.shear.duration" = ["0.5 s", "1 s"]
"contact.friction" = [0.1, 0.3, 0.5, 0.7, 0.9]
)");
  const auto text = arenite("check " + recipe);
  ASSERT_EQ(text.status, 0) << text.err;
  for (const char* part : {"10 runs of stages.shear.duration, contact.friction",
                           "8 of them:", "stages.shear.duration = \"0.5 s\", contact.friction = 0.1\n  60 grains",
                           "stages.shear.duration = \"1 s\", contact.friction = 0.9\n", "shear: 5 states, strain "})
    EXPECT_TRUE(contains(text.out, part)) << part << text.out;
  const auto json = nlohmann::json::parse(arenite("check --json " + recipe).out);
  EXPECT_EQ(json["runs"], 10);
  const auto strain = [&](std::size_t k) { return json["predicted"][k]["stages"][0]["strain"].get<double>(); };
  EXPECT_NEAR(strain(7) / strain(0), 2, 1e-6) << "twice as long at the same speed";
  const auto wrong = arenite("check " + recipe + " --set contact.restitution=7");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(lines_of(wrong.err), 1) << wrong.err;
}

TEST(Check, OfASampleThatCannotBeMadeIsNoRefusal) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto checked = arenite("check " + recipe + " --set 'container.height=\"10 mm\"'");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_TRUE(contains(checked.err, "warning: `arenite run` will refuse this: ")) << checked.err;
}

TEST(Init, StudyRunsAsItIs) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "friction.toml").string(), out = (folder / "out").string();
  const auto made = arenite("init study " + recipe);
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "now `arenite study run ")) << made.out;
  const auto done = arenite("study run --quiet " + recipe + " --out " + out);
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_TRUE(contains(done.out, "6 runs: 6 done")) << done.out;
}

TEST(Init, RefusesToOverwriteAndLeavesTheFileAsItIs) {
  const TemporaryFolder folder;
  const auto recipe = folder / "a.toml";
  std::ofstream(recipe) << "mine";
  const auto refused = arenite("init composite " + recipe.string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(lines_of(refused.err), 1);
  EXPECT_EQ(slurp(recipe), "mine");
}

TEST(Init, FolderThatIsNotThereIsBadInputAndNothingIsLeft) {
  const TemporaryFolder folder;
  EXPECT_EQ(arenite("init composite " + (folder / "none/a.toml").string()).status, 2);
  EXPECT_EQ(folder.count(), 0);
}

TEST(Output, FullDiskBehindStdoutIsReported) {
  for (const char* command : {"init composite", "man --keys", "man", ""}) {
    const auto full = shell(std::string(ARENITE_BINARY " ").append(command).append(" > /dev/full"));
    EXPECT_EQ(full.status, 2) << command;
    EXPECT_EQ(lines_of(full.err), 1) << full.err;
  }
  const TemporaryFolder folder;
  const std::string recipe = (folder / "a.toml").string();
  ASSERT_EQ(arenite("init composite " + recipe).status, 0);
  const auto full = shell(ARENITE_BINARY " check " + recipe + " > /dev/full");
  EXPECT_EQ(full.status, 2);
  EXPECT_NE(full.err.find("the output could not be written; make room"), std::string::npos) << full.err;
}

TEST(Man, ThePageOfFileFormatsIsWhatTheFormatsSay) {
  EXPECT_EQ(slurp(ARENITE_SOURCE_DIR "/docs/formats.md"), arenite("man --formats").out)
      << "write it anew: build/arenite man --formats > docs/formats.md";
}

TEST(CommandLine, WithoutArgumentsEveryCommandHasItsLine) {
  const auto overview = arenite("");
  EXPECT_EQ(overview.status, 0);
  for (const char* command : {"init", "check", "doctor", "completion", "man"}) {
    EXPECT_TRUE(contains(overview.out, std::string("\n  ") + command + " ")) << command;
    EXPECT_EQ(arenite(std::string(command) + " --help").status, 0) << command;
  }
  for (const char* kind : {"composite", "cemented", "film", "study"}) {
    EXPECT_TRUE(contains(overview.out, std::string("arenite init ") + kind + " r.toml")) << kind;
    EXPECT_EQ(arenite(std::string("init ") + kind).status, 0) << kind;
  }
}

TEST(CommandLine, UnknownCommandOffersTheNearestAndUnknownOptionIsBadInput) {
  const auto slip = arenite("chekc");
  EXPECT_EQ(slip.status, 2);
  EXPECT_TRUE(contains(slip.err, "did you mean `arenite check`?")) << slip.err;
  EXPECT_EQ(arenite("check --frobnicate x.toml").status, 2);
  EXPECT_EQ(arenite("check").status, 2);
  EXPECT_EQ(arenite("--version").status, 0);
}

TEST(Doctor, NamesVersionsKernelsAndThreads) {
  const auto report = arenite("doctor");
  EXPECT_EQ(report.status, 0);
  for (const char* line : {"arenite ", "kernels ", "threads ", "HDF5 "})
    EXPECT_TRUE(contains(report.out, line)) << line;
}

TEST(Completion, ScriptsAreAcceptedByTheirShellAndKnowEveryCommand) {
  const auto bash = arenite("completion bash");
  EXPECT_EQ(bash.status, 0);
  const std::string load = "source <(" + std::string(ARENITE_BINARY) + " completion bash); ";
  const auto words = [&](const std::string& line, int word) {
    return shell("bash -c '" + load + "COMP_WORDS=(" + line + "); COMP_CWORD=" + std::to_string(word) +
                 "; _arenite; echo \"${COMPREPLY[@]}\"'")
        .out;
  };
  EXPECT_EQ(words("arenite che", 1), "check\n");
  EXPECT_TRUE(contains(words("arenite check --", 2), "--set"));
  EXPECT_EQ(words("arenite completion z", 2), "zsh\n");
  for (const char* shell_name : {"zsh", "fish"}) {
    const auto script = arenite(std::string("completion ") + shell_name);
    EXPECT_EQ(script.status, 0);
    for (const char* command : {"init", "check", "doctor"}) EXPECT_TRUE(contains(script.out, command)) << shell_name;
  }
  EXPECT_EQ(arenite("completion tcsh").status, 2);
}

TEST(Man, PageHasEveryCommandOfTheOverview) {
  const auto page = arenite("man");
  EXPECT_EQ(page.status, 0);
  EXPECT_TRUE(contains(page.out, ".TH ARENITE 1"));
  for (const char* command : {"check RECIPE.toml", "init [TEMPLATE]", "doctor", "completion SHELL"}) {
    EXPECT_TRUE(contains(page.out, std::string(".SS arenite ") + command)) << command;
  }
}

}  // namespace
