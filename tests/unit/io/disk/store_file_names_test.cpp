#include "io/disk/store_file.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using arenite::io::stage_file_name;
using arenite::io::stage_files;

TEST(RunFolder, ListsStagesInTheOrderOfTheLoading) {
  const test::TemporaryFolder folder;
  for (const auto& name : {stage_file_name(10, "unload", "f0"), stage_file_name(2, "a b/c", "e0"),
                           stage_file_name(1, "z", "d0"), std::string("report.html"), std::string(".01-z-d0.h5.tmp")})
    io::write_atomically(folder / name, "x");
  const auto files = stage_files(folder.path());
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].filename(), "01-z-d0.h5");
  EXPECT_EQ(files[1].filename(), "02-a-b-c-e0.h5");
  EXPECT_EQ(files[2].filename(), "10-unload-f0.h5");
}

TEST(RunFolder, NamesHoldTheFirstTwelveDigitsOfTheHash) {
  const std::string hash = "27aea0a6ba881cd7d92e7f41f8cf3980";
  EXPECT_EQ(stage_file_name(1, "packing", hash), "01-packing-27aea0a6ba88.h5");
}

TEST(RunFolder, AFileIsItsOwnList) { EXPECT_EQ(stage_files("some.h5"), std::vector<std::filesystem::path>{"some.h5"}); }

TEST(RunFolder, WithoutStagesIsAnInputError) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(stage_files(folder.path()), InputError);
}

}  // namespace
