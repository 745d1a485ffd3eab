#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {

/// Which snapshots of two files are of the same moment: the last one that both have, by step or time and not by its
/// place in the file, else the last of each where one file states no moment. Two files that have none in common are a
/// problem. Notes say what was left aside, and, if there are contacts, where the two moments cannot be compared.
struct SnapshotPair {
  std::size_t grains = 0, contacts = 0;
};
SnapshotPair common_snapshot(const std::vector<Moment>& grains, const std::vector<Moment>& contacts, bool are_contacts,
                             std::vector<std::string>& notes, Problems& problems);

}  // namespace arenite::io
