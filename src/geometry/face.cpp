#include "geometry/face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/mapped.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::geometry {
namespace {

/// The corner behind the k-th.
Vec3 next_of(Face face, std::size_t k) { return face[k + 1 < face.size() ? k + 1 : 0]; }

constexpr double one_place = 1e-9;  // of the size of all: faces that are cut by different lines meet to rounding only

/// Points of faces, each once, and the corners of each face among them.
struct Welded {
  std::vector<Vec3> point;
  std::vector<std::vector<std::size_t>> corner;

  explicit Welded(std::span<const Face> faces) {
    double size = 0;
    for (const Face face : faces)
      for (const Vec3 p : face) size = std::max(size, norm(p - faces[0][0]));
    for (const Face face : faces) {
      corner.emplace_back();
      for (const Vec3 p : face) {
        const auto at = std::ranges::find_if(point, [&](Vec3 known) { return norm(known - p) <= one_place * size; });
        corner.back().push_back(static_cast<std::size_t>(at - point.begin()));
        if (at == point.end()) point.push_back(p);
      }
    }
  }
};

/// The two ends of the side behind a corner, the lower first.
std::pair<std::size_t, std::size_t> side_of(const std::vector<std::size_t>& corner, std::size_t k) {
  return std::minmax({corner[k], corner[(k + 1) % corner.size()]});
}

}  // namespace

std::vector<Face> faces_of(std::span<const Vec3> points, std::span<const std::int32_t> corners) {
  std::vector<Face> faces;
  for (const std::int32_t count : corners) {
    const auto own = static_cast<std::size_t>(count);
    if (own > points.size()) break;
    faces.push_back(points.first(own));
    points = points.subspan(own);
  }
  return faces;
}

std::vector<std::array<Vec3, 2>> edges_of(std::span<const Face> faces) {
  constexpr double flat = 1 - 1e-9;  // cosine of the angle between faces in one plane
  struct Edge {
    std::array<Vec3, 2> ends;
    Vec3 normal;
    bool is_seen = true;
  };
  std::vector<Edge> edges;
  const Welded all(faces);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Vec3 area = area_vector(faces[f]), normal = area / norm(area);
    for (std::size_t k = 0; k < faces[f].size(); ++k) {
      const auto [at, is_new] = known.try_emplace(side_of(all.corner[f], k), edges.size());
      if (is_new) edges.push_back({{faces[f][k], next_of(faces[f], k)}, normal});
      else if (std::abs(dot(edges[at->second].normal, normal)) > flat) edges[at->second].is_seen = false;
    }
  }
  std::erase_if(edges, [](const Edge& edge) { return !edge.is_seen; });
  return mapped(edges, &Edge::ends);
}

std::vector<std::vector<Vec3>> ends_of(std::span<const Face> faces) {
  const Welded all(faces);
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& corner : all.corner)
    for (std::size_t k = 0; k < corner.size(); ++k) ++sides[side_of(corner, k)];
  std::map<std::size_t, std::vector<std::size_t>> beside;
  for (const auto& [ends, count] : sides)
    if (count == 1) beside[ends.first].push_back(ends.second), beside[ends.second].push_back(ends.first);
  std::vector<std::vector<Vec3>> lines;
  while (!beside.empty()) {
    std::vector<Vec3> line;
    std::size_t at = beside.begin()->first;
    for (auto found = beside.find(at); found != beside.end(); found = beside.find(at)) {
      line.push_back(all.point[at]);
      const auto next =
          std::ranges::find_if(found->second, [&](std::size_t p) { return p != at && beside.contains(p); });
      const std::size_t to = next == found->second.end() ? at : *next;
      beside.erase(found);
      at = to;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Vec3 area_vector(Face face) {
  Vec3 area;
  for (std::size_t k = 1; k + 1 < face.size(); ++k) area += cross(face[k] - face[0], face[k + 1] - face[0]);
  return area;
}

Vec3 nearest_on_face(Face face, Vec3 place) {
  const Vec3 area = area_vector(face);
  Vec3 nearest = place - dot(place - face[0], area) / dot(area, area) * area;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 a = face[k], b = next_of(face, k);
    if (!(dot(cross(area, b - a), place - a) < 0)) continue;  // on the inner side of this edge
    const Vec3 on_edge = nearest_on_segment(a, b, place), way = place - on_edge;
    if (dot(way, way) < least) least = dot(way, way), nearest = on_edge;
  }
  return nearest;
}

bool is_flat_and_convex(Face face) {
  if (face.size() < 3) return false;
  const Vec3 area = area_vector(face);
  const double size = norm(area);
  if (!(size > 0)) return false;
  const double small = 1e-6 * std::sqrt(size);
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 a = face[k], b = next_of(face, k);
    if (!(norm(b - a) > small) || std::abs(dot(a - face[0], area)) > small * size) return false;
    const Vec3 inwards = cross(area, b - a);
    for (const Vec3 corner : face)
      if (dot(inwards, corner - a) < -small * norm(inwards)) return false;
  }
  return true;
}

}  // namespace arenite::geometry
