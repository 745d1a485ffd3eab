#include <gtest/gtest.h>

#include <algorithm>

#include "io/disk/file.hpp"
#include "io/export/export.hpp"
#include "io/results/results.hpp"
#include "support/film_page_sample.hpp"
#include "support/program.hpp"
#include "workflow/export_result.hpp"

namespace {

using namespace arenite;

const io::ExportFormat& format(const std::string& name) {
  if (const auto* known = io::format_named(io::exports::all, name)) return *known;
  throw std::logic_error(name);
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(ExportFilm, GrainsAndForcesBecomeTables) {
  const test::TemporaryFolder folder;
  const test::FilmPageSample made(60, 4e-3);
  io::write_film_result(folder / "f.h5", made.film);
  const auto files = workflow::export_result(folder / "f.h5", format("csv"), folder / "csv", false);
  std::string all, grains;
  for (const auto& file : files) {
    const std::string text = io::read_file(file);
    if (file.filename().string().find("grains") != std::string::npos) grains = text;
    all += text;
  }
  EXPECT_NE(grains.find("sigma_hyd_error"), std::string::npos);
  EXPECT_NE(all.find(",sliding_velocity [m/s],fn_error [N],ft_error [N],presence\n"), std::string::npos);
  EXPECT_EQ(lines_in(grains), made.film.packing.grains.size() + 1);
  EXPECT_GT(lines_in(all), made.film.packing.grains.size() + made.film.packing.contacts.size());
}

TEST(ExportFilm, VtkTakesItToo) {
  const test::TemporaryFolder folder;
  const test::FilmPageSample made(30, 4e-3);
  io::write_film_result(folder / "f.h5", made.film);
  EXPECT_GE(workflow::export_result(folder / "f.h5", format("vtk"), folder / "vtk", true).size(), 3u);
}

}  // namespace
