#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "report/page.hpp"
#include "report/study/study_page.hpp"
#include "support/field_page_sample.hpp"
#include "support/film_page_sample.hpp"
#include "support/numbers_of.hpp"
#include "support/page_sample.hpp"
#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/small_study.hpp"

using namespace arenite;

namespace {

/// Opens the page in a browser, where the test of that name in web/test asserts what is painted.
void expect_in_browser(const std::string& test, const std::filesystem::path& page) {
  const auto outcome = test::shell("node " ARENITE_SOURCE_DIR "/web/test/" + test + " " + page.string());
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

void expect_in_browser(const std::string& test, const report::PageData& data) {
  const test::TemporaryFolder folder;
  report::write_page(folder / "page.html", data);
  expect_in_browser(test, folder / "page.html");
}

}  // namespace

TEST(Page, IsPaintedAndAnswersInABrowserFromTheDisk) { expect_in_browser("page.test.mjs", test::PageSample().data); }

TEST(Page, OfABiaxialTestAnswersInABrowserFromItsPackingToItsEnd) {
  const test::TemporaryFolder folder;
  io::write_atomically(folder / "biaxial.toml", test::small_packing_recipe + R"(solid_fraction = 0.7
[contact]
friction = 0.3
wall_friction = 0
[[stages]]
name = "densify"
right = { pressure = "50 kPa" }
top = { pressure = "50 kPa" }
[[stages]]
name = "shear"
right = { pressure = "50 kPa" }
top = { velocity = "200 mm/s" }
duration = "0.1 s"
snapshots = 4
)");
  const std::string out = (folder / "out").string();
  const auto run = test::shell(ARENITE_BINARY " run " + (folder / "biaxial.toml").string() + " --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  expect_in_browser("run_page.test.mjs", out + "/report.html");
}

TEST(Page, OfACementedSampleIsPaintedAndAnswersInABrowser) {
  expect_in_browser("field_page.test.mjs", test::FieldPageSample().data);
}

TEST(Page, OfASampleInSpaceIsPaintedAndAnswersInABrowser) {
  // A column and a ball of grains in their matrix, which together join both clamps.
  const test::TemporaryFolder folder;
  const std::string map = (folder / "map.npy").string(), out = (folder / "out").string();
  const auto made = test::shell(
      "/usr/bin/python3 -c \"import numpy as np; z, y, x = np.mgrid[0:12, 0:12, 0:12]; "
      "r = np.minimum(np.hypot(x - 3.5, y - 3.5), np.sqrt((x - 8.5)**2 + (y - 8)**2 + (z - 8)**2) - 0.3); np.save('" +
      map + "', np.where(r < 2.2, 2, np.where(r < 4.3, 1, 0)).astype(np.uint8))\"");
  ASSERT_EQ(made.status, 0) << made.err;
  const auto loaded =
      test::shell(ARENITE_BINARY " load " + map +
                  " --phases 0=void,1=matrix,2=particle --dx '10 um' --loading shear --method elements --out " + out);
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  expect_in_browser("volume_page.test.mjs", out + "/report.html");
}

TEST(Page, OfASampleOfSpheresIsPaintedAndAnswersInABrowser) {
  const test::TemporaryFolder folder;
  io::write_atomically(folder / "triaxial.toml", test::small_triaxial);
  const std::string out = (folder / "out").string();
  const auto run = test::shell(ARENITE_BINARY " run " + (folder / "triaxial.toml").string() + " --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  expect_in_browser("sphere_page.test.mjs", out + "/report.html");
}

TEST(Page, OfAFilmIsPaintedAndAnswersInABrowser) {
  expect_in_browser("film_page.test.mjs", test::FilmPageSample().data);
}

TEST(Page, OfAStudyIsPaintedInABrowser) {
  const test::TemporaryFolder folder;
  campaign::CollectedTable table;
  table.keys = {{"gamma", ""}, {"width", ""}, {"seed", ""}};
  table.names = {"z"};
  for (const char* gamma : {"1", "5"})
    for (const char* width : {"", "0.2"})
      for (const char* seed : {"1", "2"})
        table.rows.push_back(
            {seed, "done", {gamma, width, seed}, 1, {campaign::Estimate{10 + std::stod(gamma) + std::stod(seed)}}});
  const auto figures = report::read_figures(
      "[[figures]]\nid = \"points\"\ntitle = \"Points\"\nx = \"gamma\"\ny = [\"z\"]\nby = \"width\"\nby_label = "
      "\"\u03b7\"\nby_empty = \"full\"\n"
      "x_label = \"gamma\"\nreferences = [ { y = 15, label = \"source: 15\" } ]\n"
      "[[figures]]\nid = \"density\"\ntitle = \"Density\"\ncurves = [\"pdf\"]\n"
      "[[figures]]\nid = \"rose\"\ntitle = \"Rose\"\nkind = \"rose\"\ncurves = [\"sectors\", \"strong\"]\nby = "
      "\"width\"\n"
      "[[figures]]\nid = \"map\"\ntitle = \"Map\"\nkind = \"map\"\nx = \"gamma\"\ny = [\"z\"]\nby = "
      "\"width\"\nby_empty = \"full\"\n"
      "[[figures]]\nid = \"forces\"\ntitle = \"Forces\"\nkind = \"forces\"\n"
      "[[figures]]\nid = \"stresses\"\ntitle = \"Stresses\"\nkind = \"stresses\"\n"
      "[[figures]]\nid = \"grains\"\ntitle = \"Grains\"\nkind = \"grains\"\n"
      "[[figures]]\nid = \"phases\"\ntitle = \"Phases\"\nkind = \"phases\"\n"
      "[[figures]]\nid = \"zoom\"\ntitle = \"Zoom\"\nkind = \"zoom\"\n"
      "[[figures]]\nid = \"cracks\"\ntitle = \"Cracks\"\nkind = \"cracks\"\n"
      "[[figures]]\nid = \"film\"\ntitle = \"Film\"\nkind = \"film\"\n"
      "[[figures]]\nid = \"beside\"\ntitle = \"Beside\"\ncurves = [\"pdf\", \"film.pdf\"]\nlines = false\n"
      "[[figures]]\nid = \"counts\"\ntitle = \"Counts\"\nkind = \"rose\"\ncounts = true\ncurves = [\"sectors\"]\n"
      "[[figures]]\nid = \"source\"\ntitle = \"Source\"\nx = \"gamma\"\ny = [\"z\"]\nwhere = { width = \"\" }\nspread "
      "= \"deviation\"\n"
      "beside = [{ name = \"0.2\", x = \"gamma\", y = \"z\", where = { width = 0.2 } }]\nsource_points = [{ name = "
      "\"T\", x = [1, 5], y = [12, 16] }]\n"
      "[[figures]]\nid = \"tails\"\ntitle = \"Tails\"\ncurves = [\"pdf\"]\nfits = [\"tail\"]\nreferences = [{ slope = "
      "1 }]\n",
      "figures.toml");
  const auto numbers = [](const std::string& run, const std::string&, const report::Figure&) {
    return test::numbers_of(std::string(run == "1" ? R"({"pdf":{"low":0,"width":1,"density":[0.2,0.5,0.3]},)"
                                                   : R"({"pdf":{"low":0,"width":1,"density":[0.3,0.5,0.2]},)") +
                            R"("sectors":[1,3,2,2],"strong":[4,1,1,2],
            "film":{"pdf":{"low":0,"width":1,"density":[0.3,0.4,0.3]}},"tail":{"slope":1,"low":0.5,"high":2.5}})");
  };
  const auto drawing = [](const std::string&, const report::Figure& figure) -> Numbers {
    if (figure.kind == report::FigureKind::film) throw InputError("no film of this run was made");
    if (figure.kind == report::FigureKind::phases)
      return test::numbers_of(R"({"size":[2,1],"nodes":[4,2],"phases":[0,3,1,4,4,1]})");
    if (figure.kind == report::FigureKind::cracks)
      return test::numbers_of(
          R"({"size":[4,2],"nodes":[4,2],"phases":[1,6,4,2],"cracks":{"x":[1,2.5,3],"y":[0.5,1,2],"type":[1,2,1]}})");
    if (figure.kind == report::FigureKind::zoom)
      return test::numbers_of(R"({"size":[2,1],"nodes":[2,1],"stress":[0.5,null],"edges":[[1,0,1]]})");
    const std::string grains = R"({"size":[20,10],"x":[5,15],"y":[5,5],"r":[5,5],"material":[0,1],"glued":[0,1],)";
    if (figure.kind == report::FigureKind::grains) return test::numbers_of(grains + R"("materials":["POM","HDPE"]})");
    return test::numbers_of(grains + (figure.kind == report::FigureKind::forces
                                          ? R"("i":[0],"j":[1],"f":[-0.5],"tension":-0.001})"
                                          : R"("stress":[0.5,1.5]})"));
  };
  report::write_study_page(folder / "study.html", {"A study", figures, table, numbers, drawing});
  expect_in_browser("study_page.test.mjs", folder / "study.html");
}

TEST(Page, OfTwoResultsIsPaintedInABrowser) {
  const test::TemporaryFolder folder;
  const auto document = test::numbers_of(
      R"json({"title":"A and B","runs":"","made":"","notation":"(x)?([_^])",
          "first":[{"title":"Tests","heads":["","A"],"rows":[{"cells":["peak q/p","0.5"]}]}],
          "figures":[{"id":"stress","title":"Stress","caption":"","drawing":{"panels":[{"x":{"label":"t"},"y":{"label":
          "q"},"series":[{"name":"A","colour":"line 0","line":"solid","x":[1,2],"y":[3,4]},{"name":"B","colour":
          "line 1","line":"solid","x":[1,2],"y":[4,5]}]}],"key":[{"name":"A","colour":"line 0"},{"name":"B","colour":
          "line 1"}]}}],
          "tables":[{"title":"load","heads":["number","A"],"rows":[{"cells":["z","3 ± 0.1"],"marked":true}],
          "more":[{"cells":["n","5"]}]}]})json");
  io::write_atomically(folder / "cmp.html", report::html_of(document));
  expect_in_browser("compare_page.test.mjs", folder / "cmp.html");
}

TEST(Page, OfARunUnderWayIsPaintedInABrowser) {
  const test::TemporaryFolder folder;
  std::string page =
      report::html_of(test::numbers_of(R"json({"title":"Arenite","live":true,"notation":"(x)?([_^])"})json"));
  const std::string head = "<head>", no_server = "<script>window.fetch = async () => { throw new Error(); };</script>";
  page.insert(page.find(head) + head.size(), no_server);
  io::write_atomically(folder / "live.html", page);
  expect_in_browser("live_page.test.mjs", folder / "live.html");
}

TEST(Page, PartsWriteNumbersAndPlacesAsTheirTestsSay) {
  const std::string folder = ARENITE_SOURCE_DIR "/web/test/";
  const auto outcome = test::shell("node --test " + folder + "parts.test.mjs " + folder + "packing_parts.test.mjs " +
                                   folder + "volume_parts.test.mjs " + folder + "sphere_parts.test.mjs");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}
