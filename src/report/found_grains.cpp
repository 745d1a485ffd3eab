#include "report/found_grains.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "core/ranks.hpp"
#include "core/text.hpp"
#include "io/results/groups.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::report {
namespace {

using statistics::described;

std::string material_name(const FoundGrains& g, std::int32_t k) {
  const auto at = static_cast<std::size_t>(k);
  if (k < 0) return "";
  if (at < g.materials.size()) return g.materials[at];
  return g.found.report.materials.size() > 1 ? fmt::format("class{}", k + 1) : std::string();
}

/// Length in the table's unit.
double length(const FoundGrains& g, double pixels) { return g.pixel > 0 ? pixels * g.pixel * 1e3 : pixels; }

/// A column of the table of grains: its name there and how it is written; in JSON its name, unit ("px" of lengths),
/// what it is and where it stands.
struct GrainColumn {
  const char *name, *format;
  io::Column<PictureGrains> values;
  const char* sentence;
};
constexpr GrainColumn grain_columns[] = {
    {"x", "{:.4f}", {"column", "px", &PictureGrains::centre, &Vec2::x}, "Column of the centre"},
    {"y", "{:.4f}", {"row", "px", &PictureGrains::centre, &Vec2::y}, "Row of the centre, from the top"},
    {"radius", "{:.4f}", {"radius", "px", &PictureGrains::radius}, "Radius"},
    {"position_error",
     "{:.4f}",
     {"position_error", "px", &PictureGrains::position_error},
     "Standard error of the centre along one axis"},
    {"radius_error", "{:.4f}", {"radius_error", "px", &PictureGrains::radius_error}, "Standard error of the radius"},
    {"brightness", "{:.6g}", {"brightness", "", &PictureGrains::brightness}, "Mean over the inner half of the disk"},
    {"score", "{:.3f}", {"score", "", &PictureGrains::score}, "Fraction of the rim that shows an edge"}};

/// Grains by column.
Numbers by_grain(const PictureGrains& grains) {
  Numbers out = Numbers::tree();
  for (const auto& [name, format, values, sentence] : grain_columns)
    out[fmt::format("{}{}{}", values.name, *values.unit ? "_" : "", values.unit)] =
        described(values.of(grains), values.unit, sentence);
  out["material"] = grains.material;
  out["size"] = grains.size_class;
  return out;
}

/// All that the picture and its grains say.
Numbers numbers_of(const FoundGrains& g) {
  const imaging::CircleReport& r = g.found.report;
  const PictureGrains& p = g.found.grains;
  Numbers sizes = Numbers::list(), materials = Numbers::list();
  for (std::size_t c = 0; c < r.sizes.size(); ++c)
    sizes.push_back({{"radius_px", described(r.sizes.mean[c], "px", "Mean radius of the class")},
                     {"spread_px", described(r.sizes.spread[c], "px", "Standard deviation of the radii")},
                     {"grains", described(r.sizes.members[c], "", "Grains of the class")}});
  for (std::size_t m = 0; m < r.materials.size(); ++m)
    materials.push_back({{"name", material_name(g, static_cast<std::int32_t>(m))},
                         {"brightness", described(r.materials.mean[m], "", "Mean brightness of the material's grains")},
                         {"spread", described(r.materials.spread[m], "", "Standard deviation of their brightness")},
                         {"grains", described(r.materials.members[m], "", "Grains of the material")}});
  return {
      {"file", g.file},
      {"width", described(g.picture.image.width, "", "Pixels along x")},
      {"height", described(g.picture.image.height, "", "Pixels along y")},
      {"frames", described(g.picture.frames, "", "Frames averaged into the picture")},
      {"bad_pixels_replaced", described(g.picture.replaced, "", "Bad pixels, replaced by good neighbours")},
      {"pixel_m", described(g.pixel > 0 ? Numbers(g.pixel) : Numbers(), "m", "Width of a pixel on the sample")},
      {"corner_px", described({g.corner.x, g.corner.y}, "px", "Column and row of the origin of x and y in the table")},
      {"grains", described(p.size(), "", "Grains found")},
      {"bright", described(r.bright, "", "Whether grains are brighter than their surroundings")},
      {"between", described(r.between ? Numbers(*r.between) : Numbers(), "", "Grey level between grains")},
      {"blur_px", described(r.blur, "px", "Standard deviation of lens and pixel")},
      {"noise", described(r.noise, "", "Noise of the picture near rims")},
      {"overlapping_pairs", described(r.overlapping, "", "Pairs that overlap beyond their errors")},
      {"largest_overlap_px", described(r.largest_overlap, "px", "Largest overlap of two circles")},
      {"median_position_error_px", described(median(p.position_error), "px", "Median standard error of a centre")},
      {"median_radius_error_px", described(median(p.radius_error), "px", "Median standard error of a radius")},
      {"sizes", std::move(sizes)},
      {"materials", std::move(materials)},
      {"by_grain", by_grain(p)}};
}

using Colour = std::array<std::uint8_t, 3>;
constexpr std::array<Colour, 5> colours{Colour{230, 85, 13}, Colour{0, 150, 220}, Colour{60, 170, 60},
                                        Colour{200, 60, 180}, Colour{220, 190, 0}};

/// Grey values from the darkest to the brightest hundredth, so that a hot pixel does not blacken the rest.
std::pair<float, float> shown_range(const FloatImage& picture) {
  std::vector<float> values = picture.value;
  const std::size_t n = values.size(), few = n / 200;
  const float least = of_rank_in_place(values, few), most = of_rank_in_place(values, n - 1 - few);
  return {least, std::max(most, std::nextafter(least, INFINITY))};
}

void draw_circle(io::ColourPicture& out, Vec2 centre, double radius, const Colour& colour) {
  const int steps = std::max(16, static_cast<int>(4 * std::numbers::pi * radius));
  for (int k = 0; k < steps; ++k) {
    const double a = 2 * std::numbers::pi * k / steps;
    const auto x = std::lround(centre.x + radius * std::cos(a)), y = std::lround(centre.y + radius * std::sin(a));
    if (x < 0 || y < 0 || x >= out.width || y >= out.height) continue;
    std::copy(colour.begin(), colour.end(), out.rgb.begin() + 3 * (y * out.width + x));
  }
}

}  // namespace

std::string grains_csv(const FoundGrains& g) {
  const bool named = !g.materials.empty() || g.found.report.materials.size() > 1;
  PictureGrains grains = g.found.grains;
  for (Vec2& centre : grains.centre) centre = {centre.x - g.corner.x, g.corner.y - centre.y};
  std::string names = "id", units = "-";
  std::vector<std::string> rows;
  for (std::size_t k = 0; k < grains.size(); ++k) rows.push_back(std::to_string(k));
  for (const GrainColumn& c : grain_columns) {
    const bool is_length = *c.values.unit;
    names += fmt::format(",{}", c.name);
    units += is_length ? g.pixel > 0 ? ",mm" : ",px" : ",-";
    for (std::size_t k = 0; k < grains.size(); ++k)
      rows[k] += "," + fmt::format(fmt::runtime(c.format),
                                   is_length ? length(g, c.values.at(grains, k)) : c.values.at(grains, k));
    if (!named || c.values.numbers != &PictureGrains::radius) continue;
    names += ",material", units += ",-";
    for (std::size_t k = 0; k < grains.size(); ++k) rows[k] += "," + material_name(g, grains.material[k]);
  }
  return fmt::format("{}\n{}\n{}\n", names, units, list_of(rows, "\n"));
}

std::string grains_text(const FoundGrains& g) {
  const imaging::CircleReport& r = g.found.report;
  const char* contrast = r.between ? "brighter and darker" : r.bright ? "brighter" : "darker";
  std::string out = fmt::format("{} grains in {} x {} pixels, {} than their surroundings\n", g.found.grains.size(),
                                g.picture.image.width, g.picture.image.height, contrast);
  for (std::size_t c = 0; c < r.sizes.size(); ++c)
    out += fmt::format("  size: radius {:.2f} pixels{}, {} grains\n", r.sizes.mean[c],
                       g.pixel > 0 ? fmt::format(" = {:.3g} mm", length(g, r.sizes.mean[c])) : "", r.sizes.members[c]);
  for (std::size_t m = 0; m < r.materials.size(); ++m) {
    const std::string name = material_name(g, static_cast<std::int32_t>(m));
    out += fmt::format("  material{}{}: brightness {:.5g} +- {:.2g}, {} grains\n", name.empty() ? "" : " ", name,
                       r.materials.mean[m], r.materials.spread[m], r.materials.members[m]);
  }
  return out + to_text(numbers_of(g), {"file width height grains bright by_grain"});
}

std::string grains_json(const FoundGrains& g) { return to_json(numbers_of(g), 2) + '\n'; }

io::ColourPicture grains_overlay(const FoundGrains& g) {
  const FloatImage& picture = g.picture.image;
  const PictureGrains& grains = g.found.grains;
  const int times = std::clamp(1280 / std::max(1, picture.width), 1, 4);
  io::ColourPicture out{times * picture.width, times * picture.height, {}};
  const auto [low, high] = shown_range(picture);
  out.rgb.reserve(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const float share =
          std::clamp((picture.value[picture.index(x / times, y / times)] - low) / (high - low), 0.0F, 1.0F);
      out.rgb.insert(out.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto colour = static_cast<std::size_t>(std::max(0, grains.material[k])) % colours.size();
    draw_circle(out, {(grains.centre[k].x + 0.5) * times - 0.5, (grains.centre[k].y + 0.5) * times - 0.5},
                grains.radius[k] * times, colours[colour]);
  }
  return out;
}

}  // namespace arenite::report
