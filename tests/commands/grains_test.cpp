#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/image/image.hpp"
#include "io/sample/placed_grains.hpp"
#include "support/drawn_picture.hpp"
#include "support/films.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// Twelve grains of two sizes and materials that stand on row 55 and against column 5.
std::vector<test::DrawnDisk> some_disks() {
  std::vector<test::DrawnDisk> disks;
  for (int k = 0; k < 8; ++k) disks.push_back({10.0 + 10 * k, 50, 5, k % 2 == 0 ? 0.6 : 1.0, k % 2});
  for (int k = 0; k < 4; ++k) disks.push_back({14.0 + 18 * k, 35.5, 8, 1.0, 1});
  return disks;
}

void write_picture(const std::filesystem::path& path, const std::vector<test::DrawnDisk>& disks, double noise = 0.01) {
  const FloatImage image = test::draw(disks, {.width = 100, .height = 70, .background = 0.1, .noise = noise});
  io::ColourPicture picture{image.width, image.height, {}};
  for (const float v : image.value)
    picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(std::clamp(std::lround(200 * v), 0L, 255L)));
  io::write_png(path, picture);
}

void expect_refused(const std::string& arguments, const std::string& file, const std::string& part) {
  const auto run = arenite("grains " + arguments);
  EXPECT_EQ(run.status, 2) << arguments;
  EXPECT_EQ(run.out, "") << arguments;
  EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

TEST(GrainsCommand, WritesATableThatASimulationStartsFrom) {
  const TemporaryFolder folder;
  write_picture(folder / "a.png", some_disks());
  const auto run =
      arenite("grains " + (folder / "a.png").string() +
              " --radii \"8 mm,12.8 mm\" --pixel \"1.6 mm\" --materials POM,HDPE --origin 5,55 --json --out " +
              (folder / "o").string());
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = Json::parse(run.out);
  EXPECT_EQ(j["grains"], 12);
  EXPECT_EQ(j["sizes"][0]["grains"], 8);
  EXPECT_EQ(j["materials"][0]["name"], "POM");
  EXPECT_EQ(j["materials"][0]["grains"], 4);
  EXPECT_EQ(test::slurp(folder / "o" / "grains.json"), run.out);
  Domain frame;
  frame.wall[right].position = 0.15;
  frame.wall[top].position = 0.08;
  std::vector<std::string> notes;
  const Grains grains = io::read_placed_grains(folder / "o" / "grains.csv",
                                               {{"HDPE", 950, 6e6, 0}, {"POM", 1400, 27e6, 0}}, frame, notes);
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(grains.size(), 12u);
  for (const auto& d : some_disks()) {
    int at = 0;
    for (std::size_t g = 0; g < grains.size(); ++g)
      if (std::hypot(grains.position[g].x - (d.x - 5) * 1.6e-3, grains.position[g].y - (55 - d.y) * 1.6e-3) <
              0.05 * 1.6e-3 &&
          std::abs(grains.radius[g] - d.radius * 1.6e-3) < 0.1e-3) {
        ++at;
        EXPECT_EQ(grains.material[g], d.level < 0.8 ? 1 : 0);
      }
    EXPECT_EQ(at, 1) << d.x << " " << d.y;
  }
  const Image overlay = io::read_image(folder / "o" / "grains.png", {.channel = io::Channel::red});
  EXPECT_EQ(overlay.width, 400);
  EXPECT_EQ(overlay.height, 280);
}

TEST(GrainsCommand, CountsFromTheLowerLeftCornerOfThePicture) {
  const TemporaryFolder folder;
  write_picture(folder / "a.png", some_disks());
  ASSERT_EQ(
      arenite("grains " + (folder / "a.png").string() + " --contrast bright --out " + folder.path().string()).status,
      0);
  const std::string table = test::slurp(folder / "grains.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "id,x,y,radius,material,position_error,radius_error,brightness,score");
  EXPECT_NE(table.find("class1"), std::string::npos);
  std::istringstream lines(table);
  std::string line;
  for (int k = 0; k < 3; ++k) std::getline(lines, line);  // the first grain: column 14, row 35.5
  double x = 0, y = 0, r = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "0,%lf,%lf,%lf", &x, &y, &r), 3) << line;
  EXPECT_NEAR(r, 8, 0.1);
  EXPECT_NEAR(std::fmod(x - 14.5, 18), 0, 0.1);
  EXPECT_NEAR(y, 70 - 0.5 - 35.5, 0.1);
}

TEST(GrainsCommand, WritesATableInPixelsThatMeasureReads) {
  const TemporaryFolder folder;
  std::vector<test::DrawnDisk> row;  // six in a row that touch, and one apart
  for (int k = 0; k < 6; ++k) row.push_back({20.0 + 10 * k, 50, 5, 1.0, 0});
  row.push_back({50, 20, 5, 1.0, 0});
  write_picture(folder / "a.png", row);
  ASSERT_EQ(arenite("grains " + (folder / "a.png").string() + " --radii 5 --out " + folder.path().string()).status, 0);
  const std::string table = (folder / "grains.csv").string();
  const auto refused = arenite("measure " + table + " --pixel \"1.6 mm\"");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("give the file of contacts after that of the grains, or --touching"), std::string::npos)
      << refused.err;
  const auto in_pixels = arenite("measure " + table + " --touching \"0.8 mm\"");
  EXPECT_EQ(in_pixels.status, 2);
  EXPECT_NE(in_pixels.err.find("grains.csv:1: lengths are in pixels (px)"), std::string::npos) << in_pixels.err;
  EXPECT_NE(in_pixels.err.find("--pixel \"1.6 mm\""), std::string::npos) << in_pixels.err;
  EXPECT_EQ(std::count(in_pixels.err.begin(), in_pixels.err.end(), '\n'), 1) << in_pixels.err;

  const auto run = arenite("measure " + table + " --touching \"0.8 mm\" --pixel \"1.6 mm\" --json --curves");
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = Json::parse(run.out);
  EXPECT_EQ(j["grains"], 7);
  EXPECT_EQ(j["contacts"], 5);
  EXPECT_NEAR(j["mean_diameter_m"].get<double>(), 0.016, 0.0002);
  EXPECT_NEAR(j["coordination"]["all"]["value"].get<double>(), 10.0 / 7, 1e-12);
  EXPECT_NEAR(j["fabric"]["a_c"]["value"].get<double>(), 2, 0.01);  // all contacts lie along x
  for (const char* name : {"stress", "stress_details", "force", "sigma_norm"}) EXPECT_FALSE(j.contains(name)) << name;
  for (const char* name : {"rattlers", "without_rattlers"}) EXPECT_FALSE(j["coordination"].contains(name)) << name;
  for (const char* name : {"a_n", "a_c_signed", "load_axis_deg"}) EXPECT_FALSE(j["fabric"].contains(name)) << name;
  EXPECT_EQ(j["fabric"].dump().find("weak"), std::string::npos);
  EXPECT_TRUE(j["fabric"].contains("sectors") && !j["fabric"].contains("sector_force_N"));
  EXPECT_FALSE(j["quality"].contains("negative_forces")) << "nothing is known of forces";
  const auto along = arenite("measure " + table + " --touching \"0.8 mm\" --pixel \"1.6 mm\" --json --load-axis 0");
  EXPECT_NEAR(Json::parse(along.out)["fabric"]["a_c_signed"]["value"].get<double>(), 2, 0.01)
      << "the axis of the load is said, no force tells it";
  EXPECT_EQ(arenite("measure " + table + " " + table + " --touching \"0.8 mm\"").status, 2);
  EXPECT_EQ(arenite("measure " + table + " --touching 0 --pixel \"1.6 mm\"").status, 2);
}

TEST(GrainsCommand, FindsTheApertureOfABlackbodyOnceBadPixelsAreReplaced) {
  const std::string film = test::infrared("LWIR-BBref-150C-150us.ptw").string();
  const auto run = arenite("grains " + film + " --radii 71 --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = Json::parse(run.out);
  EXPECT_EQ(j["grains"], 1);
  EXPECT_EQ(j["frames"], 2);
  EXPECT_GT(j["bad_pixels_replaced"], 100);
  EXPECT_NEAR(j["by_grain"]["column_px"][0], 148, 1.5);
  EXPECT_NEAR(j["by_grain"]["row_px"][0], 100.5, 1.5);
  EXPECT_NEAR(j["by_grain"]["radius_px"][0], 71.3, 1.5);
  EXPECT_GT(j["by_grain"]["score"][0], 0.95);
  const Json frame = Json::parse(arenite("grains " + film + " --radii 71 --json --frame 1").out);
  EXPECT_EQ(frame["frames"], 1);
  EXPECT_NEAR(frame["by_grain"]["column_px"][0], j["by_grain"]["column_px"][0].get<double>(), 0.1);
  expect_refused(film + " --frame 2", film, "holds 2 frames; there is no frame 2");
}

TEST(GrainsCommand, RefusesPicturesWithoutGrainsInOneSentence) {
  const TemporaryFolder folder;
  write_picture(folder / "noise.png", {}, 0.02);
  write_picture(folder / "flat.png", {}, 0);
  write_picture(folder / "a.png", some_disks());
  const auto path = [&](const char* name) { return (folder / name).string(); };
  expect_refused(path("noise.png"), "noise.png: ", "no grains were found");
  expect_refused(path("flat.png"), "flat.png: ", "all pixels of the picture are equal");
  expect_refused(path("none.png"), "none.png", "");
  expect_refused(path("a.png") + " --radii \"8 mm\"", "--radii", "give --pixel");
  expect_refused(path("a.png") + " --radii 0.2", "--radii", "less than a pixel");
  expect_refused(path("a.png") + " --pixel \"0 mm\"", "--pixel", "must be above 0 mm");
  expect_refused(path("a.png") + " --origin 5", "--origin", "column and row");
  expect_refused(path("noise.png") + " --out " + path("o"), "noise.png: ", "no grains were found");
  EXPECT_FALSE(std::filesystem::exists(folder / "o"));
}

}  // namespace
