#include "report/film_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/median.hpp"
#include "io/film_times.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {
namespace {

const char* name_of(FilmQuantity quantity) {
  switch (quantity) {
    case FilmQuantity::digital_level: return "digital_level";
    case FilmQuantity::kelvin: return "kelvin";
    case FilmQuantity::unknown: return "unknown";
  }
  return "";
}

struct Levels {
  double least = 0, most = 0, middle = 0, noise = 0;
  thermography::Doubtful doubtful;
};

Levels levels_of(const thermography::FrameStatistics& s, int bits) {
  return {static_cast<double>(*std::min_element(s.least.begin(), s.least.end())), static_cast<double>(*std::max_element(s.most.begin(), s.most.end())),
          median(s.mean), median(s.noise), thermography::doubtful(s, bits)};
}

}  // namespace

FilmSummary::FilmSummary(FilmSource& film, std::size_t most_frames) : info_(film.info()), statistics_(thermography::frame_statistics(film, most_frames)) {}

std::string FilmSummary::json() const {
  const io::FrameIntervals times = io::frame_intervals(info_);
  const Levels levels = levels_of(statistics_, info_.bits);
  const auto known = [](double value) { return value > 0 ? Numbers(value) : Numbers(nullptr); };
  Numbers j{{"format", info_.format},       {"width", info_.width},     {"height", info_.height},
         {"frames", info_.frames},       {"frame_rate_Hz", known(info_.frame_rate)}, {"integration_s", known(info_.integration)},
         {"camera", info_.camera},       {"lens", info_.lens},       {"filter", info_.filter},
         {"bits", info_.bits},           {"floating", info_.floating}, {"quantity", name_of(info_.quantity)},
         {"emissivity", known(info_.emissivity)}, {"ambient_K", known(info_.ambient)}, {"band_low_m", known(info_.band_low)},
         {"band_high_m", known(info_.band_high)}, {"stamped", !info_.time.empty()},
         {"frame_interval_s", known(times.interval)}, {"duration_s", known(times.duration)}, {"dropped_frames", times.dropped}};
  j["gaps_before_frames"] = times.gap;
  j["pixels"] = {{"frames_read", statistics_.frames}, {"least", levels.least}, {"most", levels.most}, {"median", levels.middle},
                 {"median_noise", levels.noise}, {"constant", levels.doubtful.constant}, {"saturated", levels.doubtful.saturated}};
  j["remarks"] = info_.remarks;
  return to_json(j, 2) + '\n';
}

std::string FilmSummary::text() const {
  const io::FrameIntervals times = io::frame_intervals(info_);
  const Levels levels = levels_of(statistics_, info_.bits);
  std::string out = fmt::format("{} film of {} frames, {} x {} pixels, {}\n", info_.format, info_.frames, info_.width, info_.height,
                                info_.floating ? "floating" : fmt::format("{} bit", info_.bits));
  const auto line = [&](const char* name, const std::string& value) { out += fmt::format("{:<14}{}\n", name, value); };
  if (!info_.camera.empty()) line("camera", info_.camera + (info_.lens.empty() ? "" : ", " + info_.lens) + (info_.filter.empty() ? "" : ", " + info_.filter));
  if (info_.frame_rate > 0) line("frame rate", fmt::format("{:.6g} Hz", info_.frame_rate));
  if (info_.integration > 0) line("integration", fmt::format("{:.6g} us", info_.integration * 1e6));
  if (times.duration > 0)
    line("duration", fmt::format("{:.6g} s, a frame every {:.6g} ms ({})", times.duration, times.interval * 1e3, info_.time.empty() ? "from the frame rate" : "stamped"));
  if (times.dropped > 0)
    line("missing", fmt::format("{} frames of the camera's{}", times.dropped,
                                times.gap.empty() ? ", evenly" : fmt::format(", before frame {}{}", times.gap[0], times.gap.size() > 1 ? " and others" : "")));
  if (info_.quantity == FilmQuantity::kelvin) line("pixels hold", "temperatures, K");
  if (info_.quantity == FilmQuantity::digital_level) line("pixels hold", "digital levels");
  line("pixels", fmt::format("{:.6g} to {:.6g}, median {:.6g}, noise {:.3g} (first {} frames)", levels.least, levels.most, levels.middle, levels.noise, statistics_.frames));
  if (levels.doubtful.constant > 0) line("constant", fmt::format("{} pixels never change", levels.doubtful.constant));
  if (levels.doubtful.saturated > 0) line("saturated", fmt::format("{} pixels reach the top of the range", levels.doubtful.saturated));
  for (const std::string& remark : info_.remarks) out += remark + '\n';
  return out;
}

}  // namespace arenite::report
