#include "workflow/result_folder.hpp"

#include <gtest/gtest.h>

#include "io/film/film.hpp"
#include "io/results/results.hpp"
#include "support/films.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::workflow {
namespace {

TEST(ResultFolder, KeepsResultsOfOtherSettingsAndSaysWhere) {
  const test::TemporaryFolder folder;
  StageResult packing;
  packing.name = "packing";
  io::write_stage(folder / "01-packing-0123.h5", packing);
  const ResultFolder out(folder.path(), {"01-packing-4567.h5"});
  EXPECT_TRUE(
      out.what_was_put_aside().starts_with("a result of other settings moved to " + (folder / "earlier").string()))
      << out.what_was_put_aside();
  EXPECT_TRUE(std::filesystem::exists(folder / "earlier/01-packing-0123.h5"));
}

TEST(ResultFolder, LeavesFilmsOfOtherProgramsAndResultsOfOtherKinds) {
  const test::TemporaryFolder folder;
  Film film = test::counted();
  io::write_film(folder / "film.h5", film);
  StageResult packing;
  packing.name = "packing";
  io::write_stage(folder / "01-packing-0123.h5", packing);
  FilmResult result;
  result.name = "film";
  io::write_film_result(folder / "01-film-0123.h5", result);
  { const ResultFolder out(folder.path(), {"01-film-4567.h5"}, "film"); }
  EXPECT_FALSE(std::filesystem::exists(folder / "01-film-0123.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "earlier/01-film-0123.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "01-packing-0123.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "film.h5"));
  const ResultFolder run(folder.path(), {"01-packing-4567.h5"});
  EXPECT_TRUE(std::filesystem::exists(folder / "earlier/01-packing-0123.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "film.h5"));
}

}  // namespace
}  // namespace arenite::workflow
