#include "thermal/thermography/lost_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <deque>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/median.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/load_phases.hpp"
#include "thermal/thermography/refine_frequency.hpp"

namespace arenite::thermography {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// The load's signal frame by frame; empty if stopped.
std::vector<double> signal_of(FilmSource& film, const LoadPhases& phases, const Progress& progress) {
  const auto frames = static_cast<std::size_t>(film.info().frames), pixels = film.info().pixels();
  std::vector<double> signal(frames), first;
  const bool whole = read_frames(film, 0, frames, [&](const auto* value, std::size_t n, std::size_t some) {
    if (first.empty())
      for (const std::size_t p : phases.pixel) first.push_back(static_cast<double>(value[p]));
    for (std::size_t f = 0; f < some; ++f)
      for (std::size_t i = 0; i < first.size(); ++i)
        signal[n + f] += phases.weight[i] * (static_cast<double>(value[f * pixels + phases.pixel[i]]) - first[i]);
    return !progress || progress(static_cast<double>(n + some) / static_cast<double>(frames));
  });
  return whole ? signal : std::vector<double>();
}

/// Noise of a signal from how far frames lie beside the parabola through their four neighbours.
double noise_of(const std::vector<double>& signal) {
  std::vector<double> away;
  for (std::size_t n = 2; n + 2 < signal.size(); ++n)
    away.push_back(std::abs(signal[n - 2] - 4 * signal[n - 1] + 6 * signal[n] - 4 * signal[n + 1] + signal[n + 2]));
  return median(std::move(away)) / median_of_normal_size / std::sqrt(70.0);
}

/// A signal of one frequency with its second harmonic, by what turns it goes on from slot to slot of an even film.
struct Wave {
  double turns = 0;  ///< a slot
  std::array<double, 4> part{};

  double at(double slot) const {
    const double a = full_turn * turns * slot;
    return part[0] * std::cos(a) + part[1] * std::sin(a) + part[2] * std::cos(2 * a) + part[3] * std::sin(2 * a);
  }
  double amplitude() const { return std::hypot(part[0], part[1]); }
};

/// The signal without what changes slowly: its mean over about a cycle round every frame, beyond that of the wave.
std::vector<double> without_slow(const std::vector<double>& signal, const Wave& wave,
                                 const std::vector<std::size_t>& slot) {
  const std::size_t cycle = static_cast<std::size_t>(std::lround(1 / wave.turns)), half = cycle / 2,
                    frames = signal.size();
  std::vector<double> sum(frames + 1), left(frames);
  for (std::size_t n = 0; n < frames; ++n) sum[n + 1] = sum[n] + signal[n] - wave.at(static_cast<double>(slot[n]));
  for (std::size_t n = 0; n < frames; ++n) {
    const std::size_t from = std::clamp(n, half, frames - 1 - half) - half, end = std::min(from + cycle, frames);
    left[n] = signal[n] - (sum[end] - sum[from]) / static_cast<double>(end - from);
  }
  return left;
}

/// By least squares at the slots, with the turns of a slot near those of the wave.
Wave fitted(Wave wave, const std::vector<double>& signal, const std::vector<std::size_t>& slot) {
  const double middle = 0.5 * static_cast<double>(slot.front() + slot.back());
  for (int round = 0; round < 4; ++round) {
    statistics::SmallNormal<6> normal;
    for (std::size_t n = 0; n < signal.size(); ++n) {
      const double x = static_cast<double>(slot[n]), a = full_turn * wave.turns * x, late = (x - middle) / middle;
      const double c = std::cos(a), s = std::sin(a);
      normal.add({c, s, std::cos(2 * a), std::sin(2 * a), late * c, late * s}, signal[n], 1);
    }
    const auto found = normal.solution();
    std::copy_n(found.begin(), 4, wave.part.begin());
    const double power = found[0] * found[0] + found[1] * found[1];
    if (round < 3) wave.turns += (found[1] * found[4] - found[0] * found[5]) / power / middle / full_turn;
  }
  return wave;
}

/// Slots of frames, never going back, at which a wave is most like the signal: dynamic programming over the number of
/// frames that were lost before each.
class Losses {
 public:
  /// `at_once`: that are lost together at most, for whole cycles fit anywhere.
  Losses(const std::vector<double>& signal, std::size_t most, std::size_t at_once, double noise)
      : signal_(signal),
        most_(most),
        at_once_(at_once),
        noise_(noise) {}

  /// Sum of squared distances over the noise, and a price for every loss. `slots` gets those of the frames.
  double best(const Wave& wave, std::vector<std::size_t>* slots = nullptr) const {
    constexpr double price = 25, wildest = 25;
    const std::size_t frames = signal_.size();
    std::vector<double> level(frames + most_ + 1), cost(most_ + 1, 0), next(most_ + 1);
    for (std::size_t k = 0; k < level.size(); ++k) level[k] = wave.at(static_cast<double>(k));
    for (std::size_t m = 1; m <= most_; ++m)
      cost[m] = std::numeric_limits<double>::infinity();  // none before the first
    std::vector<std::int32_t> from(slots ? frames * (most_ + 1) : 0);
    for (std::size_t n = 0; n < frames; ++n) {
      std::deque<std::size_t> least;  // fewer losses whose costs rise, the least of which is the first
      for (std::size_t m = 0; m <= most_; ++m) {
        if (!least.empty() && least.front() + at_once_ < m) least.pop_front();
        const bool lost = n > 0 && !least.empty() && cost[least.front()] + price < cost[m];
        if (slots) from[n * (most_ + 1) + m] = static_cast<std::int32_t>(lost ? least.front() : m);
        const double off = (signal_[n] - level[n + m]) / noise_;
        next[m] = (lost ? cost[least.front()] + price : cost[m]) + std::min(off * off, wildest);
        while (!least.empty() && cost[least.back()] >= cost[m]) least.pop_back();
        least.push_back(m);
      }
      cost.swap(next);
    }
    const auto at = std::min_element(cost.begin(), cost.end());
    if (slots) {
      slots->resize(frames);
      auto m = static_cast<std::size_t>(at - cost.begin());
      for (std::size_t n = frames; n-- > 0;) {
        (*slots)[n] = n + m;
        m = static_cast<std::size_t>(from[n * (most_ + 1) + m]);
      }
    }
    return *at;
  }

 private:
  const std::vector<double>& signal_;
  std::size_t most_, at_once_;
  double noise_;
};

/// Phase of the signal by which it has gone on at every frame, rad, each over that many cycles of so many turns a
/// frame.
std::vector<double> phases_of(const std::vector<double>& signal, double turns, double cycles) {
  const std::size_t frames = signal.size(), half = static_cast<std::size_t>(std::lround(0.5 * cycles / turns));
  std::vector<std::complex<double>> sum(frames + 1);
  for (std::size_t n = 0; n < frames; ++n)
    sum[n + 1] = sum[n] + signal[n] * std::polar(1.0, -full_turn * turns * static_cast<double>(n));
  std::vector<double> phase(frames);
  for (std::size_t n = 0; n < frames; ++n) {
    const std::size_t at = std::clamp(n, half, frames - 1 - half);
    const double slow = std::arg(sum[at + half + 1] - sum[at - half]),
                 before = n > 0 ? phase[n - 1] - full_turn * turns * static_cast<double>(n - 1) : slow;
    phase[n] = slow + full_turn * std::round((before - slow) / full_turn) + full_turn * turns * static_cast<double>(n);
  }
  return phase;
}

/// The wave, between `low` and `high` turns a frame, from which the phases are most nearly whole frames ahead: at its
/// frequency losses are steps from one whole number to another, at any other one the phases glide over all that lies
/// between.
Wave wave_in_whole_frames(const std::vector<double>& phase, double low, double high, double amplitude) {
  const auto frames = static_cast<double>(phase.size());
  const double step = 0.05 * low / frames;
  Wave best;
  double most = -1;
  for (double turns = low; turns <= high; turns += step) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < phase.size(); n += 2)
      sum += std::polar(1.0, phase[n] / turns - full_turn * static_cast<double>(n));
    if (std::abs(sum) <= most) continue;
    most = std::abs(sum);
    const double part = std::arg(sum) / full_turn, ahead = part + std::round(phase[0] / (full_turn * turns) - part),
                 start = full_turn * turns * ahead;
    best = {turns, {amplitude * std::cos(start), -amplitude * std::sin(start), 0, 0}};
  }
  return best;
}

/// Whether, round the losses, frames in whole slots are more like the wave than frames whose phase glides from one to
/// the next, as that of a load of wandering frequency does.
bool go_by_whole_frames(const Wave& wave, const std::vector<double>& signal, const std::vector<std::size_t>& slot) {
  const double slow = full_turn * wave.turns;
  const std::vector<double> phase = phases_of(signal, wave.turns, 1);
  std::vector<double> ahead;
  for (std::size_t n = 0; n < slot.size(); ++n) ahead.push_back(phase[n] / slow - static_cast<double>(slot[n]));
  const double start = median(ahead);
  const auto near = static_cast<std::size_t>(std::lround(0.25 / wave.turns));
  double whole = 0, gliding = 0;
  std::size_t done = near;
  for (std::size_t n = 1; n + near < slot.size(); ++n) {
    if (slot[n] == slot[n - 1] + 1) continue;
    for (std::size_t k = std::max(done, n - std::min(n, near)); k < n + near; ++k) {
      whole += std::pow(signal[k] - wave.at(static_cast<double>(slot[k])), 2);
      gliding += std::pow(signal[k] - wave.at(phase[k] / slow - start), 2);
    }
    done = n + near;
  }
  return whole < 0.8 * gliding;
}

}  // namespace

std::vector<LostFrames> find_lost_frames(FilmSource& film, const SegmentSums& s, const LoadPhases& phases,
                                         const Progress& progress) {
  const std::size_t frames = s.time.size();
  const double interval = mean_interval(s.time);
  const SearchBand band = search_band(s.time, s.frequency);
  const auto cycle = static_cast<std::size_t>(std::lround(1 / (s.frequency * interval)));
  if (band.empty() || phases.pixel.empty() || cycle < 8 || frames < 8 * cycle) return {};
  const std::vector<double> whole = signal_of(film, phases, progress);
  if (whole.empty()) return {};
  std::vector<std::size_t> slot(frames);
  std::iota(slot.begin(), slot.end(), 0);
  std::vector<double> signal = without_slow(whole, {s.frequency * interval}, slot);
  double power = 0;
  for (const double y : signal) power += y * y;
  const double noise = noise_of(signal), amplitude = std::sqrt(2 * power / static_cast<double>(frames));
  const std::size_t most = std::clamp<std::size_t>(frames / 10, 1, 600);
  constexpr double most_states = 1e8;
  if (static_cast<double>(frames) * static_cast<double>(most) > most_states) return {};
  const Losses losses(signal, most, cycle / 2, std::max(noise, 0.03 * amplitude));
  Wave best = wave_in_whole_frames(phases_of(signal, s.frequency * interval, 0.5), band.low * interval,
                                   band.high * interval, amplitude);
  for (int round = 0; round < 3; ++round) {
    losses.best(best, &slot);
    best = fitted(best, signal, slot);
    signal = without_slow(whole, best, slot);
  }
  if (!go_by_whole_frames(best, signal, slot)) return {};
  std::vector<LostFrames> lost;
  for (std::size_t n = 1; n < frames; ++n)
    if (slot[n] > slot[n - 1] + 1) lost.push_back({n, slot[n] - slot[n - 1] - 1});
  return lost;
}

std::vector<double> times_with_losses(std::size_t frames, double interval, const std::vector<LostFrames>& lost) {
  std::vector<double> time(frames);
  std::size_t slot = 0, next = 0;
  for (std::size_t n = 0; n < frames; ++n, ++slot) {
    if (next < lost.size() && lost[next].frame == n) slot += lost[next++].count;
    time[n] = static_cast<double>(slot) * interval;
  }
  return time;
}

}  // namespace arenite::thermography
