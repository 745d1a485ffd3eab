#include "io/sample/snapshots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/sample/formats.hpp"

namespace arenite::io {
namespace {

/// Whether two moments may be the same, by all that both state; programs write times with six digits.
bool agree(const Moment& a, const Moment& b) {
  if (a.step && b.step && *a.step != *b.step) return false;
  return !a.time || !b.time || std::abs(*a.time - *b.time) <= 1e-5 * std::max(std::abs(*a.time), std::abs(*b.time));
}

std::string words_for(const Moment& moment) {
  if (moment.step && moment.time) return fmt::format("step {} (time {:g})", *moment.step, *moment.time);
  if (moment.step) return fmt::format("step {}", *moment.step);
  return moment.time ? fmt::format("time {:g}", *moment.time) : "a moment that is not stated";
}

/// Says so where one file states a step and the other a time, or one of them nothing.
void note_incomparable(const Moment& grains, const Moment& contacts, std::vector<std::string>& notes) {
  const bool by_step = grains.step && contacts.step, by_time = grains.time && contacts.time;
  if (by_step || by_time || (grains == Moment{} && contacts == Moment{})) return;
  notes.push_back(fmt::format(
      "The grains are of {}, the contacts of {}: that they are of one moment is taken, for the files do not say it.",
      words_for(grains), words_for(contacts)));
}

/// Places of snapshots in the order of their moments, whatever that in the file; of equal moments the later one is
/// last.
std::vector<std::size_t> in_time(const std::vector<Moment>& moments) {
  std::vector<std::size_t> order(moments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto has_step = [](const Moment& m) { return m.step.has_value(); };
  const auto has_time = [](const Moment& m) { return m.time.has_value(); };
  if (std::ranges::all_of(moments, has_step))
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return *moments[k].step; });
  else if (std::ranges::all_of(moments, has_time))
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return *moments[k].time; });
  return order;
}

/// Says which snapshot of several was taken.
void note_choice(const char* file, const std::vector<Moment>& moments, std::size_t taken,
                 std::vector<std::string>& notes) {
  if (moments.size() < 2) return;
  notes.push_back(fmt::format("The file of {} has {} snapshots, of which that of {} was taken.", file, moments.size(),
                              words_for(moments[taken])));
}

}  // namespace

SnapshotPair common_snapshot(const std::vector<Moment>& grains, const std::vector<Moment>& contacts, bool are_contacts,
                             std::vector<std::string>& notes, Problems& problems) {
  const auto of_grains = in_time(grains), of_contacts = in_time(contacts);
  SnapshotPair pair{of_grains.empty() ? 0 : of_grains.back(), of_contacts.empty() ? 0 : of_contacts.back()};
  if (!grains.empty() && !contacts.empty()) {
    const auto found = [&] {
      for (auto g = of_grains.rbegin(); g != of_grains.rend(); ++g)
        for (auto c = of_contacts.rbegin(); c != of_contacts.rend(); ++c)
          if (agree(grains[*g], contacts[*c])) return pair = {*g, *c}, true;
      return false;
    };
    if (!found()) {
      problems.add(
          "the contacts are of {}, the grains of {}, and no snapshot of one file is of the same moment as one of the "
          "other; write both at the same steps",
          words_for(contacts[pair.contacts]), words_for(grains[pair.grains]));
      return pair;
    }
  }
  note_choice("grains", grains, pair.grains, notes);
  note_choice("contacts", contacts, pair.contacts, notes);
  const auto taken = [](const std::vector<Moment>& of, std::size_t at) { return of.empty() ? Moment{} : of[at]; };
  if (are_contacts) note_incomparable(taken(grains, pair.grains), taken(contacts, pair.contacts), notes);
  return pair;
}

}  // namespace arenite::io
