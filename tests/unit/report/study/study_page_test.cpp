#include "report/study/study_page.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "support/numbers_of.hpp"
#include "support/study_table.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::report {
namespace {

using test::figures_of, test::no_numbers, test::study_table;

std::string study_page(const StudyPage& page) {
  const test::TemporaryFolder folder;
  write_study_page(folder / "study.html", page);
  return io::read_file((folder / "study.html").string());
}

TEST(StudyPage, DrawsTheFirstRunThatAFigureWants) {
  StudyPage page{"S", figures_of("kind = \"stresses\"\nwhere = { gamma = 1, cement = \"full\" }"), study_table(),
                 no_numbers};
  page.drawing = [](const std::string& run, const Figure& figure) {
    return Numbers{{"run", run + word_for(figure.kind)}};
  };
  EXPECT_NE(study_page(page).find("\"sample\":{\"run\":\"6stresses\"}"), std::string::npos);
}

TEST(StudyPage, LeavesItsFiguresAsNumbersBesideIt) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(figures_on(folder / "study.html").is_known());
  StudyPage page{"A <study>", figures_of("kind = \"zoom\""), study_table(), no_numbers};
  page.drawing = [](const std::string&, const Figure&) { return Numbers{{"stress", {0.1, nullptr, 3}}}; };
  write_study_page(folder / "study.html", page);
  const Numbers shown = figures_on(folder / "study.html");
  EXPECT_EQ(shown["title"], Numbers("A <study>"));
  ASSERT_EQ(shown["figures"].size(), 1u);
  EXPECT_NE(study_page(page).find("\"figures\":" + to_json(shown["figures"], -1)), std::string::npos);
}

TEST(StudyPage, SaysWhyARunIsNotDrawnAndWhichCurvesAreNotThereYet) {
  StudyPage page{"S", figures_of("kind = \"film\""), study_table(), no_numbers};
  page.drawing = [](const std::string&, const Figure&) -> Numbers {
    throw InputError("/a/folder", 0, "no film of this run was made");
  };
  EXPECT_NE(study_page(page).find("\"missing\":\"Not drawn: no film of this run was made.\""), std::string::npos);
  page.figures = figures_of("kind = \"film\"\nwhere = { gamma = 7 }");
  EXPECT_NE(study_page(page).find("\"missing\":\"No run of this kind has finished yet.\""), std::string::npos);
  page.figures = figures_of("kind = \"rose\"\ncurves = [\"s\", \"film.s\"]\nnames = [\"simulation\", \"film\"]");
  page.numbers = [](const std::string&, const std::string& path, const Figure&) {
    return test::numbers_of(path == "s" ? R"({"s":[1,2]})" : "");
  };
  EXPECT_NE(study_page(page).find("\"missing\":\"No finished run has its numbers yet: film.\""), std::string::npos);
}

TEST(StudyPage, HoldsEveryFigureAndNoReferenceToOtherFiles) {
  const std::string page = study_page(
      {"A <study>", figures_of("x = \"gamma\"\ny = [\"z\"]\nsource = \"</script>\""), study_table(), no_numbers});
  EXPECT_NE(page.find("A &lt;study>"), std::string::npos);
  EXPECT_NE(page.find("\"id\":\"f\""), std::string::npos);
  EXPECT_EQ(page.find("\"source\":\"</script>"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("__FIGURES__"), std::string::npos);
}

}  // namespace
}  // namespace arenite::report
