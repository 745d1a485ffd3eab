#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "io/film/film.hpp"
#include "model/image.hpp"
#include "recipe/film_recipe.hpp"
#include "support/disturbed_film.hpp"
#include "support/laboratory_film.hpp"
#include "support/laboratory_sample.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::test {

/// The recipe of a laboratory that knows everything of such a film but where its grains are.
inline recipe::FilmRecipe laboratory_recipe(const LaboratorySample& sample, const LaboratoryFilm& how,
                                            const DrawnFilm& drawn) {
  recipe::FilmRecipe recipe;
  const Packing& p = sample.packing;
  const double travel = how.travel * how.pixel;
  for (std::size_t m = 0; m < 2; ++m)
    recipe.materials.push_back({p.materials[m].name, p.materials[m].thermoelastic_factor, how.emissivity[m],
                                how.emissivity[m], p.materials[m].stiffness});
  // In the recipe the lower wall rests at height 0 at the smallest load.
  recipe.container = {.width = p.domain.wall[right].position,
                      .height = p.domain.wall[top].position + travel,
                      .thickness = p.domain.thickness,
                      .left = drawn.left,
                      .top = drawn.top_row,
                      .load_peak_to_peak = sample.load(),
                      .travel = travel};
  recipe.picture.pixel = how.pixel;
  recipe.temperature.from = recipe::TemperatureSection::From::film;
  recipe.temperature.assumed_emissivity = 1;
  recipe.temperature.ambient = how.ambient;
  recipe.lockin.frequency = how.frequency;
  recipe.forces.blur = how.blur;
  return recipe;
}

/// An ordinary camera's picture of the grains at the smallest load, three pixels to one of the film and with the same
/// middle: black and white grains on grey.
inline std::string optical_picture(const LaboratorySample& sample, const LaboratoryFilm& how, const DrawnFilm& drawn,
                                   const TemporaryFolder& folder) {
  constexpr int times = 3;
  const Packing& p = sample.packing;
  Film picture;
  picture.about.width = times * drawn.film.about.width, picture.about.height = times * drawn.film.about.height;
  picture.about.frames = 1, picture.about.bits = 16;
  std::vector<double> grey(picture.about.pixels(), 0.5);
  const auto low = how.start(p);
  const auto fine = [&](double film_pixels) { return times * (film_pixels + 0.5) - 0.5; };
  for (std::size_t i = 0; i < low.size(); ++i) {
    const Vec2 centre{fine(drawn.left + low[i].x / how.pixel),
                      fine(drawn.top_row + (p.domain.wall[top].position - low[i].y) / how.pixel)};
    const double radius = times * p.grains.radius[i] / how.pixel;
    each_pixel_near(centre, radius + 2, picture.about.width, picture.about.height, [&](int x, int y, std::size_t at) {
      const double inside = 0.5 * std::erfc((std::hypot(x - centre.x, y - centre.y) - radius) / 0.8);
      grey[at] += inside * ((p.grains.material[i] == 0 ? 0.1 : 0.9) - 0.5);
    });
  }
  RandomStream random(how.seed, Purpose::test, 74);
  for (const double g : grey)
    picture.level.push_back(
        static_cast<std::uint16_t>(std::lround(65535 * std::clamp(0.9 * g + 0.01 * random.normal(), 0.0, 1.0))));
  const auto file = folder / "optical.tif";
  io::write_film(file, picture);
  return file.string();
}

/// Writes the true grains at the smallest load, as a list made by hand.
inline std::string list_of_grains(const LaboratorySample& sample, const LaboratoryFilm& how,
                                  const TemporaryFolder& folder) {
  const auto file = (folder / "grains.csv").string();
  std::ofstream out(file);
  out.precision(12);
  out << "id,x [m],y [m],radius [m],material\n";
  const Packing& p = sample.packing;
  const auto low = how.start(p);
  for (std::size_t i = 0; i < low.size(); ++i)
    out << p.grains.id[i] << ',' << low[i].x << ',' << low[i].y + how.travel * how.pixel << ',' << p.grains.radius[i]
        << ',' << p.materials[static_cast<std::size_t>(p.grains.material[i])].name << '\n';
  return file;
}

}  // namespace arenite::test
