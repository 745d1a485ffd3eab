#include "io/results/results.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "support/sample_results.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using arenite::test::TemporaryFolder;

io::Checkpoint some_checkpoint() {
  io::Checkpoint c;
  c.key = "abc";
  c.blobs["engine"] = std::vector<std::uint8_t>(100'000, 7);
  c.blobs["empty"] = {};
  c.numbers = {{"target [N]", 5e4}, {"drag", 0.1}};
  c.integers = {{"increment", 3}, {"step", -1}};
  c.partial = test::two_snapshots();
  return c;
}

TEST(Checkpoint, GivesBackWhatARunNeedsToGoOn) {
  const TemporaryFolder folder;
  const auto c = some_checkpoint();
  io::write_checkpoint(folder / "c", c);
  const auto read = io::read_checkpoint(folder / "c", "abc");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->blobs, c.blobs);
  EXPECT_EQ(read->numbers, c.numbers);
  EXPECT_EQ(read->integers, c.integers);
  EXPECT_EQ(read->partial.snapshots.size(), 2u);
  EXPECT_EQ(read->partial.history.columns[1].values, c.partial.history.columns[1].values);
}

TEST(Checkpoint, OfAnotherRunOrNoneStartsAnew) {
  const TemporaryFolder folder;
  EXPECT_FALSE(io::read_checkpoint(folder / "none", "abc"));
  io::write_checkpoint(folder / "c", some_checkpoint());
  EXPECT_FALSE(io::read_checkpoint(folder / "c", "another key"));
}

TEST(Checkpoint, CutShortIsAnInputErrorAndAStageFileIsNoCheckpoint) {
  const TemporaryFolder folder;
  io::write_checkpoint(folder / "c", some_checkpoint());
  const auto whole = io::read_file(folder / "c");
  io::write_atomically(folder / "c", std::string_view(whole).substr(0, whole.size() / 2));
  EXPECT_THROW(io::read_checkpoint(folder / "c", "abc"), InputError);
  io::write_stage(folder / "r.h5", test::two_snapshots());
  EXPECT_THROW(io::read_checkpoint(folder / "r.h5", "abc"), InputError);
}

}  // namespace
