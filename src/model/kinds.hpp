#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/links.hpp"
#include "model/phase_map.hpp"

/// The kinds of nodes, of cracks and of broken bonds, and what they are called: for pages, print, tables and messages.
namespace arenite {

/// What a node of a map is: its phase, and of a grain with a class that class. Pages and print have these numbers.
enum class NodeKind : std::uint8_t { empty, matrix, grain, small, large };

/// How a kind is called: where numbers and colours are its ("set large"), and in words.
struct NodeKindWords {
  std::string_view id, one, many;
};
/// By NodeKind.
inline constexpr std::array<NodeKindWords, 5> node_kinds{{{"void", "void", "void"},
                                                          {"matrix", "matrix", "matrix"},
                                                          {"particle", "grain", "grains"},
                                                          {"small", "small grain", "small grains"},
                                                          {"large", "large grain", "large grains"}}};

NodeKind kind_of(GrainClass of_grain);
NodeKind kind_of(const PhaseMap& map, std::size_t node);
/// One a node.
std::vector<NodeKind> kinds_of(const PhaseMap& map);

/// What a crack went through, by Crack::type, BondType and the like.
inline constexpr std::array<std::string_view, 4> crack_types{"", "matrix", "interface", "particle"};

/// How a bond between grains broke, by BondBreak.
inline constexpr std::array<std::string_view, 5> bond_breaks{"", "tension", "bending", "shear", "twisting"};
static_assert(bond_breaks.size() == static_cast<std::size_t>(BondBreak::twisting) + 1);

}  // namespace arenite
