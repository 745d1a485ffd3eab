#include "grains/dem/boundaries/faces.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/problems.hpp"
#include "geometry/face.hpp"

namespace arenite::dem {
namespace {

geometry::Face face_at(const BoundaryIn<3>& boundary, const ElementIn<3>& element) {
  return geometry::Face(boundary.points)
      .subspan(static_cast<std::size_t>(element.point), static_cast<std::size_t>(element.corners));
}
geometry::Face face_at(const DomainIn<3>& domain, const ElementIn<3>& element) {
  return face_at(domain.boundaries[static_cast<std::size_t>(element.boundary)], element);
}

/// A place as the image of a face that is nearest to it sees it, and the way there from the face's nearest point.
struct FaceView {
  Vec3 place, way;
};
FaceView view_from(const DomainIn<3>& domain, geometry::Face face, Vec3 place) {
  if (!domain.is_cell()) return {place, place - geometry::nearest_on_face(face, place)};
  const Vec3 middle = std::accumulate(face.begin(), face.end(), Vec3{}) / static_cast<double>(face.size());
  const Vec3 near = middle + domain.nearest_image(place - middle);
  FaceView best;
  double least = std::numeric_limits<double>::infinity();
  domain.each_near_cell([&](Cells<3> cell) {
    const Vec3 image = near + domain.way(cell), way = image - geometry::nearest_on_face(face, image);
    if (dot(way, way) < least) least = dot(way, way), best = {image, way};
  });
  return best;
}

/// Whether the point of a face that is nearest to a place is one of another face, too, which comes nearer beside it or
/// has the lower number.
bool belongs_to_another(const SampleIn<3>& s, std::int32_t number, Vec3 place, const FaceView& seen) {
  const std::vector<ElementIn<3>>& elements = the<BoundariesIn<3>>(s).element;
  const ElementIn<3>& own = elements[static_cast<std::size_t>(number)];
  const Vec3 touched = seen.place - seen.way;
  return std::ranges::any_of(own.meeting, [&](std::int32_t other) {
    const geometry::Face face = face_at(s.domain, elements[static_cast<std::size_t>(other)]);
    if (norm(view_from(s.domain, face, touched).way) > own.seam) return false;
    const bool shared = norm(view_from(s.domain, face, place).way - seen.way) <= own.seam;
    return !shared || other < number;
  });
}

/// Whether a corner of one face lies on the other.
bool do_meet(const DomainIn<3>& domain, geometry::Face one, geometry::Face other, double seam) {
  const auto lies_on = [&](geometry::Face face) {
    return [&domain, face, seam](Vec3 corner) { return norm(view_from(domain, face, corner).way) <= seam; };
  };
  return std::ranges::any_of(one, lies_on(other)) || std::ranges::any_of(other, lies_on(one));
}

/// A share of how far a boundary reaches, far above rounding and far below the size of a grain.
double seam_of(const BoundaryIn<3>& boundary) {
  double farthest = 0;
  for (const Vec3& p : boundary.points) farthest = std::max(farthest, norm(p - boundary.points.front()));
  return 1e-7 * farthest;
}

/// Axes of a face: along its first edge, across that within it, and aside.
struct FaceAxes {
  Vec3 corner, along, aside, across;
  explicit FaceAxes(geometry::Face face)
      : corner(face[0]),
        along(face[1] - face[0]),
        aside(geometry::area_vector(face)),
        across(cross(aside, along)) {}
  double height(Vec3 place) const { return dot(place - corner, aside); }
  /// Of a place that was seen from where the face had been the same place on it as it is now.
  Vec3 foot_of(const FaceAxes& then, Vec3 place) const {
    const Vec3 way = place - then.corner;
    return corner + dot(way, then.along) / dot(then.along, then.along) * along +
           dot(way, then.across) / dot(then.across, then.across) * across;
  }
};

}  // namespace

void check_shape(Problems& problems, const DomainIn<3>& domain, const BoundaryIn<3>& boundary) {
  const std::size_t corners = std::accumulate(boundary.corners.begin(), boundary.corners.end(), std::size_t{0});
  const bool whole = !boundary.corners.empty() && std::ranges::min(boundary.corners) >= 3 &&
                     corners == boundary.points.size() && std::ranges::all_of(boundary.points, is_finite<3>);
  problems.unless(whole, "boundary \"{}\" needs faces of three corners or more, all of whose points are finite",
                  boundary.name);
  if (!whole) return;
  const std::vector<geometry::Face> faces = geometry::faces_of(boundary.points, boundary.corners);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const geometry::Face face = faces[f];
    problems.unless(geometry::is_flat_and_convex(face),
                    "face {} of boundary \"{}\" is not flat and convex, or has two corners at one place; give its "
                    "corners in order around it, or several faces",
                    f + 1, boundary.name);
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::ranges::minmax(face, {}, [&](Vec3 corner) { return corner[axis]; });
      problems.unless(!domain.periodic[axis] || high[axis] - low[axis] <= (1 + 1e-9) * domain.extent(axis),
                      "face {} of boundary \"{}\" is longer than the periodic cell, {} m; part it", f + 1,
                      boundary.name, domain.extent(axis));
    }
  }
}

std::vector<ElementIn<3>> elements_of(const DomainIn<3>& domain) {
  std::vector<ElementIn<3>> elements;
  for (std::size_t b = 0; b < domain.boundaries.size(); ++b) {
    const BoundaryIn<3>& boundary = domain.boundaries[b];
    const double seam = seam_of(boundary);
    const std::size_t first = elements.size();
    std::int32_t point = 0;
    for (const std::int32_t corners : boundary.corners) {
      elements.push_back({static_cast<std::int32_t>(b), point, corners, seam, {}});
      point += corners;
    }
    for (std::size_t e = first; e < elements.size(); ++e)
      for (std::size_t f = first; f < elements.size(); ++f)
        if (e != f && do_meet(domain, face_at(boundary, elements[e]), face_at(boundary, elements[f]), seam))
          elements[e].meeting.push_back(static_cast<std::int32_t>(f));
  }
  return elements;
}

bool are_neighbours(const SampleIn<3>& s, std::int32_t j, std::int32_t k) {
  return std::ranges::count(touched_element(s, j).meeting, element_of<3>(k)) > 0;
}

void find_near_elements(const SampleIn<3>& s, const GrainRecord<3>& d, std::vector<std::int32_t>& near) {
  const std::vector<ElementIn<3>>& elements = the<BoundariesIn<3>>(s).element;
  const std::vector<BoxAround<3>>& boxes = the<BoundariesIn<3>>(s).box;
  const double reach = d.radius + s.skin;
  const auto is_far = [&](const BoxAround<3>& box) {
    for (int axis = 0; axis < 3; ++axis)
      if (!s.domain.periodic[axis] && (d.place[axis] < box.low[axis] - reach || d.place[axis] > box.high[axis] + reach))
        return true;
    return false;
  };
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto b = static_cast<std::size_t>(elements[e].boundary);
    if (!s.domain.boundaries[b].present || is_far(boxes[b])) continue;
    const Vec3 way = view_from(s.domain, face_at(s.domain, elements[e]), d.place).way;
    if (dot(way, way) < reach * reach) near.push_back(boundary_partner<3>(static_cast<int>(e)));
  }
}

Kinematics<3> kinematics_at_element(const SampleIn<3>& s, std::size_t slot) {
  Kinematics<3> c;
  const std::int32_t j = s.list.j[slot];
  const GrainRecord<3>& d = touching_disk(s, slot);
  const BoundaryIn<3>& boundary = boundary_of(s, j);
  const geometry::Face face = face_at(boundary, touched_element(s, j));
  const FaceView seen = view_from(s.domain, face, d.place);
  const double distance = norm(seen.way);
  if (!(distance < d.radius) || belongs_to_another(s, element_of<3>(j), d.place, seen)) return c;
  c.branch = seen.way;
  c.overlap = d.radius - distance;
  const Vec3 area = geometry::area_vector(face);
  c.normal = distance > 0 ? c.branch / distance : area / norm(area);
  const Vec3 arm = seen.place - seen.way - boundary.centre;
  lean_on(c, d, distance, d.velocity - (boundary.velocity + cross(boundary.spin, arm)), s.contact.arms);
  return c;
}

Vec3 touched_place(const SampleIn<3>& s, std::size_t slot, const Kinematics<3>& c) {
  const geometry::Face face = face_at(s.domain, touched_element(s, s.list.j[slot]));
  return view_from(s.domain, face, touching_disk(s, slot).place).place - c.branch;
}

bool has_crossed(const SampleIn<3>& s, std::size_t slot) {
  const ElementIn<3>& element = touched_element(s, s.list.j[slot]);
  if (!boundary_of(s, s.list.j[slot]).present) return false;
  const std::int32_t k = s.list.i[slot];
  const geometry::Face face = face_at(s.domain, element), former = face_at(s.listed_domain, element);
  const FaceAxes now(face), then(former);
  const Vec3 listed = s.listed[k], before = view_from(s.domain, former, listed).place,
             place = before + (s.record[k].place - listed);
  const double from = then.height(before), to = now.height(place);
  if (!(from * to < 0)) return false;
  const double share = from / (from - to);
  const Vec3 crossing = (1 - share) * now.foot_of(then, before) + share * now.foot_of(now, place);
  return norm(crossing - geometry::nearest_on_face(face, crossing)) <= element.seam;
}

}  // namespace arenite::dem
