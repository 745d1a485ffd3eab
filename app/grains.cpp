#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "core/text.hpp"
#include "io/image/image.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "recipe/film_recipe.hpp"
#include "report/found_grains.hpp"
#include "workflow/film/grain_pictures.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

/// Parts of a film's recipe that a picture of grains has, too.
struct PictureOfGrains : recipe::FilmSection {
  recipe::PictureSection picture;
};
void declare(ParameterVisitor& v, PictureOfGrains& of) {
  recipe::declare(v, static_cast<recipe::FilmSection&>(of));
  v.section({"picture", "How grains are found."}, [&](ParameterVisitor& inner) { recipe::declare(inner, of.picture); });
}

struct GrainsArguments {
  KeyOptions picture_keys{recipe::every_key<PictureOfGrains>()}, search{recipe::every_key<imaging::CircleOptions>()},
      reading{recipe::every_key<workflow::GrainPictureKeys>()};
  std::string picture, radii, out;
  bool mean = false, json = false;
};

PictureOfGrains said_of(const GrainsArguments& a) {
  PictureOfGrains of;
  read_options(of, a.picture_keys.given());
  return of;
}

/// Radii in pixels, from lengths or bare numbers of pixels.
std::vector<double> radii_of(const GrainsArguments& a, double pixel) {
  std::vector<double> radii;
  if (a.radii.empty()) return radii;
  for (const std::string& part : split_commas(a.radii)) {
    const auto number = io::to_number(part);
    if (!number && pixel == 0)
      throw InputError("--radii: \"" + part +
                       "\" needs the width of a pixel; give --pixel, for example --pixel \"1.6 mm\"");
    radii.push_back(number ? *number
                           : option_value("--radii", [&] { return parse_si(part, dimension::length, "mm"); }) / pixel);
    if (!(radii.back() >= 1))
      throw InputError("--radii: \"" + part + "\" is less than a pixel; such grains cannot be found");
  }
  return radii;
}

/// Where x and y count from: the picture's lower left corner, or the pixel that was given.
Vec2 corner_of(const workflow::GrainPictureKeys& keys, const FloatImage& image) {
  return keys.origin.empty() ? Vec2{-0.5, image.height - 0.5} : Vec2{keys.origin[0], keys.origin[1]};
}

imaging::CircleOptions circle_options(const GrainsArguments& a, double pixel,
                                      const std::vector<std::string>& materials) {
  imaging::CircleOptions options;
  read_options(options, a.search.given());
  options.radii = radii_of(a, pixel);
  options.materials = materials.size();
  return options;
}

imaging::FoundCircles find(const FloatImage& image, const imaging::CircleOptions& options) {
  imaging::FoundCircles found = imaging::find_circles(image, options);
  if (found.grains.size() == 0)
    throw InputError(
        "no grains were found; give their radii with --radii, --contrast bright or dark, or a lower --least-score");
  if (found.report.materials.size() < options.materials)
    throw InputError("--materials names " + std::to_string(options.materials) +
                     " materials, but the grains show only " + std::to_string(found.report.materials.size()) +
                     " levels of brightness; name fewer, or give another --channel");
  return found;
}

void store(const GrainsArguments& a, const report::FoundGrains& grains) {
  const fs::path folder(a.out);
  workflow::make_folder(folder);
  io::write_png(folder / "grains.png", report::grains_overlay(grains));
  io::write_atomically(folder / "grains.json", report::grains_json(grains));
  io::write_atomically(folder / "grains.csv", report::grains_csv(grains));
  if (!a.json)
    print("\ntable:   {}\npicture: {}\n", (folder / "grains.csv").string(), (folder / "grains.png").string());
}

void find_grains(const GrainsArguments& a) {
  const PictureOfGrains said = said_of(a);
  workflow::GrainPictureKeys keys;
  read_options(keys, a.reading.given());
  const double pixel = said.picture.pixel;
  const std::vector<std::string> materials =
      keys.materials.empty() ? std::vector<std::string>() : split_commas(keys.materials);
  const imaging::CircleOptions options = circle_options(a, pixel, materials);
  io::ImageChoice choice;
  choice.slice = keys.frame;
  choice.channel = keys.channel;
  if (said.film) choice.dataset = said.film->dataset;
  const workflow::GrainPicture picture = workflow::read_grain_picture(a.picture, choice);
  const Vec2 corner = corner_of(keys, picture.image);
  try {
    const imaging::FoundCircles found = find(picture.image, options);
    const report::FoundGrains grains{found, picture, pixel, corner, materials, a.picture};
    put(stdout, a.json ? report::grains_json(grains) : report::grains_text(grains));
    if (!a.out.empty()) store(a, grains);
  } catch (const InputError& error) { throw in_file(error, a.picture); }
}

}  // namespace

void add_grains(Options& command, int&) {
  const auto a = std::make_shared<GrainsArguments>();
  command.add("picture", a->picture, "Picture (" + io::picture_formats() + ") or film of the grains")
      .required()
      .type("IMAGE");
  a->reading.add(command, "--frame", "frame");
  command.add("--mean", a->mean, "Use the mean of all frames of a film (the default)").not_with("--frame");
  command
      .add("--radii", a->radii,
           recipe::help_of(a->search.at("radii")) + ", e.g. \"3.3,5.1\", or as lengths \"5.25 mm,8.2 mm\"")
      .type("LENGTHS");
  a->picture_keys.add(command, "--pixel", "picture.pixel").type("LENGTH").sentence +=
      "; if not given, lengths are in pixels";
  for (const char* key : {"smallest", "largest"}) a->search.add(command, option_name(key), key);
  a->reading.add(command, "--materials", "materials").type("NAMES");
  a->reading.add(command, "--channel", "channel").type("NAME");
  a->search.add(command, "--contrast", "contrast").type("WAY");
  a->search.add(command, "--least-score", "least_score");
  a->reading.add(command, "--origin", "origin").type("COLUMN,ROW");
  a->picture_keys.add(command, "--dataset", "film.dataset").type("NAME");
  command
      .add("--out", a->out,
           "Folder for the table (grains.csv), the picture with the circles found (grains.png) and all numbers "
           "(grains.json)")
      .type("DIR");
  command.add("--json", a->json, "Print everything as JSON, grain by grain");
  command.work = [a] { find_grains(*a); };
}

}  // namespace arenite::app
