#include "report/page_document.hpp"

#include <numbers>

#include "report/document_parts.hpp"
#include "report/field_document.hpp"
#include "report/film_document.hpp"

namespace arenite::report {
namespace {

Numbers materials_of(const Materials& materials) {
  Numbers list = Numbers::list();
  for (const Material& m : materials)
    list.push_back({{"name", m.name}, {"density", m.density}, {"stiffness", m.stiffness}});
  return list;
}

Numbers grains_of(const Grains& grains, NumberBlock& block) {
  const std::vector<std::int32_t> ids(grains.id.begin(), grains.id.end());
  return {{"count", grains.size()},
          {"id", reference(block.add_integers(ids))},
          {"radius", reference(block.add_reals(grains.radius))},
          {"material", reference(block.add_indices(unsigned_copy(grains.material)))},
          {"zone", reference(block.add_indices(unsigned_copy(grains.zone)))}};
}

/// Hydrostatic pressure -sigma_hyd of every grain, Pa: the contact forces' internal moment has the trace
/// -sum F_n arm, whatever the friction (T ch. 1.2; science: sigma_p = sum f (x) r_c / V_p).
std::vector<double> grain_pressures(const Packing& packing) {
  const Contacts& contacts = packing.contacts;
  std::vector<double> pressure(packing.grains.size(), 0.0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    pressure[static_cast<std::size_t>(contacts.i[c])] += contacts.fn[c] * contacts.arm_i[c];
    if (!contacts.is_wall(c)) pressure[static_cast<std::size_t>(contacts.j[c])] += contacts.fn[c] * contacts.arm_j[c];
  }
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const double r = packing.grains.radius[i];
    pressure[i] /= 2 * std::numbers::pi * r * r * packing.domain.thickness;
  }
  return pressure;
}

Numbers contacts_of(const Packing& packing, NumberBlock& block) {
  const Contacts& contacts = packing.contacts;
  const auto grains = static_cast<std::uint32_t>(packing.grains.size());
  std::vector<std::uint32_t> partner(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    partner[c] = contacts.is_wall(c) ? grains + static_cast<std::uint32_t>(contacts.wall_side(c))
                                     : static_cast<std::uint32_t>(contacts.j[c]);
  return {{"i", reference(block.add_indices(unsigned_copy(contacts.i)))},
          {"j", reference(block.add_indices(partner))},
          {"fn", reference(block.add_reals(contacts.fn))},
          {"ft", reference(block.add_reals(contacts.ft))},
          {"glued", reference(block.add_indices(unsigned_copy(contacts.glued)))}};
}

Numbers domain_of(const Domain& domain) {
  Numbers walls = Numbers::list();
  for (const Wall& wall : domain.wall)
    walls.push_back({{"present", wall.present}, {"position", wall.position}, {"force", wall.force},
                     {"shear", wall.shear_force}});
  return {{"walls", walls}, {"periodic", {domain.periodic_x, domain.periodic_y}}, {"tilt", domain.tilt},
          {"thickness", domain.thickness}};
}

Numbers frame_of(const Frame& frame, std::size_t stage, NumberBlock& block) {
  const Grains& grains = frame.packing.grains;
  Numbers out{{"stage", stage}, {"label", frame.label}, {"time", frame.time}, {"step", frame.step},
           {"domain", domain_of(frame.packing.domain)},
           {"x", reference(block.add_reals(grains.x))},
           {"y", reference(block.add_reals(grains.y))},
           {"angle", reference(block.add_reals(grains.angle))},
           {"pressure", reference(block.add_reals(grain_pressures(frame.packing)))},
           {"contacts", contacts_of(frame.packing, block)}};
  const Equilibrium& rest = frame.equilibrium;
  out["equilibrium"] = {{"unbalanced_ratio", rest.unbalanced_ratio}, {"kinetic_ratio", rest.kinetic_ratio}, {"loose_kinetic_ratio", rest.loose_kinetic}, {"falling", rest.falling},
                        {"mobilisation", rest.mobilisation}, {"wall_speed", rest.wall_speed}};
  return out;
}

Numbers stage_of(const StageResult& stage, NumberBlock& block) {
  return {{"name", stage.name}, {"converged", stage.converged}, {"outcome", stage.outcome},
          {"history", history_of(stage.history, block)}, {"provenance", provenance_of(stage.provenance)}};
}

const Frame* last_frame(const PageData& data) {
  for (auto stage = data.stages.rbegin(); stage != data.stages.rend(); ++stage)
    if (!(*stage)->frames.empty()) return &(*stage)->frames.back();
  return nullptr;
}

const texture::Texture* texture_of(const PageData& data, std::size_t stage, std::size_t frame) {
  for (const FrameTexture& t : data.textures)
    if (t.stage == stage && t.frame == frame) return &t.texture;
  return nullptr;
}

/// The statistics as texture writes them; the rows by grain go into the block.
Numbers texture_json(const texture::Texture& texture, NumberBlock& block) {
  Numbers out = texture::numbers(texture, true);
  out.erase("by_grain");
  shorten(out);
  const texture::PerGrain& rows = texture.per_grain;
  out["window"] = {{"known", texture.window.known}, {"x", {texture.window.x_min, texture.window.x_max}},
                   {"y", {texture.window.y_min, texture.window.y_max}}};
  if (!rows.sigma_norm.empty()) out["grain_sigma_norm"] = reference(block.add_reals(rows.sigma_norm));
  out["grain_considered"] = reference(block.add_indices(unsigned_copy(rows.considered)));
  return out;
}

}  // namespace

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
    for (std::size_t f = 0; f < data.stages[s]->frames.size(); ++f) {
      const Frame& frame = data.stages[s]->frames[f];
      if (frame.packing.grains.size() != last->packing.grains.size()) continue;
      Numbers out = frame_of(frame, s, block);
      if (const texture::Texture* texture = texture_of(data, s, f)) out["texture"] = texture_json(*texture, block);
      frames.push_back(std::move(out));
    }
  }
  document["stages"] = std::move(stages);
  document["frames"] = std::move(frames);
  if (!data.fields.empty()) add_fields(document, data.fields, block);
  if (!data.films.empty()) add_films(document, data.films, block);
  return {to_json(document), block.text()};
}

}  // namespace arenite::report
