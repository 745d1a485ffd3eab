#include <gtest/gtest.h>

#include <algorithm>

#include "report/figures/film_figures.hpp"
#include "report/figures/film_forces.hpp"

using namespace arenite;
using namespace arenite::report::figures;

namespace {

FilmResult film_of_forces() {
  FilmResult film;
  film.packing.contacts.i = film.packing.contacts.j = {0, 1, 2, 3, 4};
  film.packing.contacts.fn = {100, 50, 1, -3, 9};
  film.packing.contacts.ft.assign(5, 0.0);
  film.fn_error = film.ft_error = std::vector<double>(5, 1.0);
  film.presence = {1, 1, 0.6, 1, 0.9};
  return film;
}

}  // namespace

TEST(FilmForces, ContactsThatMayBeAbsentAreToldApart) {
  const FilmResult film = film_of_forces();
  const inference::FilmStresses none;
  const Drawings drawings = ranked_forces({film, none});
  ASSERT_EQ(drawings.size(), 2u);
  EXPECT_EQ(drawings[0].key[0].name, "3 present");
  EXPECT_EQ(drawings[0].key[1].name, "2 may be absent");
  EXPECT_EQ(drawings[0].panels[0].series[1].x, (std::vector<double>{3, 4}));  // their ranks
  EXPECT_EQ(drawings[0].panels[0].series[1].error, (std::vector<double>{1, 1}));
}

TEST(FilmForces, EveryContactIsInABarOfItsCertainty) {
  const FilmResult film = film_of_forces();
  const inference::FilmStresses none;
  const Panel panel = certainty({film, none}).front().panels.front();
  double all = 0;
  for (const Series& series : panel.series)
    for (const double count : series.y) all += count;
  EXPECT_EQ(all, 5);
  EXPECT_EQ(panel.corner, (std::vector<std::string>{"1 beyond 50 in the last bar"}));
  double tallest = 0;
  for (const double top : panel.series.back().high) tallest = std::max(tallest, top);
  EXPECT_GT(panel.y.high.value_or(0), 1.2 * tallest);  // the words stand above the bars
}
