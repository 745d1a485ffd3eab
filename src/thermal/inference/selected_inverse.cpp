#include <Eigen/Core>
#include <algorithm>
#include <span>

#include "thermal/inference/equations.hpp"

namespace arenite::inference {
namespace {

using Dense = Eigen::MatrixXd;

/// Columns of L that follow each other and have the same rows below them.
struct Supernode {
  int first = 0, columns = 0;
  std::span<const int> below;  ///< rows
  int parent = -1;             ///< the supernode of the first row below

  int size() const { return columns + static_cast<int>(below.size()); }
};

/// L by columns, its unit diagonal left out.
struct Lower {
  const std::vector<int>&begin, &row;
  const std::vector<double>& value;

  std::size_t start(int j) const {
    const auto e = static_cast<std::size_t>(begin[static_cast<std::size_t>(j)]);
    return e + (e < end(j) && row[e] == j ? 1 : 0);
  }
  std::size_t end(int j) const { return static_cast<std::size_t>(begin[static_cast<std::size_t>(j) + 1]); }
  std::span<const int> rows(int j) const { return {row.data() + start(j), end(j) - start(j)}; }
};

std::vector<Supernode> supernodes(const Lower& l, int n) {
  std::vector<Supernode> nodes;
  std::vector<int> node_of(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) {
    const auto rows = l.rows(j), before = j > 0 ? l.rows(j - 1) : rows;
    if (j == 0 || before.size() != rows.size() + 1 || before[0] != j) nodes.push_back({j, 0, {}, -1});
    ++nodes.back().columns, nodes.back().below = rows;
    node_of[static_cast<std::size_t>(j)] = static_cast<int>(nodes.size()) - 1;
  }
  for (Supernode& node : nodes)
    if (!node.below.empty()) node.parent = node_of[static_cast<std::size_t>(node.below[0])];
  return nodes;
}

/// Z in the rows and columns below a supernode, all of which its parent's Z has; lower triangles only.
void take_over(const Dense& parent, const Supernode& of, const Supernode& node, Dense& z) {
  std::vector<Eigen::Index> place;
  Eigen::Index at = 0;
  for (const int row : node.below) {
    if (row < of.first + of.columns) {
      at = row - of.first;
    } else {
      at = std::max<Eigen::Index>(at, of.columns);
      while (of.below[static_cast<std::size_t>(at - of.columns)] != row) ++at;
    }
    place.push_back(at);
  }
  for (std::size_t c = 0; c < place.size(); ++c)
    for (std::size_t r = c; r < place.size(); ++r)
      z(node.columns + static_cast<Eigen::Index>(r), node.columns + static_cast<Eigen::Index>(c)) = parent(place[r], place[c]);
}

}  // namespace

// Z = (L D L^T)^-1 obeys Z = D^-1 L^-1 + (1 - L^T) Z. With the rows R below the diagonal of L's column j, Z_Rj = -Z_RR L_Rj and
// Z_jj = 1/D_j - L_Rj . Z_Rj. Z of the rows below a supernode is a part of its parent's, which goes when its first child has it.
std::vector<double> selected_inverse_diagonal(const std::vector<int>& begin, const std::vector<int>& row, const std::vector<double>& value,
                                              const std::vector<double>& d) {
  const Lower l{begin, row, value};
  const std::vector<Supernode> nodes = supernodes(l, static_cast<int>(d.size()));
  std::vector<Dense> z(nodes.size());
  std::vector<std::size_t> first_child(nodes.size(), nodes.size());
  for (std::size_t k = nodes.size(); k-- > 0;)
    if (nodes[k].parent >= 0) first_child[static_cast<std::size_t>(nodes[k].parent)] = k;
  std::vector<double> diagonal(d.size());
  for (std::size_t k = nodes.size(); k-- > 0;) {
    const Supernode& node = nodes[k];
    z[k].resize(node.size(), node.size());
    if (node.parent >= 0) {
      const auto parent = static_cast<std::size_t>(node.parent);
      take_over(z[parent], nodes[parent], node, z[k]);
      if (first_child[parent] == k) z[parent] = {};
    }
    for (int c = node.columns - 1; c >= 0; --c) {
      const int j = node.first + c, rest = node.size() - c - 1;
      const Eigen::Map<const Eigen::VectorXd> column(value.data() + l.start(j), rest);
      auto below = z[k].col(c).tail(rest);
      below.noalias() = z[k].bottomRightCorner(rest, rest).selfadjointView<Eigen::Lower>() * -column;
      diagonal[static_cast<std::size_t>(j)] = z[k](c, c) = 1 / d[static_cast<std::size_t>(j)] - column.dot(below);
    }
    if (first_child[k] == nodes.size()) z[k] = {};
  }
  return diagonal;
}

}  // namespace arenite::inference
