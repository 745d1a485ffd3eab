#include <fmt/core.h>

#include <utility>

#include "workflow/field_stages.hpp"

namespace arenite::workflow {
namespace {

constexpr std::int32_t left_out = -1;

/// New number of every grain that is kept, in the order in which they were added.
class Numbering {
 public:
  explicit Numbering(std::size_t grains) : number_(grains, left_out) {}
  void add(std::int32_t grain) {
    auto& number = number_[static_cast<std::size_t>(grain)];
    if (number != left_out) return;
    number = static_cast<std::int32_t>(kept_.size());
    kept_.push_back(grain);
  }
  std::int32_t operator[](std::int32_t grain) const { return number_[static_cast<std::size_t>(grain)]; }
  bool has(std::int32_t grain) const { return number_[static_cast<std::size_t>(grain)] != left_out; }
  const std::vector<std::int32_t>& kept() const { return kept_; }

 private:
  std::vector<std::int32_t> number_, kept_;
};

Contacts take(const Contacts& from, const Numbering& numbering) {
  Contacts contacts;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (!numbering.has(from.i[c]) || (!from.is_wall(c) && !numbering.has(from.j[c]))) continue;
    contacts.add(numbering[from.i[c]], from.is_wall(c) ? from.j[c] : numbering[from.j[c]], from.normal[c], from.fn[c], from.ft[c], from.arm_i[c],
                 from.arm_j[c]);
    contacts.overlap.back() = from.overlap[c];
    contacts.sliding_velocity.back() = from.sliding_velocity[c];
    contacts.glued.back() = from.glued[c];
  }
  return contacts;
}

template <class Neck> std::vector<Neck> take(const std::vector<Neck>& from, const Numbering& numbering) {
  std::vector<Neck> necks;
  for (Neck neck : from) {
    if (!numbering.has(neck.i) || !numbering.has(neck.j)) continue;
    neck.i = numbering[neck.i];
    neck.j = numbering[neck.j];
    necks.push_back(neck);
  }
  return necks;
}

constexpr double gap_over_radius = 0.075, crop_over_radius = 25.6;  // P's 3 nodes and 1024 nodes of 40 to a large radius

/// Mean radius of the grains of a material (of all: -1); 0 without any.
double mean_radius(const Packing& packing, std::int32_t material) {
  double sum = 0, count = 0;
  for (std::size_t g = 0; g < packing.grains.size(); ++g)
    if (material < 0 || packing.grains.material[g] == material) sum += packing.grains.radius[g], ++count;
  return count > 0 ? sum / count : 0;
}

/// P's crop where nothing else is asked for and the sample is wide enough for it; 0: the largest square.
double crop_side(const recipe::Recipe& recipe, const recipe::GridSection& section, const Packing& packing, double radius) {
  if (section.crop) return *section.crop;
  const double side = crop_over_radius * radius;
  return recipe.bidisperse && grid::crop_window(packing, 0).width() >= side ? side : 0;
}

std::string sentence(const SampleReports& reports, const PhaseMap& map, const recipe::GridSection& section) {
  const auto& r = reports.grid;
  std::string text = fmt::format("{0} x {0} nodes of {1:.4g} mm, {2} grains; S_m {3:.4f} by geometry; areas on the nodes off by {4:+.2g} % (particles)",
                                 section.nodes, 1e3 * map.dx, map.grain_class.size(), reports.cement.saturation, 100 * r.particle_area_error);
  if (r.exact_matrix_area > 0) text += fmt::format(" and {:+.2g} % (matrix)", 100 * r.matrix_area_error);
  if (r.necks > 0) text += fmt::format("; the thinnest of {} necks spans {} nodes", r.necks, r.thinnest_neck);
  if (r.lost_necks > 0) text += fmt::format("; {} no node: refine the grid", r.lost_necks == 1 ? "1 neck has" : fmt::format("{} necks have", r.lost_necks));
  return text;
}

}  // namespace

CroppedPacking crop(const Packing& packing, const Cement& cement, const std::vector<std::int32_t>& grain_of_label, Vec2 corner) {
  Numbering numbering(packing.grains.size());
  for (const std::int32_t grain : grain_of_label) numbering.add(grain);
  const auto labels = static_cast<std::int32_t>(numbering.kept().size());
  const auto shown = [&](std::int32_t grain) { return numbering.has(grain) && numbering[grain] < labels; };
  const auto add_partner = [&](std::int32_t i, std::int32_t j) {
    if (shown(i)) numbering.add(j);
    else if (shown(j)) numbering.add(i);
  };
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    if (!packing.contacts.is_wall(c)) add_partner(packing.contacts.i[c], packing.contacts.j[c]);
  for (const Bridge& bridge : cement.bridges) add_partner(bridge.i, bridge.j);
  for (const Meniscus& meniscus : cement.menisci) add_partner(meniscus.i, meniscus.j);

  CroppedPacking result;
  result.packing.materials = packing.materials;
  result.packing.domain = packing.domain;
  for (int side = 0; side < sides; ++side) result.packing.domain.wall[side].position -= across(side, corner);
  for (Boundary& boundary : result.packing.domain.boundaries) {
    for (Vec2& p : boundary.points) p -= corner;
    boundary.centre -= corner;
  }
  result.packing.grains = picked(packing.grains, numbering.kept(), corner);
  result.packing.contacts = take(packing.contacts, numbering);
  result.cement.full = cement.full;
  result.cement.coating = cement.coating;
  result.cement.bridges = take(cement.bridges, numbering);
  result.cement.menisci = take(cement.menisci, numbering);
  return result;
}

Packing transposed(const Packing& packing) {
  Packing other = packing;
  for (auto* vectors : {&other.grains.position, &other.grains.velocity, &other.contacts.normal})
    for (Vec2& v : *vectors) std::swap(v.x, v.y);
  for (auto* turning : {&other.grains.angle, &other.grains.omega})
    for (double& value : *turning) value = -value;
  for (double& ft : other.contacts.ft) ft = -ft;  // t is n turned counter-clockwise, which a mirror image is not
  for (std::int32_t& j : other.contacts.j)
    if (is_wall(j) && !is_boundary(j)) j = wall_partner(wall_side(j) ^ 2);
  for (Boundary& boundary : other.domain.boundaries) {
    for (Vec2& p : boundary.points) std::swap(p.x, p.y);
    for (Vec2* v : {&boundary.velocity, &boundary.centre, &boundary.force}) std::swap(v->x, v->y);
    boundary.spin = -boundary.spin;
    boundary.torque = -boundary.torque;
  }
  std::swap(other.domain.wall[left], other.domain.wall[bottom]);
  std::swap(other.domain.wall[right], other.domain.wall[top]);
  std::swap(other.domain.periodic[0], other.domain.periodic[1]);
  return other;
}

std::optional<ClassMaterials> class_materials(const recipe::Recipe& recipe, const Packing& packing) {
  const auto index = [&](const std::string& name) { return static_cast<std::int32_t>(index_of(packing.materials, name)); };
  if (recipe.bidisperse) return ClassMaterials{index(recipe.bidisperse->large), index(recipe.bidisperse->small)};
  if (packing.materials.size() != 2) return std::nullopt;
  const double a = mean_radius(packing, 0), b = mean_radius(packing, 1);
  if (a == 0 || b == 0 || a == b) return std::nullopt;
  return a > b ? ClassMaterials{0, 1} : ClassMaterials{1, 0};
}

std::vector<GrainClass> classes(const Packing& packing, const std::optional<ClassMaterials>& materials) {
  std::vector<GrainClass> result;
  if (!materials) return result;
  for (const std::int32_t m : packing.grains.material)
    result.push_back(m == materials->large ? GrainClass::large : m == materials->small ? GrainClass::small : GrainClass::none);
  return result;
}

FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing) {
  const recipe::GridSection section = recipe.grid_or_default();
  const auto materials = class_materials(recipe, packing);
  // What gaps and crops are measured by: the mean radius of the large grains, as it was asked for or as it is, or of all.
  const double radius = recipe.bidisperse ? recipe.bidisperse->law.large_radius : mean_radius(packing, materials ? materials->large : -1);
  SampleReports reports;
  reports.law = recipe.cement_or_none();
  if (!reports.law.gap) reports.law.gap = gap_over_radius * radius;
  const double side = crop_side(recipe, section, packing, radius);
  const auto window = grid::crop_window(packing, side);
  const Cement cement = cement::make_cement(packing, reports.law, window, reports.cement);
  FieldResult result;
  result.name = "cement";
  result.map = grid::rasterise(packing, cement, {section.nodes, side}, classes(packing, materials), reports.grid);
  auto cropped = crop(packing, cement, reports.grid.grain_of_label, {window.x_min, window.y_min});
  result.packing = std::move(cropped.packing);
  result.cement = std::move(cropped.cement);
  if (materials) reports.coordination = texture::gap_coordination(packing, *reports.law.gap, materials->large, materials->small, window);
  result.outcome = sentence(reports, result.map, section);
  result.numbers = map_numbers(result.map, section.cavities, radius);
  add_reports(result.numbers, reports);
  return result;
}

}  // namespace arenite::workflow
