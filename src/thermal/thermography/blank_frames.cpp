#include "thermal/thermography/blank_frames.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

template <class Pixel> void BlankFrames::look_at(const Pixel* frame, std::size_t pixels) {
  Seen now;
  float least = INFINITY, most = -INFINITY;
  for (std::size_t p = 0; p < pixels; ++p) {
    const auto value = static_cast<float>(frame[p]);
    if (!std::isfinite(value)) ++now.missing;
    else least = std::min(least, value), most = std::max(most, value);
  }
  now.is_constant = least == most && pixels - now.missing > 1;
  now.value = least;
  if (least < most) {
    least_ = has_pictures_ ? std::min(least_, least) : least;
    most_ = has_pictures_ ? std::max(most_, most) : most;
    has_pictures_ = true;
  }
  take_step(frame, pixels, now);
  before_.assign(frame, frame + pixels);
  pixels_ = pixels;
  seen_.push_back(now);
}

template <class Pixel> void BlankFrames::take_step(const Pixel* frame, std::size_t pixels, Seen& now) {
  const auto alike = [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  now.is_last = !before_.empty() && std::equal(frame, frame + pixels, before_.begin(), alike);
  if (before_.empty() || now.is_last) return;
  std::size_t changed = 0;
  double product = 0, square = 0, earlier = 0;
  step_.resize(pixels);
  for (std::size_t p = 0; p < pixels; ++p) {
    const float by = static_cast<float>(frame[p]) - before_[p];
    if (!std::isfinite(by)) continue;
    changed += by != 0 ? 1 : 0;
    product += static_cast<double>(by) * static_cast<double>(step_[p]);
    square += static_cast<double>(by) * static_cast<double>(by);
    earlier += static_cast<double>(step_[p]) * static_cast<double>(step_[p]);
    step_[p] = by;
  }
  now.changed = static_cast<double>(changed) / static_cast<double>(pixels);
  now.like_step_before = earlier > 0 && square > 0 ? product / std::sqrt(square * earlier) : -1;  // as if it turned
}

void BlankFrames::see(const float* frame, std::size_t pixels) { look_at(frame, pixels); }

void BlankFrames::see(const std::uint16_t* frame, std::size_t pixels) {
  look_at(frame, pixels);
  Seen& now = seen_.back();
  if (now.is_constant && now.value == 0) now.missing = pixels;
}

bool BlankFrames::repeats(std::size_t frame) const {
  constexpr double many = 0.5;              // of the pixels: the noise of a camera changes as many
  constexpr double turns_round = -0.9;      // a still picture where pictures without noise turn round; noise has -0.5
  constexpr std::size_t least_pixels = 16;  // fewer agree by chance
  if (pixels_ < least_pixels || !seen_[frame].is_last || seen_[frame].missing == pixels_) return false;
  std::size_t before = frame, after = frame;
  while (seen_[before].is_last) --before;
  while (after < seen_.size() && seen_[after].is_last) ++after;
  if (!(seen_[before].changed > many)) return false;
  if (after == seen_.size()) return before > 0 && after - before > 2;  // a film that stands still has lost nothing
  return seen_[after].changed > many && (after - before > 2 || seen_[after].like_step_before > turns_round);
}

bool BlankFrames::is_filled(std::size_t frame) const {
  const Seen& seen = seen_[frame];
  return (has_pictures_ && seen.is_constant && (seen.value < least_ || seen.value > most_)) || repeats(frame);
}

std::vector<std::int64_t> BlankFrames::all() const {
  constexpr double most = 0.5, many = 0.1, few_frames = 0.1;
  // Dead pixels, or what lies outside a mask, are missing in every frame.
  const std::size_t always = seen_.empty() ? 0 : std::ranges::min_element(seen_, {}, &Seen::missing)->missing;
  const auto lacks = [&](const Seen& seen, double share) {
    return static_cast<double>(seen.missing - always) > share * static_cast<double>(pixels_ - always);
  };
  const auto lacking = std::ranges::count_if(seen_, [&](const Seen& seen) { return lacks(seen, many); });
  const double share = static_cast<double>(lacking) > few_frames * static_cast<double>(seen_.size()) ? most : many;
  std::vector<std::int64_t> lost;
  for (std::size_t n = 0; n < seen_.size(); ++n)
    if (lacks(seen_[n], share) || is_filled(n)) lost.push_back(static_cast<std::int64_t>(n));
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

MissingPixels missing_pixels(const SegmentSums& s, const ThreadPool& pool) {
  const SegmentView view = s.view();
  const auto of_chunk = [&](std::size_t c, MissingPixels& missing) {
    std::array<std::uint32_t, chunk> numbers{};  // segments in which a pixel is one
    for (std::size_t k = 0; k < s.segments(); ++k) {
      const float* const sum = view.sums + view.at(c * chunk, k, 0);
      for (std::size_t i = 0; i < chunk; ++i) numbers[i] += std::isfinite(sum[i]) ? 1 : 0;
    }
    for (std::size_t i = 0; i < std::min(chunk, s.pixels - c * chunk); ++i)
      if (numbers[i] == 0) ++missing.empty;
      else if (numbers[i] < s.segments()) ++missing.failing;
  };
  MissingPixels all{s.pixels};
  for (const MissingPixels& some : pool.by_blocks<MissingPixels>((s.pixels + chunk - 1) / chunk, 64, of_chunk))
    all.empty += some.empty, all.failing += some.failing;
  return all;
}

bool may_lack_frames(const SegmentSums& s, const MissingPixels& missing) {
  if (missing.empty > 0 || missing.failing > 0) return true;
  const std::size_t frames = s.time.size(), watched = s.watched.size();
  const auto value = [&](std::size_t i, std::size_t n) { return s.seen[i * frames + n] + s.base[s.watched[i]]; };
  for (std::size_t n = 0; n < frames; ++n) {
    bool is_one = true, is_last = n > 0;
    for (std::size_t i = 0; i < watched && (is_one || is_last); ++i) {
      const float rounding = 1e-6F * (std::abs(s.base[s.watched[i]]) + std::abs(value(0, n)));
      is_one = is_one && !(std::abs(value(i, n) - value(0, n)) > rounding);
      is_last = is_last && s.seen[i * frames + n] == s.seen[i * frames + n - 1];
    }
    if (is_one || is_last) return true;
  }
  return false;
}

void tell_failing_pixels(const MissingPixels& missing, LockinMaps& maps) {
  if (missing.empty > 0 && missing.empty < missing.pixels)
    maps.disturbances.push_back(
        fmt::format("{} of {} pixels are no numbers in any frame and show nothing", missing.empty, missing.pixels));
  if (missing.failing > 0)
    maps.disturbances.push_back(
        fmt::format("{} of {} pixels are no numbers in some of the frames and are left out, as dead ones",
                    missing.failing, missing.pixels));
}

std::string blank_frames_sentence(const std::vector<std::int64_t>& frames) {
  constexpr std::size_t most = 5;
  if (frames.empty()) return {};
  const std::vector<std::int64_t> first(frames.begin(),
                                        frames.begin() + static_cast<std::ptrdiff_t>(std::min(frames.size(), most)));
  const std::string names = list_of(mapped<std::string>(first, [](std::int64_t n) { return std::to_string(n); }));
  if (frames.size() == 1)
    return fmt::format(
        "frame {} holds no whole picture (no numbers in more than a tenth of its pixels, one number everywhere, or the "
        "frame before once more) and is left out",
        names);
  const std::string more = frames.size() > most ? fmt::format(" and {} more", frames.size() - most) : "";
  return fmt::format(
      "{} frames ({}{}) hold no whole picture (no numbers in more than a tenth of their pixels, one number everywhere, "
      "or the frame before once more) and are left out",
      frames.size(), names, more);
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
