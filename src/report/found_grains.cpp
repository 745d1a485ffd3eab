#include "report/found_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {
namespace {

std::string material_name(const FoundGrains& g, std::int32_t k) {
  const auto at = static_cast<std::size_t>(k);
  if (k < 0) return "";
  if (at < g.materials.size()) return g.materials[at];
  return g.found.report.materials.size() > 1 ? fmt::format("class{}", k + 1) : std::string();
}

/// Length in the table's unit.
double length(const FoundGrains& g, double pixels) { return g.pixel > 0 ? pixels * g.pixel * 1e3 : pixels; }

using Colour = std::array<std::uint8_t, 3>;
constexpr std::array<Colour, 5> colours{Colour{230, 85, 13}, Colour{0, 150, 220}, Colour{60, 170, 60}, Colour{200, 60, 180}, Colour{220, 190, 0}};

/// Grey values from the darkest to the brightest hundredth, so that a hot pixel does not blacken the rest.
std::pair<float, float> shown_range(const FloatImage& picture) {
  std::vector<float> sorted = picture.value;
  const std::size_t n = sorted.size(), low = n / 200, high = n - 1 - n / 200;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(low), sorted.end());
  const float least = sorted[low];
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(high), sorted.end());
  return {least, std::max(sorted[high], std::nextafter(least, INFINITY))};
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
  const char* unit = g.pixel > 0 ? "mm" : "px";
  const PictureGrains& p = g.found.grains;
  const bool named = !g.materials.empty() || g.found.report.materials.size() > 1;
  std::string out = fmt::format("id,x,y,radius{},position_error,radius_error,brightness,score\n-,{u},{u},{u}{},{u},{u},-,-\n", named ? ",material" : "",
                                named ? ",-" : "", fmt::arg("u", unit));
  for (std::size_t k = 0; k < p.size(); ++k)
    out += fmt::format("{},{:.4f},{:.4f},{:.4f}{},{:.4f},{:.4f},{:.6g},{:.3f}\n", k, length(g, p.centre[k].x - g.corner.x),
                       length(g, g.corner.y - p.centre[k].y), length(g, p.radius[k]), named ? "," + material_name(g, p.material[k]) : "",
                       length(g, p.position_error[k]), length(g, p.radius_error[k]), p.brightness[k], p.score[k]);
  return out;
}

std::string grains_text(const FoundGrains& g) {
  const imaging::CircleReport& r = g.found.report;
  std::string out =
      fmt::format("{} grains in {} x {} pixels, {} than what is around them\n", g.found.grains.size(), g.picture.image.width, g.picture.image.height,
                  r.between  ? "brighter and darker"
                  : r.bright ? "brighter"
                             : "darker");
  const auto line = [&](const char* name, const std::string& value) { out += fmt::format("{:<16}{}\n", name, value); };
  if (g.picture.frames > 1) line("picture", fmt::format("mean of {} frames", g.picture.frames));
  if (g.picture.replaced > 0) line("bad pixels", fmt::format("{} replaced by good neighbours", g.picture.replaced));
  for (std::size_t c = 0; c < r.sizes.size(); ++c)
    line("size", fmt::format("radius {:.2f} pixels{}: {} grains", r.sizes.mean[c], g.pixel > 0 ? fmt::format(" = {:.3g} mm", length(g, r.sizes.mean[c])) : "",
                             r.sizes.members[c]));
  for (std::size_t m = 0; m < r.materials.size(); ++m) {
    const std::string name = material_name(g, static_cast<std::int32_t>(m));
    line("material", fmt::format("{}{}brightness {:.5g} +- {:.2g}: {} grains", name, name.empty() ? "" : ", ", r.materials.mean[m], r.materials.spread[m],
                                 r.materials.members[m]));
  }
  line("errors",
       fmt::format("{:.3f} pixels of a centre, {:.3f} of a radius (medians)", median(g.found.grains.position_error), median(g.found.grains.radius_error)));
  line("lens and pixel", fmt::format("blur {:.2f} pixels, noise {:.3g}", r.blur, r.noise));
  if (r.overlapping > 0) line("overlaps", fmt::format("{} pairs beyond their errors, {:.2f} pixels at most", r.overlapping, r.largest_overlap));
  return out;
}

std::string grains_json(const FoundGrains& g) {
  const imaging::CircleReport& r = g.found.report;
  const PictureGrains& p = g.found.grains;
  Numbers j{{"file", g.file},
            {"width", g.picture.image.width},
            {"height", g.picture.image.height},
            {"frames", g.picture.frames},
            {"bad_pixels_replaced", g.picture.replaced},
            {"pixel_m", g.pixel > 0 ? Numbers(g.pixel) : Numbers(nullptr)},
            {"corner_px", {g.corner.x, g.corner.y}},
            {"grains", p.size()},
            {"bright", r.bright},
            {"between", r.between ? Numbers(*r.between) : Numbers(nullptr)},
            {"blur_px", r.blur},
            {"noise", r.noise},
            {"overlapping_pairs", r.overlapping},
            {"largest_overlap_px", r.largest_overlap},
            {"median_position_error_px", median(p.position_error)},
            {"median_radius_error_px", median(p.radius_error)}};
  j["sizes"] = Numbers::list();
  for (std::size_t c = 0; c < r.sizes.size(); ++c)
    j["sizes"].push_back({{"radius_px", r.sizes.mean[c]}, {"spread_px", r.sizes.spread[c]}, {"grains", r.sizes.members[c]}});
  j["materials"] = Numbers::list();
  for (std::size_t m = 0; m < r.materials.size(); ++m)
    j["materials"].push_back({{"name", material_name(g, static_cast<std::int32_t>(m))},
                              {"brightness", r.materials.mean[m]},
                              {"spread", r.materials.spread[m]},
                              {"grains", r.materials.members[m]}});
  j["by_grain"] = {{"column_px", mapped(p.centre, &Vec2::x)},
                   {"row_px", mapped(p.centre, &Vec2::y)},
                   {"radius_px", p.radius},
                   {"position_error_px", p.position_error},
                   {"radius_error_px", p.radius_error},
                   {"brightness", p.brightness},
                   {"score", p.score},
                   {"material", p.material},
                   {"size", p.size_class}};
  return to_json(j, 2) + '\n';
}

io::ColourPicture grains_overlay(const FoundGrains& g) {
  const FloatImage& picture = g.picture.image;
  const PictureGrains& grains = g.found.grains;
  const int times = std::clamp(1280 / std::max(1, picture.width), 1, 4);
  io::ColourPicture out{times * picture.width, times * picture.height, {}};
  const auto [low, high] = shown_range(picture);
  out.rgb.reserve(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const float share = std::clamp((picture.value[picture.index(x / times, y / times)] - low) / (high - low), 0.0F, 1.0F);
      out.rgb.insert(out.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const auto colour = static_cast<std::size_t>(std::max(0, grains.material[k])) % colours.size();
    draw_circle(out, {(grains.centre[k].x + 0.5) * times - 0.5, (grains.centre[k].y + 0.5) * times - 0.5}, grains.radius[k] * times, colours[colour]);
  }
  return out;
}

}  // namespace arenite::report
