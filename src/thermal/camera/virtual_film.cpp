#include "thermal/camera/virtual_film.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/camera/detector.hpp"
#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"

namespace arenite::camera {
namespace {

constexpr double most_bytes = 4e9;

/// Pictures at even load fractions; those between follow from the four nearest (Lagrange's cubic).
class Exposures {
 public:
  Exposures(const Scene& scene, const Parameters& p, double low, double high, std::uint64_t seed) : low_(low) {
    // A twelfth of a pixel's travel between two pictures keeps what the cubic leaves out below a tenth of a
    // millikelvin.
    double travel = 0;
    for (const Vec2 v : scene.travel) travel = std::max(travel, p.motion ? norm(v) / p.optics.pixel : 0.0);
    const int intervals = std::clamp(static_cast<int>(std::ceil(12 * travel * (high - low))), 24, 400);
    step_ = (high - low) / intervals;
    if (const double bytes =
            4.0 * (intervals + 3) * static_cast<double>(p.optics.width) * static_cast<double>(p.optics.height);
        bytes > most_bytes)
      throw refusal("{} pictures of {} x {} pixels between the two loads take {:.2g} GB; lower camera.width and height",
                    intervals + 3, p.optics.width, p.optics.height, 1e-9 * bytes);
    for (int k = -1; k <= intervals + 1; ++k) picture_.push_back(expose(scene, p, low + k * step_, seed));
  }

  void between(double s, std::vector<float>& out) const {
    const double at = std::clamp((s - low_) / step_, 0.0, static_cast<double>(picture_.size()) - 3 - 1e-9);
    const auto k = static_cast<std::size_t>(at);
    const double u = at - static_cast<double>(k);
    const float w[4] = {static_cast<float>(-u * (u - 1) * (u - 2) / 6),
                        static_cast<float>((u + 1) * (u - 1) * (u - 2) / 2),
                        static_cast<float>(-(u + 1) * u * (u - 2) / 2), static_cast<float>((u + 1) * u * (u - 1) / 6)};
    const auto &a = picture_[k], &b = picture_[k + 1], &c = picture_[k + 2], &d = picture_[k + 3];
    out.resize(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
  }

 private:
  double low_, step_;
  std::vector<std::vector<float>> picture_;
};

FilmInfo describe(const Parameters& p, std::int64_t frames) {
  FilmInfo info;
  info.width = static_cast<int>(p.optics.width);
  info.height = static_cast<int>(p.optics.height);
  info.frames = frames;
  info.frame_rate = p.timing.frame_rate;
  info.integration = p.timing.integration;
  info.bits = static_cast<int>(p.detector.bits);
  info.quantity = FilmQuantity::digital_level;
  info.format = "virtual";
  info.camera = "virtual";
  info.band_low = p.band.low;
  info.band_high = p.band.high;
  return info;
}

double load_fraction(const Timing& timing, double t) {
  const double w = 2 * std::numbers::pi * timing.load_frequency * (1 + timing.frequency_error);
  const auto smeared = [&](double rate) {  // mean of its cosine over the integration time
    const double half = 0.5 * rate * timing.integration;
    return half > 0 ? std::sin(half) / half : 1;
  };
  return 0.5 * (1 - smeared(w) * std::cos(w * t)) +
         0.5 * timing.second_harmonic * (1 - smeared(2 * w) * std::cos(2 * w * t));
}

/// Numbers of the frames that were not dropped; the first and the last always are there.
std::vector<std::int64_t> frames_taken(const Timing& timing, std::uint64_t seed) {
  std::vector<std::int64_t> taken;
  RandomStream random(seed, Purpose::dropped_frames);
  const double loss = timing.dropped / static_cast<double>(timing.dropped_together);  // begins in a frame
  std::int64_t lost = 0;
  for (std::int64_t k = 0; k < timing.frames; ++k) {
    const bool begins = random.uniform() < loss, kept = k == 0 || k == timing.frames - 1;
    if (begins && !kept && lost == 0) lost = timing.dropped_together;
    if (lost > 0 && !kept) --lost;
    else taken.push_back(k);
  }
  return taken;
}

/// Frames that `record` makes, one by one.
class RecordedFilm : public FilmSource {
 public:
  using Record = std::function<void(std::size_t frame, std::uint16_t* level)>;
  RecordedFilm(FilmInfo info, Record record) : info_(std::move(info)), record_(std::move(record)) {}

  const FilmInfo& info() const override { return info_; }

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    block.prepare(info_, first, count);
    for (std::size_t k = 0; k < count; ++k)
      record_(static_cast<std::size_t>(first) + k, block.level.data() + k * info_.pixels());
  }

 private:
  FilmInfo info_;
  Record record_;
};

}  // namespace

std::unique_ptr<FilmSource> film(const Scene& scene, const Parameters& p, std::uint64_t seed) {
  const std::vector<std::int64_t> taken = frames_taken(p.timing, seed);
  FilmInfo info = describe(p, static_cast<std::int64_t>(taken.size()));
  if (p.timing.time_stamps)
    for (const auto k : taken) info.time.push_back(static_cast<double>(k - taken.front()) / p.timing.frame_rate);
  return std::make_unique<RecordedFilm>(
      std::move(info),
      [p, seed, taken, exposures = Exposures(scene, p, 0, 1 + std::max(0.0, p.timing.second_harmonic), seed),
       detector = Detection(p, seed), light = std::vector<float>()](std::size_t frame, std::uint16_t* level) mutable {
        const double t = static_cast<double>(taken[frame]) / p.timing.frame_rate;
        exposures.between(load_fraction(p.timing, t), light);
        detector.record(light, p.surroundings.warmer(t), t, seed, static_cast<std::uint64_t>(taken[frame]), level);
      });
}

std::unique_ptr<FilmSource> uniform_film(const Parameters& parameters, double temperature, std::int64_t frames,
                                         std::uint64_t seed) {
  Parameters p = parameters;
  p.detector.jump = p.detector.jump_pattern = 0;  // which belong to the film of the sample
  FilmInfo info = describe(p, frames);
  const std::vector<float> light(info.pixels(),
                                 static_cast<float>(radiometry::photon_exitance(p.band, temperature) /
                                                    radiometry::photon_exitance(p.band, Detector::reference)));
  const std::uint64_t of_its_own = seed + static_cast<std::uint64_t>(temperature * 1e3);
  return std::make_unique<RecordedFilm>(std::move(info), [light, of_its_own, rate = p.timing.frame_rate,
                                                          detector = Detection(p, seed)](std::size_t frame,
                                                                                         std::uint16_t* level) mutable {
    detector.record(light, 0, static_cast<double>(frame) / rate, of_its_own, (std::uint64_t{1} << 40) + frame, level);
  });
}

}  // namespace arenite::camera
