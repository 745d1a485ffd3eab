#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/figures/drawing.hpp"
#include "report/number_block.hpp"

namespace arenite::report::figures {

/// How the numbers of a series are written: as a list, or as a place in a block.
using WriteList = std::function<Numbers(const std::vector<double>& values)>;

Numbers numbers_of(const Head& head);
Numbers numbers_of(const Panel& panel, const WriteList& write);
Numbers numbers_of(const Drawing& drawing, const WriteList& write);
/// Its lines with about a thousand points at most.
Drawing thinned(Drawing drawing);

/// {id: its drawings} of every figure of a list that has something to draw.
template <class Data>
Numbers numbers_of(const std::vector<Row<Data>>& list, const Data& data, const WriteList& write, bool thin = false) {
  Numbers out = Numbers::tree();
  for (const Row<Data>& row : list)
    if (const Drawings drawings = row.draw(data); !drawings.empty()) {
      Numbers all = Numbers::list();
      for (const Drawing& drawing : drawings) all.push_back(numbers_of(thin ? thinned(drawing) : drawing, write));
      out[row.head.id] = std::move(all);
    }
  return out;
}

/// Numbers of figures as the page carries them: lines of about a thousand points at most, short lists in the document,
/// others in the block, equal ones once.
class PageLists {
 public:
  explicit PageLists(NumberBlock& block) : block_(block) {}
  Numbers operator()(const std::vector<double>& values);

 private:
  NumberBlock& block_;
  std::map<std::string, NumberRef> known_;
};

/// As they are.
Numbers whole_list(const std::vector<double>& values);

}  // namespace arenite::report::figures
