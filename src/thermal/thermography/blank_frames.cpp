#include "thermal/thermography/blank_frames.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

void BlankFrames::see(const float* frame, std::size_t pixels) {
  std::size_t missing = 0;
  for (std::size_t p = 0; p < pixels; ++p) missing += std::isfinite(frame[p]) ? 0 : 1;
  missing_.push_back(missing);
  pixels_ = pixels;
}

void BlankFrames::see(const std::uint16_t* frame, std::size_t pixels) {
  missing_.push_back(std::all_of(frame, frame + pixels, [](std::uint16_t level) { return level == 0; }) ? pixels : 0);
  pixels_ = pixels;
}

std::vector<std::int64_t> BlankFrames::all() const {
  // Dead pixels, or what lies outside a mask, are missing in every frame.
  const std::size_t always = missing_.empty() ? 0 : *std::ranges::min_element(missing_);
  std::vector<std::int64_t> lost;
  for (std::size_t n = 0; n < missing_.size(); ++n)
    if (100 * (missing_[n] - always) > pixels_ - always) lost.push_back(static_cast<std::int64_t>(n));
  return lost;
}

std::vector<std::int64_t> blank_frames(FilmSource& film) {
  const std::size_t pixels = film.info().pixels();
  BlankFrames lost;
  read_frames(film, 0, static_cast<std::size_t>(film.info().frames),
              [&](const auto* frames, std::size_t, std::size_t some) {
                for (std::size_t f = 0; f < some; ++f) lost.see(frames + f * pixels, pixels);
                return true;
              });
  return lost.all();
}

bool may_lack_frames(const SegmentSums& s) {
  const SegmentView view = s.view();
  for (std::size_t p = 0; p < s.pixels; ++p)
    for (std::size_t k = 0; k < s.segments(); ++k)
      if (!std::isfinite(s.sums[view.at(p, k, 0)])) return true;
  for (std::size_t n = 0; n < s.time.size(); ++n) {
    const auto is_zero = [&](std::size_t i) {
      return !(std::abs(s.seen[i * s.time.size() + n] + s.base[s.watched[i]]) > 0);
    };
    std::size_t i = 0;
    while (i < s.watched.size() && is_zero(i)) ++i;
    if (i == s.watched.size()) return true;
  }
  return false;
}

std::string blank_frames_sentence(const std::vector<std::int64_t>& frames) {
  constexpr std::size_t most = 5;
  if (frames.empty()) return {};
  const std::vector<std::int64_t> first(frames.begin(),
                                        frames.begin() + static_cast<std::ptrdiff_t>(std::min(frames.size(), most)));
  const std::string names = list_of(mapped<std::string>(first, [](std::int64_t n) { return std::to_string(n); }));
  if (frames.size() == 1) return fmt::format("frame {} holds no picture (no numbers, or zeros) and is left out", names);
  const std::string more = frames.size() > most ? fmt::format(" and {} more", frames.size() - most) : "";
  return fmt::format("{} frames ({}{}) hold no picture (no numbers, or zeros) and are left out", frames.size(), names,
                     more);
}

FilmWithout::FilmWithout(FilmSource& film, const std::vector<std::int64_t>& lost, const std::vector<double>& time)
    : film_(film),
      info_(film.info()) {
  for (std::int64_t n = 0; n < info_.frames; ++n)
    if (!std::ranges::binary_search(lost, n)) kept_.push_back(n);
  info_.frames = static_cast<std::int64_t>(kept_.size());
  info_.time = mapped(kept_, [&](std::int64_t n) { return time[static_cast<std::size_t>(n)]; });
  info_.number.clear();
}

void FilmWithout::read(std::int64_t first, std::size_t count, FrameBlock& block) {
  block.prepare(info_, first, count);
  const auto from = kept_.begin() + static_cast<std::ptrdiff_t>(first);
  for (std::size_t n = 0; n < count;) {
    std::size_t run = 1;
    while (n + run < count && from[static_cast<std::ptrdiff_t>(n + run)] ==
                                  from[static_cast<std::ptrdiff_t>(n)] + static_cast<std::int64_t>(run))
      ++run;
    film_.read(from[static_cast<std::ptrdiff_t>(n)], run, part_);
    const auto at = static_cast<std::ptrdiff_t>(n * info_.pixels());
    std::ranges::copy(part_.level, block.level.begin() + (info_.floating ? 0 : at));
    std::ranges::copy(part_.value, block.value.begin() + (info_.floating ? at : 0));
    n += run;
  }
}

}  // namespace arenite::thermography
