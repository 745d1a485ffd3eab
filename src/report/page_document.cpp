#include "report/page_document.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <numbers>

namespace arenite::report {
namespace {

constexpr std::size_t history_rows = 1000;  // about as many as a figure has pixels across

/// Every k-th row and the last one.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = (values.size() + history_rows - 1) / history_rows;
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); k += stride) kept.push_back(values[k]);
  if (!values.empty() && (values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

void shorten(Numbers& value) {
  if (value.is_real()) value = std::strtod(fmt::format("{:.6g}", value.get<double>()).c_str(), nullptr);
  else
    for (Numbers& part : value) shorten(part);
}

Numbers materials_of(const Materials& materials) {
  Numbers list = Numbers::list();
  for (const Material& m : materials) list.push_back({{"name", m.name}, {"density", m.density}, {"stiffness", m.stiffness}});
  return list;
}

Numbers grains_of(const Grains& grains, NumberBlock& block) {
  const std::vector<std::int32_t> ids(grains.id.begin(), grains.id.end());
  return {{"count", grains.size()},
          {"id", block.add_integers(ids)},
          {"radius", block.add_reals(grains.radius)},
          {"material", block.add_indices(unsigned_copy(grains.material))},
          {"zone", block.add_indices(unsigned_copy(grains.zone))}};
}

/// -sigma_hyd of every grain, Pa.
std::vector<double> grain_pressures(const Packing& packing) {
  std::vector<double> pressure;
  for (const Tensor2& moment : texture::grain_moments(packing)) {
    const double r = packing.grains.radius[pressure.size()];
    pressure.push_back(-0.5 * trace(moment) / (std::numbers::pi * r * r * packing.domain.thickness));
  }
  return pressure;
}

Numbers contacts_of(const Packing& packing, NumberBlock& block) {
  Numbers out = pairs_of(packing, block);
  out["fn"] = block.add_reals(packing.contacts.fn);
  out["ft"] = block.add_reals(packing.contacts.ft);
  out["glued"] = block.add_indices(unsigned_copy(packing.contacts.glued));
  return out;
}

/// Bonds that hold, and how the others broke.
Numbers bonds_of(const Packing& packing, NumberBlock& block) {
  std::vector<std::uint32_t> i, j, broken;
  for (const Bond& bond : packing.bonds) {
    i.push_back(static_cast<std::uint32_t>(bond.i));
    j.push_back(static_cast<std::uint32_t>(bond.j));
    broken.push_back(static_cast<std::uint32_t>(bond.broken));
  }
  return {{"i", block.add_indices(i)}, {"j", block.add_indices(j)}, {"broken", block.add_indices(broken)}};
}

Numbers boundaries_of(const Domain& domain, NumberBlock& block) {
  Numbers list = Numbers::list();
  for (const Boundary& boundary : domain.boundaries) {
    std::vector<double> x, y;
    for (const Vec2& p : boundary.points) x.push_back(p.x), y.push_back(p.y);
    list.push_back({{"name", boundary.name},
                    {"closed", boundary.closed},
                    {"present", boundary.present},
                    {"x", block.add_reals(x)},
                    {"y", block.add_reals(y)},
                    {"force", {boundary.force.x, boundary.force.y}},
                    {"torque", boundary.torque}});
  }
  return list;
}

Numbers domain_of(const Domain& domain, NumberBlock& block) {
  Numbers walls = Numbers::list();
  for (const Wall& wall : domain.wall)
    walls.push_back({{"present", wall.present}, {"position", wall.position}, {"force", wall.force}, {"shear", wall.shear_force}});
  Numbers out{{"walls", walls}, {"periodic", {domain.periodic_x, domain.periodic_y}}, {"tilt", domain.tilt}, {"thickness", domain.thickness}};
  if (!domain.boundaries.empty()) out["boundaries"] = boundaries_of(domain, block);
  return out;
}

/// The statistics as texture writes them; the rows by grain go into the block.
Numbers texture_of(const texture::Texture& texture, NumberBlock& block) {
  Numbers out = texture::numbers(texture, true);
  out.erase("by_grain");
  out = shortened(std::move(out));
  const texture::PerGrain& rows = texture.per_grain;
  const texture::Window& window = texture.window;
  out["window"] = {{"known", window.known}, {"x", {window.x_min, window.x_max}}, {"y", {window.y_min, window.y_max}}};
  if (!rows.sigma_norm.empty()) out["grain_sigma_norm"] = block.add_reals(rows.sigma_norm);
  out["grain_considered"] = block.add_indices(unsigned_copy(rows.considered));
  return out;
}

Numbers frame_of(const Frame& frame, std::size_t stage, const texture::Texture* texture, NumberBlock& block) {
  const Grains& grains = frame.packing.grains;
  const Equilibrium& rest = frame.equilibrium;
  Numbers out{{"stage", stage},
              {"label", frame.label},
              {"time", frame.time},
              {"step", frame.step},
              {"domain", domain_of(frame.packing.domain, block)},
              {"x", block.add_reals(grains.x)},
              {"y", block.add_reals(grains.y)},
              {"angle", block.add_reals(grains.angle)},
              {"pressure", block.add_reals(grain_pressures(frame.packing))},
              {"contacts", contacts_of(frame.packing, block)},
              {"equilibrium",
               {{"unbalanced_ratio", rest.unbalanced_ratio},
                {"kinetic_ratio", rest.kinetic_ratio},
                {"loose_kinetic_ratio", rest.loose_kinetic},
                {"falling", rest.falling},
                {"mobilisation", rest.mobilisation},
                {"wall_speed", rest.wall_speed}}}};
  if (!frame.packing.bonds.empty()) out["bonds"] = bonds_of(frame.packing, block);
  if (texture) out["texture"] = texture_of(*texture, block);
  return out;
}

Numbers stage_of(const StageResult& stage, NumberBlock& block) {
  return {{"name", stage.name},
          {"converged", stage.converged},
          {"outcome", stage.outcome},
          {"history", history_of(stage.history, block)},
          {"provenance", provenance_of(stage.provenance)}};
}

const Frame* last_frame(const PageData& data) {
  for (auto stage = data.stages.rbegin(); stage != data.stages.rend(); ++stage)
    if (!(*stage)->frames.empty()) return &(*stage)->frames.back();
  return nullptr;
}

const texture::Texture* find_texture(const PageData& data, std::size_t stage, std::size_t frame) {
  for (const FrameTexture& t : data.textures)
    if (t.stage == stage && t.frame == frame) return &t.texture;
  return nullptr;
}

}  // namespace

Numbers pairs_of(const Packing& packing, NumberBlock& block) {
  const Contacts& contacts = packing.contacts;
  const auto grains = static_cast<std::uint32_t>(packing.grains.size());
  std::vector<std::uint32_t> partner(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    partner[c] = contacts.is_wall(c) ? grains + static_cast<std::uint32_t>(contacts.wall_side(c)) : static_cast<std::uint32_t>(contacts.j[c]);
  return {{"i", block.add_indices(unsigned_copy(contacts.i))}, {"j", block.add_indices(partner)}};
}

Numbers history_of(const History& history, NumberBlock& block) {
  Numbers columns = Numbers::list();
  for (const History::Column& column : history.columns)
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"values", block.add_reals(thinned(column.values))}});
  return columns;
}

Numbers provenance_of(const Provenance& p) {
  Numbers options = Numbers::tree();
  for (const auto& [name, value] : p.options) options[name] = value;
  return {{"version", p.version}, {"stage", p.stage},   {"input_hash", p.input_hash}, {"seed", p.seed},
          {"kernel", p.kernel},   {"recipe", p.recipe}, {"options", options}};
}

Numbers shortened(Numbers numbers) {
  if (!numbers.is_known()) return Numbers::tree();
  shorten(numbers);
  return numbers;
}

PageDocument page_document(const PageData& data) {
  NumberBlock block;
  Numbers document{{"title", data.title}};
  Numbers stages = Numbers::list(), frames = Numbers::list();
  const Frame* last = last_frame(data);
  if (last) {
    document["materials"] = materials_of(last->packing.materials);
    document["grains"] = grains_of(last->packing.grains, block);
  }
  for (std::size_t s = 0; s < data.stages.size(); ++s) {
    stages.push_back(stage_of(*data.stages[s], block));
    for (std::size_t f = 0; f < data.stages[s]->frames.size(); ++f)
      if (const Frame& frame = data.stages[s]->frames[f]; frame.packing.grains.size() == last->packing.grains.size())
        frames.push_back(frame_of(frame, s, find_texture(data, s, f), block));
  }
  document["stages"] = std::move(stages);
  document["frames"] = std::move(frames);
  if (!data.fields.empty()) add_fields(document, data.fields, block);
  if (!data.films.empty()) add_films(document, data.films, block);
  return {to_json(document), block.text()};
}

}  // namespace arenite::report
