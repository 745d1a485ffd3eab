#include <fmt/format.h>

#include <algorithm>

#include "core/mapped.hpp"
#include "recipe/keys.hpp"

namespace arenite::recipe {
namespace {

using Visitor = ParameterVisitor;
using dem::Programme;

/// The first value of a programme is that of the stage itself, so that what looks at a stage knows what it begins with.
void begin_with(const Programme& p, Stage& stage) {
  const double value = p.table.front().y;
  if (p.drives_side()) stage.side[static_cast<std::size_t>(p.side())] = {static_cast<SideDrive::Kind>(1 + p.drive()), value};
  else if (p.of < Programme::shear_rate) stage.slide[static_cast<std::size_t>(p.of - Programme::slide)] = value;
  else if (p.of == Programme::shear_rate) stage.shear_rate = value;
  else if (p.of == Programme::gravity_size) stage.gravity_size = value;
  else if (p.of == Programme::gravity_angle) stage.gravity_angle = value;
}

void require_place(Visitor& v, const Programme& p, const Stage& stage, const Recipe& recipe) {
  const auto& frame = recipe.container;
  if (p.drives_side()) {
    const auto kind = stage.side[static_cast<std::size_t>(p.side())].kind;
    v.require(kind == SideDrive::Kind::fixed || static_cast<int>(kind) == 1 + p.drive(), {"of"},
              fmt::format("the {} side does something else in this stage; leave out \"{}\" there", side_names[p.side()], side_names[p.side()]));
  } else if (p.of < Programme::shear_rate) {
    const int side = p.of - Programme::slide;
    v.require(!frame.is_periodic(side), {"of"}, fmt::format("there is no wall at the {}: the container is periodic there", side_names[side]));
  } else if (p.of == Programme::shear_rate) {
    v.require(frame.periodic_x && frame.periodic_y, {"of"}, "only a cell that is periodic both ways is sheared so");
  } else if (!p.drives_boundary()) {
    v.require(stage.gravity, {"of"}, "grains do not weigh in this stage; write gravity = true");
  }
}

void declare(Visitor& v, Programme& p, const Stage& stage, const Recipe& recipe) {
  v.choice({"of",
            "What it drives: a side's velocity (inward), force or pressure, a wall along itself, the rate of shear, gravity, or a boundary: its place or angle "
            "from where it is as the stage begins, its velocity or spin, or the force on it.",
            true},
           p.of, mapped(dem::programme_targets, [](const auto& target) {
             return Word{target.word, ""};
           }));
  v.when(p.drives_boundary(), "of = \"boundary...\"", [&](Visitor& inner) { inner.text({"boundary", "Which boundary.", true}, p.name); });
  const auto& target = dem::programme_targets[static_cast<std::size_t>(p.of)];
  v.series({"table",
            "Times from the beginning of the stage and values in the target's unit (mm, mm/s, N, kN, kPa, 1/s, m/s^2, deg or deg/s), linear in between, and as "
            "the first "
            "and last row say before and after them; two rows of one time are a jump. Or the name of a CSV file of these two columns with their units "
            "(`time [s],force [kN]`).",
            true},
           p.table, target.unit);
  v.flag({"repeat", "The table starts again after its last time, for cycles."}, p.repeat);
  const auto later = [](const Vec2& a, const Vec2& b) { return a.x > b.x; };
  const bool in_order = !p.table.empty() && p.table.front().x >= 0 && std::adjacent_find(p.table.begin(), p.table.end(), later) == p.table.end();
  v.require(in_order, {"table"}, "needs a row or more, with times that begin at 0 s or later and never go back");
  v.require(!p.repeat || (in_order && p.table.back().x > 0), {"repeat", "table"}, "only a table that takes some time can begin anew");
  const bool may_be_negative = (p.drives_side() && p.drive() == 0) || (p.of >= Programme::slide && p.of != Programme::gravity_size);
  v.require(may_be_negative || std::all_of(p.table.begin(), p.table.end(), [](const Vec2& row) { return row.y >= 0; }), {"table"},
            fmt::format("no value of {} may be below 0", target.word));
  require_place(v, p, stage, recipe);
}

}  // namespace

void declare_store_every(Visitor& v, std::optional<std::int64_t>& every) {
  v.integer({"store_every", "States are stored once in so many cycles, and for the first and the last; unless given, for all. Curves against cycles hold all."},
            every, {1, 1'000'000});
}

void declare_programmes(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.list<Programme>({"programmes", "Tables in time that drive the stage, which then needs a duration. They are followed step by step."}, stage.programmes,
                    [&](Visitor& inner, Programme& p) { declare(inner, p, stage, recipe); });
  for (const Programme& p : stage.programmes) {
    const auto same = std::count_if(stage.programmes.begin(), stage.programmes.end(), [&](const Programme& other) {
      if (p.drives_boundary()) return other.drives_boundary() && other.name == p.name && other.boundary_axis() == p.boundary_axis();
      return other.of == p.of || (p.drives_side() && other.drives_side() && other.side() == p.side());
    });
    v.require(same == 1, {"programmes"}, fmt::format("{} is driven by two of them", dem::programme_targets[static_cast<std::size_t>(p.of)].word));
    if (!p.table.empty() && !p.drives_boundary()) begin_with(p, stage);
  }
}

void declare_strain_cycles(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.optional_section<dem::StrainCycles>(
      {"strain_cycles", "Cycles between two strains, each half at a constant rate; they end the stage. The first half goes from the beginning to `max`."},
      stage.strain_cycles, [&](Visitor& inner, dem::StrainCycles& cycles) {
        inner.choice({"of", "What moves."}, cycles.of,
                     {{"left", ""},
                      {"right", ""},
                      {"bottom", ""},
                      {"top", "this side; strains are those of the sample across, positive inward"},
                      {"shear", "a cell that is periodic both ways, sheared to and fro"}});
        inner.number({"min", "Strain at the end of each cycle."}, cycles.min, "", range::between(-0.9, 0.9));
        inner.number({"max", "Strain in the middle of each cycle.", true}, cycles.max, "", range::between(-0.9, 0.9));
        inner.require(cycles.max > cycles.min, {"max", "min"}, "must be above min");
        inner.number({"rate", "Of strain.", true}, cycles.rate, "1/s", range::positive);
        inner.integer({"count", "Number of cycles.", true}, cycles.count, {1, 1'000'000'000});
        declare_store_every(inner, cycles.store_every);
        const auto of = static_cast<std::size_t>(cycles.of);
        if (cycles.of == dem::StrainCycles::shear)
          inner.require(recipe.container.periodic_x && recipe.container.periodic_y, {"of"}, "only a cell that is periodic both ways is sheared so");
        else
          inner.require(stage.side[of].kind == SideDrive::Kind::fixed, {"of"},
                        fmt::format("the {} side does something else in this stage; leave it \"fixed\"", side_names[of]));
      });
  v.require(!stage.strain_cycles || !stage.duration, {"duration", "strain_cycles"}, "cycles of strain end the stage themselves; leave out its duration");
  v.require(!stage.strain_cycles || (!stage.cycles && stage.programmes.empty()), {"strain_cycles", "cycles", "programmes"},
            "only one of them can drive a stage");
  v.require(stage.programmes.empty() || stage.duration, {"programmes", "duration"},
            "a stage with programmes needs its duration, for example duration = \"1 s\"");
  v.require(stage.programmes.empty() || !stage.cycles, {"programmes", "cycles"}, "only one of them can drive a stage");
}

}  // namespace arenite::recipe
