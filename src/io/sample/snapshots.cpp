#include "io/sample/snapshots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

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
  SnapshotPair pair{std::max<std::size_t>(grains.size(), 1) - 1, std::max<std::size_t>(contacts.size(), 1) - 1};
  if (!grains.empty() && !contacts.empty()) {
    const auto found = [&] {
      for (std::size_t g = grains.size(); g-- > 0;)
        for (std::size_t c = contacts.size(); c-- > 0;)
          if (agree(grains[g], contacts[c])) return pair = {g, c}, true;
      return false;
    };
    if (!found()) {
      problems.add(
          "the contacts are of {}, the grains of {}, and no snapshot of one file is of the same moment as one of the "
          "other; write both at the same steps",
          words_for(contacts.back()), words_for(grains.back()));
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
