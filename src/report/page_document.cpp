#include "report/page_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "grains/fields/coarse_grained.hpp"
#include "model/shapes.hpp"
#include "report/test_curves.hpp"

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
  return mapped(materials, [](const Material& m) { return Numbers{{"name", m.name}, {"density", m.density}, {"stiffness", m.stiffness}}; });
}

/// Rims of grains that are no disks, from their centres where their angles are 0: those of grain g are points first[g] to first[g + 1] - 1.
Numbers shapes_of(Grains grains, NumberBlock& block) {
  grains.angle.assign(grains.size(), 0.0);
  std::vector<std::uint32_t> first{0};
  std::vector<double> x, y;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    for (const Vec2& p : outline_of(grains, g, 0.3)) {
      x.push_back(p.x - grains.x[g]);
      y.push_back(p.y - grains.y[g]);
    }
    first.push_back(static_cast<std::uint32_t>(x.size()));
  }
  return {{"first", block.add_indices(first)}, {"x", block.add_reals(x)}, {"y", block.add_reals(y)}};
}

Numbers grains_of(const Grains& grains, NumberBlock& block) {
  const std::vector<std::int32_t> ids(grains.id.begin(), grains.id.end());
  Numbers out = {{"count", grains.size()},
                 {"id", block.add_integers(ids)},
                 {"radius", block.add_reals(grains.radius)},
                 {"material", block.add_indices(unsigned_copy(grains.material))},
                 {"zone", block.add_indices(unsigned_copy(grains.zone))}};
  if (!grains.shapes.empty()) out["shapes"] = shapes_of(grains, block);
  return out;
}

/// What the page knows of every grain in a state: pressure p = -sigma_hyd and deviator q of its stress, Pa (half the sum and half the difference
/// of the principal ones), its velocity and its spin. Of a state at rest the last two are left out.
void add_grain_values(Numbers& out, const Packing& packing, NumberBlock& block) {
  std::vector<double> pressure, deviator;
  for (const Tensor2& moment : texture::grain_moments(packing)) {
    const double r = packing.grains.radius[pressure.size()], volume = std::numbers::pi * r * r * packing.domain.thickness;
    pressure.push_back(-0.5 * trace(moment) / volume);
    deviator.push_back(0.5 * std::hypot(moment.xx - moment.yy, moment.xy + moment.yx) / volume);
  }
  out["pressure"] = block.add_reals(pressure);
  out["deviator"] = block.add_coarse(deviator);
  const Grains& grains = packing.grains;
  const auto rests = [](double v) { return v == 0; };
  if (!std::ranges::all_of(grains.vx, rests) || !std::ranges::all_of(grains.vy, rests)) {
    out["vx"] = block.add_coarse(grains.vx);
    out["vy"] = block.add_coarse(grains.vy);
  }
  if (!std::ranges::all_of(grains.omega, rests)) out["spin"] = block.add_coarse(grains.omega);
}

Numbers contacts_of(const Packing& packing, NumberBlock& block) {
  Numbers out = pairs_of(packing, block);
  out["fn"] = block.add_reals(packing.contacts.fn);
  out["ft"] = block.add_reals(packing.contacts.ft);
  out["glued"] = block.add_indices(unsigned_copy(packing.contacts.glued));
  return out;
}

Numbers domain_of(const Domain& domain, NumberBlock& block) {
  const auto walls = mapped(domain.wall, [](const Wall& wall) {
    return Numbers{{"present", wall.present}, {"position", wall.position}, {"force", wall.force}, {"shear", wall.shear_force}};
  });
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
  const Equilibrium& now = frame.equilibrium;
  Numbers out{{"stage", stage},
              {"label", frame.label},
              {"time", frame.time},
              {"step", frame.step},
              {"domain", domain_of(frame.packing.domain, block)},
              {"x", block.add_reals(grains.x)},
              {"y", block.add_reals(grains.y)},
              {"angle", block.add_reals(grains.angle)},
              {"contacts", contacts_of(frame.packing, block)},
              {"equilibrium",
               {{"unbalanced_ratio", now.unbalanced_ratio},
                {"kinetic_ratio", now.kinetic_ratio},
                {"loose_kinetic_ratio", now.loose_kinetic},
                {"falling", now.falling},
                {"mobilisation", now.mobilisation},
                {"wall_speed", now.wall_speed}}}};
  add_grain_values(out, frame.packing, block);
  if (!frame.packing.bonds.empty()) out["bonds"] = bonds_of(frame.packing, block);
  if (!frame.packing.cohesive.empty()) out["cohesive"] = cohesive_of(frame.packing, block);
  if (texture) out["texture"] = texture_of(*texture, block);
  return out;
}

Numbers test_of(const TestCurves& curves, NumberBlock& block) {
  Numbers out{{"strain_name", curves.strain_name}, {"ratio_name", curves.ratio_name()}};
  for (const auto& [name, values] : {std::pair{"strain", &curves.strain}, {"ratio", &curves.ratio}, {"volume", &curves.volume}})
    out[name] = block.add_reals(thinned(*values));
  if (const auto state = critical_state(curves)) out["critical_state"] = shortened(numbers_of(curves, *state));
  return out;
}

Numbers stage_of(const StageResult& stage, NumberBlock& block) {
  Numbers out{{"name", stage.name},
              {"converged", stage.converged},
              {"outcome", stage.outcome},
              {"history", history_of(stage.history, block)},
              {"provenance", provenance_of(stage.provenance)}};
  if (const auto curves = test_curves(stage)) out["test"] = test_of(*curves, block);
  return out;
}

const Frame* last_frame(const PageData& data) {
  for (auto stage = data.stages.rbegin(); stage != data.stages.rend(); ++stage)
    if (!(*stage)->frames.empty()) return &(*stage)->frames.back();
  return nullptr;
}

/// Fields of every so many states, so that they are no more than the page can carry.
std::size_t states_per_fields(const PageData& data) {
  constexpr std::size_t most = 60'000;  // cells
  std::size_t cells = 0;
  for (const StageResult* stage : data.stages)
    for (const Frame& frame : stage->frames) cells += std::min<std::size_t>(frame.packing.grains.size(), 2500);
  return 1 + cells / most;
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
          {"kernel", p.kernel},   {"options", options}, {"recipe", p.recipe}};
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
  const std::size_t every = states_per_fields(data);
  for (std::size_t s = 0; s < data.stages.size(); ++s) {
    stages.push_back(stage_of(*data.stages[s], block));
    const auto& states = data.stages[s]->frames;
    for (std::size_t f = 0; f < states.size(); ++f) {
      if (states[f].packing.grains.size() != last->packing.grains.size()) continue;
      frames.push_back(frame_of(states[f], s, find_texture(data, s, f), block));
      if (f + 1 == states.size() || f % every == 0)
        if (Numbers fields = coarse_fields_of(states[f].packing, fields::shear_rate_at(data.stages[s]->history, states[f].time), block); fields.is_known())
          frames.back()["fields"] = std::move(fields);
    }
  }
  if (last)
    if (Numbers sizes = size_curves_of(last->packing, data.stages.back()->provenance.recipe, block); sizes.is_known()) document["sizes"] = std::move(sizes);
  document["stages"] = std::move(stages);
  document["frames"] = std::move(frames);
  if (!data.fields.empty()) add_fields(document, data.fields, block);
  if (!data.films.empty()) add_films(document, data.films, block);
  return {to_json(document), block.text()};
}

}  // namespace arenite::report
