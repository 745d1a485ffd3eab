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
  return moment.time ? fmt::format("time {:g}", *moment.time) : "an unknown step";
}

/// Says which snapshot of several was taken.
void note_choice(const char* file, const std::vector<Moment>& moments, std::size_t taken,
                 std::vector<std::string>& notes) {
  if (moments.size() < 2) return;
  notes.push_back(fmt::format("The file of {} has {} snapshots, of which that of {} was taken.", file, moments.size(),
                              words_for(moments[taken])));
}

}  // namespace

SnapshotPair common_snapshot(const std::vector<Moment>& grains, const std::vector<Moment>& contacts,
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
  return pair;
}

}  // namespace arenite::io
