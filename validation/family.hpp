#pragma once
#include <string>
#include <vector>

#include "validation/checks.hpp"

/// One check of many like numbers: pairs of size and volume ratio, materials, ratios.
namespace arenite::validation {

struct Member {
  std::string name;  ///< "gamma 2.5, theta 1.4"
  Value value;
  std::vector<Draw> draws = {};  ///< of which further seeds would make it surer
};
using Family = std::vector<Member>;

/// Holm's step-down correction: which chances are below `level` when all are tested at once. A chance that is not known
/// is not.
std::vector<bool> holm(const std::vector<double>& chances, double level);

/// Every member is in the range. Holds if each shows it by itself (a statement about all needs no correction to hold:
/// its chance of holding wrongly is that of the member that is least sure); fails if one is outside after Holm's
/// correction, since of many some stray by chance. Shows the member that is least sure, and how many hold.
Check every(const std::string& what, const std::string& source, const Family& family, const Range& range,
            const std::string& unit = "");

/// On the whole: `size` goes this way (+1, -1), and no member goes the other way after Holm's correction. Tells how
/// many go this way beyond their own error, and which goes it least. Without `size`: the mean over members, which are
/// taken to be independent.
Check on_the_whole(const std::string& what, const std::string& source, const Family& differences, int direction);
Check on_the_whole(const std::string& what, const std::string& source, const Value& size, const Family& differences,
                   int direction);

/// A trend that `size` decides (a slope, a rank correlation) unless one of `against`, which should all go the same way,
/// goes the other way after Holm's correction: that fails it.
Check trend(const std::string& what, const std::string& source, const Value& size, const Family& against,
            int direction);

}  // namespace arenite::validation
