#include "thermal/inference/force_certainty.hpp"

#include <algorithm>
#include <cmath>
#include "core/ranks.hpp"

namespace arenite::inference {

std::vector<std::uint8_t> doubtful_contacts(const FilmResult& film) {
  constexpr double sure = 0.95;  // probability from which a contact is there without doubt
  std::vector<std::uint8_t> doubtful(film.packing.contacts.size(), 0);
  for (std::size_t c = 0; c < doubtful.size() && c < film.presence.size(); ++c) doubtful[c] = film.presence[c] < sure;
  return doubtful;
}

std::vector<double> forces_over_errors(const FilmResult& film) {
  std::vector<double> ratios = film.packing.contacts.fn;
  if (film.fn_error.size() != ratios.size()) return {};
  for (std::size_t c = 0; c < ratios.size(); ++c) ratios[c] /= film.fn_error[c];
  return ratios;
}

statistics::Bins certainty_bins(const std::vector<double>& ratios) {
  const double high = std::max(4.0, at_share(ratios, 0.98)),
               low = std::min(0.0, std::max(-6.0, std::ranges::min(ratios)));
  constexpr double most_bins = 36;
  double step = 0.5;
  for (int k = 0; (high - low) / step > most_bins; ++k) step *= k % 3 == 1 ? 2.5 : 2;
  const double first = std::floor(low / step);
  return {first * step, step, static_cast<std::size_t>(std::ceil(high / step) - first)};
}

std::optional<ForceCertainty> force_certainty(const FilmResult& film) {
  const std::vector<double> all = forces_over_errors(film);
  const std::vector<std::uint8_t> doubtful = doubtful_contacts(film);
  statistics::BlockedSample sample;
  sample.blocks = 2;
  for (std::size_t c = 0; c < all.size(); ++c)
    if (std::isfinite(all[c])) sample.x.push_back(all[c]), sample.block.push_back(doubtful[c]);
  if (sample.x.empty()) return std::nullopt;
  ForceCertainty found;
  found.bins = certainty_bins(sample.x);
  const double low = found.bins.low, high = found.bins.edge(found.bins.count);
  found.below = static_cast<std::size_t>(std::ranges::count_if(sample.x, [&](double r) { return r < low; }));
  found.beyond = static_cast<std::size_t>(std::ranges::count_if(sample.x, [&](double r) { return r > high; }));
  const statistics::BlockCounts counts = statistics::count(sample, found.bins);
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const statistics::Counts& with_ends = counts.block[kind];
    statistics::Counts& inside = found.there_and_doubtful[kind];
    inside.assign(with_ends.begin() + 1, with_ends.end() - 1);
    inside.front() += with_ends.front();
    inside.back() += with_ends.back();
  }
  return found;
}

}  // namespace arenite::inference
