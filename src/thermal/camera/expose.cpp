#include "thermal/camera/expose.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/problems.hpp"
#include "core/random.hpp"
#include "geometry/rectangle.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/optics/lens.hpp"

namespace arenite::camera {
namespace {

/// N(T0 + theta) near T0 by its Taylor polynomial: theta is below a kelvin or so.
struct Exitance {
  double value, slope, half_curvature;
  double operator()(double theta) const { return value + theta * (slope + theta * half_curvature); }
};

Exitance exitance_near(const Parameters& p, double emissivity) {
  const auto& around = p.surroundings;
  const double unit = radiometry::photon_exitance(p.band, Detector::reference);
  const double slope = radiometry::photon_exitance_slope(p.band, Detector::reference) / unit;
  if (!around.radiometry) return {1 + slope * (around.temperature - Detector::reference), slope, 0};
  const double t = around.temperature, h = 0.01;
  const auto slope_at = [&](double at) { return radiometry::photon_exitance_slope(p.band, at); };
  const double mirrored = (1 - emissivity) * radiometry::photon_exitance(p.band, around.ambient);
  return {(emissivity * radiometry::photon_exitance(p.band, t) + mirrored) / unit, emissivity * slope_at(t) / unit,
          emissivity * (slope_at(t + h) - slope_at(t - h)) / (4 * h) / unit};
}

Vec2 middle_of(const Scene& scene) { return 0.5 * (scene.low.corner(0) + scene.low.corner(1)); }

/// What a camera takes up, and through what.
struct Drawing {
  optics::Lens lens;
  optics::Canvas canvas;
  std::vector<float> depth;  ///< of the point in the grain that is seen there, m^2: power distance, below 0

  /// Of a picture with so many pixels more on each side.
  Drawing(const Scene& scene, const Optics& optics, int beyond = 0)
      : lens(optics::make_lens(optics.blur, static_cast<int>(optics.supersampling), 5)),
        canvas(lens, static_cast<int>(optics.width) + 2 * beyond, static_cast<int>(optics.height) + 2 * beyond,
               middle_of(scene), {optics.pixel / lens.fine, -optics.pixel / lens.fine}),
        depth(canvas.light.size()) {}

  /// Calls paint(light of a point, offset from the centre) for every point in the disk. Grains that press on each other
  /// are parted by a straight line: a point in both belongs to the one whose rim is further away.
  template <class Paint> void disk(Vec2 centre, double radius, const Paint& paint) {
    canvas.each_point(centre, radius, [&](std::size_t at, Vec2 offset) {
      const auto power = static_cast<float>(dot(offset, offset) - radius * radius);
      if (power >= depth[at]) return;
      depth[at] = power;
      paint(canvas.light[at], offset);
    });
  }
};

void check_points(const Optics& optics) {
  const double n = static_cast<double>(optics.supersampling),
               points = static_cast<double>(optics.width) * static_cast<double>(optics.height) * n * n;
  if (points > most_points)
    throw refusal(
        "a picture of {} x {} pixels with {} x {} points each is too large, {:.2g} points; lower camera.width, height "
        "or supersampling, or raise optical_pixel",
        optics.width, optics.height, optics.supersampling, optics.supersampling, points);
}

/// How a camera lies before the sample: it sees a place of the scene turned about the container's middle, and shifted.
struct View {
  Vec2 middle, shift;
  double cosine = 1, sine = 0;
  Vec2 seen(Vec2 p) const {
    const Vec2 d = p - middle;
    return middle + shift + Vec2{cosine * d.x - sine * d.y, sine * d.x + cosine * d.y};
  }
  Vec2 place(Vec2 p) const {
    const Vec2 d = p - middle - shift;
    return middle + Vec2{cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
  }
};

void paint_container(optics::Canvas& canvas, const Scene& scene, const View& view, double s, float background,
                     float container) {
  const auto corner = [&](int end) {
    return scene.low.corner(end) + s * (scene.high.corner(end) - scene.low.corner(end));
  };
  const geometry::Rectangle inside{corner(0).x, corner(1).x, corner(0).y, corner(1).y};
  auto light = canvas.light.begin();
  for (int r = 0; r < canvas.height; ++r)
    for (int c = 0; c < canvas.width; ++c)
      *light++ = inside.holds(view.place(canvas.place(c, r))) ? background : container;
}

/// What a picture with `halo.margin` more pixels on each side is where the lens scatters that share of its light.
std::vector<float> with_halo(const optics::Lens& halo, double share, const std::vector<float>& wide, int width,
                             int height) {
  std::vector<float> picture = optics::through_lens(halo, wide, width, height);
  const std::ptrdiff_t across = width + 2 * halo.margin;
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c) {
      float& light =
          picture[static_cast<std::size_t>(r) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)];
      const float sharp = wide[static_cast<std::size_t>((r + halo.margin) * across + c + halo.margin)];
      light = static_cast<float>(1 - share) * sharp + static_cast<float>(share) * light;
    }
  return picture;
}

/// Emissivity of every grain: its material's, which may scatter from grain to grain as paint and polish do.
std::vector<double> grain_emissivities(const Scene& scene, const Surroundings& around, std::uint64_t seed) {
  std::vector<double> emissivity;
  for (std::size_t i = 0; i < scene.grains.size(); ++i) {
    const auto m = static_cast<std::size_t>(scene.grains.material[i]);
    emissivity.push_back(m < around.emissivity.size() ? around.emissivity[m] : radiometry::usual_emissivity);
    if (around.emissivity_scatter <= 0) continue;
    const double share = 1 + around.emissivity_scatter * RandomStream(seed, Purpose::emissivity, i).normal();
    emissivity.back() = std::clamp(emissivity.back() * share, 0.01, 1.0);
  }
  return emissivity;
}

void darken_corners(std::vector<float>& picture, const Optics& optics) {
  if (optics.vignetting <= 0) return;
  const Vec2 middle{0.5 * (static_cast<double>(optics.width) - 1), 0.5 * (static_cast<double>(optics.height) - 1)};
  const auto width = static_cast<std::size_t>(optics.width);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const Vec2 away = Vec2{static_cast<double>(i % width), static_cast<double>(i / width)} - middle;
    picture[i] *= static_cast<float>(1 - optics.vignetting * dot(away, away) / dot(middle, middle));
  }
}

}  // namespace

std::vector<float> expose(const Scene& scene, const Parameters& p, double s, std::uint64_t seed) {
  check_points(p.optics);
  const optics::Lens halo = optics::make_lens(p.optics.halo > 0 ? p.optics.halo_width : 0, 1, 4);
  Drawing drawing(scene, p.optics, halo.margin);
  const auto& around = p.surroundings;
  paint_container(drawing.canvas, scene, {middle_of(scene), {}}, p.motion ? s : 0,
                  static_cast<float>(exitance_near(p, around.background_emissivity)(0)),
                  static_cast<float>(exitance_near(p, around.container_emissivity)(0)));
  const std::vector<double> emissivity = grain_emissivities(scene, around, seed);
  std::map<double, Exitance> of_emissivity;
  for (std::size_t i = 0; i < scene.grains.size(); ++i) {
    const auto m = static_cast<std::size_t>(scene.grains.material[i]);
    if (!of_emissivity.contains(emissivity[i])) of_emissivity[emissivity[i]] = exitance_near(p, emissivity[i]);
    const Exitance& exitance = of_emissivity[emissivity[i]];
    const double warming = -scene.materials[m].thermoelastic_factor * s;
    drawing.disk(scene.grains.position[i] + (p.motion ? s : 0) * scene.travel[i], scene.grains.radius[i],
                 [&](float& light, Vec2 offset) {
                   light = static_cast<float>(exitance(warming * static_cast<double>(scene.stress[i].at(offset))));
                 });
  }
  const int width = static_cast<int>(p.optics.width), height = static_cast<int>(p.optics.height);
  auto picture =
      optics::through_lens(drawing.lens, drawing.canvas.light, width + 2 * halo.margin, height + 2 * halo.margin);
  if (p.optics.halo > 0) picture = with_halo(halo, p.optics.halo, picture, width, height);
  darken_corners(picture, p.optics);
  return picture;
}

FloatImage optical_picture(const Scene& scene, const Parameters& p, const std::vector<double>& brightness,
                           std::uint64_t seed) {
  const Photograph& photograph = p.photograph;
  const auto as_far = [&](std::int64_t pixels) {
    const double many = static_cast<double>(pixels) * p.optics.pixel / photograph.pixel;
    if (!(many >= 1 && many <= 1e5))
      throw refusal(
          "an ordinary camera's picture of {} pixels of {:g} mm would have {:.3g} of {:g} mm; choose another "
          "optical_pixel",
          pixels, 1e3 * p.optics.pixel, many, 1e3 * photograph.pixel);
    return std::llround(many);
  };
  const Optics optics{as_far(p.optics.width), as_far(p.optics.height), photograph.pixel, photograph.blur, 0, 4};
  check_points(optics);
  Drawing drawing(scene, optics);
  const View view{middle_of(scene), photograph.shift, std::cos(photograph.rotation), std::sin(photograph.rotation)};
  paint_container(drawing.canvas, scene, view, 0, 0.5f, 0.35f);
  for (std::size_t i = 0; i < scene.grains.size(); ++i) {
    const auto grey = static_cast<float>(brightness[static_cast<std::size_t>(scene.grains.material[i])]);
    drawing.disk(view.seen(scene.grains.position[i]), scene.grains.radius[i],
                 [&](float& light, Vec2) { light = grey; });
  }
  const int width = static_cast<int>(optics.width), height = static_cast<int>(optics.height);
  FloatImage picture{width, height, optics::through_lens(drawing.lens, drawing.canvas.light, width, height)};
  RandomStream random(seed, Purpose::photograph);
  for (float& level : picture.value) {
    const double seen = photograph.exposure * static_cast<double>(level) + photograph.noise * random.normal();
    level = static_cast<float>(std::clamp(seen, 0.0, 1.0));
  }
  return picture;
}

}  // namespace arenite::camera
