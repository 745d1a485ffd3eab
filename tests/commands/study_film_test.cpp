#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "io/results/results.hpp"
#include "support/filmed_study.hpp"

namespace {
using namespace arenite;
namespace fs = std::filesystem;

const test::VirtualFilm& example() {
  static const test::VirtualFilm made;
  return made;
}

TEST(StudyFilm, IsMadeOnceAndKeptInTheStoreUntilItsCameraChanges) {
  const test::FilmedStudy study(example());
  ASSERT_TRUE(study.converged);
  EXPECT_THROW(campaign::film_numbers(study.folder()), InputError);
  EXPECT_FALSE(study.make(true));
  EXPECT_FALSE(campaign::has_film(study.folder()));

  ASSERT_TRUE(study.make());
  EXPECT_GT(campaign::film_number(study.folder(), "correlation"), 0.9);
  EXPECT_GT(campaign::film_numbers(study.folder())["found"]["x"].size(), 20u);
  EXPECT_FALSE(fs::exists(study.folder() / "film"));
  const auto before = study.account();
  const std::string bytes = test::slurp(study.file());

  ASSERT_TRUE(study.make());
  fs::remove(study.file());
  ASSERT_TRUE(study.make());
  EXPECT_EQ(study.account().computed, before.computed);
  EXPECT_EQ(study.account().reused, before.reused + 1);
  EXPECT_EQ(test::slurp(study.file()), bytes);

  study.film_with("blur = 0.7\n");
  ASSERT_TRUE(study.make());
  EXPECT_EQ(study.account().computed, before.computed + 1);
  EXPECT_NE(test::slurp(study.file()), bytes);

  study.film_with("blur = 0.7\n[correction]\nbad_pixels = false\n");
  ASSERT_TRUE(study.make());
  EXPECT_EQ(study.account().computed, before.computed + 2) << "another correction is another film";
  study.film_with("blur = 0.7\n[correction]\nbad_pixels = true\n");
  ASSERT_TRUE(study.make());
  EXPECT_EQ(study.account().computed, before.computed + 2) << "a default is none";

  Numbers former = io::read_numbers_file(study.file());
  former["grains"] = campaign::film_number(study.folder(), "count");
  former["correlation"] = 0.75;
  Numbers kept = Numbers::tree();
  for (const char* name : {"input_hash", "grains", "correlation", "found"}) kept[name] = Numbers(former[name]);
  const std::string blurred = test::slurp(study.file());
  for (const std::string& damaged : {blurred.substr(0, blurred.size() / 2), std::string()}) {
    fs::remove(study.file());
    std::ofstream(study.file(), std::ios::binary) << damaged;
    ASSERT_TRUE(study.make());
    EXPECT_EQ(test::slurp(study.file()), blurred);
  }

  io::write_numbers_file(study.file(), kept);  // as they were named in version 0.1
  EXPECT_EQ(campaign::film_number(study.folder(), "count"), kept["grains"].get<double>());
  EXPECT_EQ(campaign::film_number(study.folder(), "correlation"), 0.75);
}

}  // namespace
