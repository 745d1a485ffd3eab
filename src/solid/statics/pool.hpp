#pragma once
#include <cstddef>

#include "core/threads.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {

/// Calls work(k) for k = 0 .. n-1, each once: by the members of a pool, or where there is none by the caller.
template <class Work> void for_each(const ThreadPool* pool, std::size_t n, const Work& work) {
  if (pool) return pool->for_each(n, work);
  for (std::size_t k = 0; k < n; ++k) work(k);
}

/// visit(i, level) for every node, level by level by whichever member of the pool.
template <class Visit> void each_node(const ThreadPool* pool, const Grid& grid, const Visit& visit) {
  for_each(pool, static_cast<std::size_t>(grid.levels()),
           [&](std::size_t level) { grid.each_at(static_cast<int>(level), visit); });
}

}  // namespace arenite::statics
