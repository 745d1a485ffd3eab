import { Numbers } from "../declared.js";
import { h, rich } from "../dom.js";
import { grid, headlines, list, notes, remainder, tilesOf } from "../numbers.js";

const structure = (t) =>
  list("Structure", t, [
    ["considered.grains", "N_{p}"],
    ["considered.contacts", "N_{c}"],
    "solid_fraction",
    "local_order.psi6",
    "coordination.rattlers",
  ]);

/** Of pairs of materials where there are several, those with any other material first. */
function coordination(t) {
  const pairs = Object.keys(t.in("coordination").tree)
    .filter((name) => name.includes("-"))
    .sort((a, b) => b.endsWith("-ANY") - a.endsWith("-ANY"));
  return list("Coordination z", t.in("coordination"), ["all", "without_rattlers", ...pairs]);
}

function fabric(t) {
  const f = t.in("fabric"),
    sets = f.in("sets").parts.filter(([name]) => !/ (strong|weak)$/.test(name));
  return (
    f.at("a_c") &&
    grid("Fabric", [["all", f], ...sets], [["contacts", "N_{c}"], "a_c", ["a_c_noise", "noise"], "theta_c_deg", "a_n"])
  );
}

function stress(t) {
  return list("Stress of the assembly", t, [
    "stress",
    ...[
      "pressure_Pa",
      "deviator_Pa",
      "axis_of_compression_deg",
      "strong_share_of_pressure",
      "strong_share_of_deviator",
    ].map((name) => `stress_details.${name}`),
  ]);
}

const sets = (numbers, parts) => [["all", numbers], ...numbers.in(parts).parts];

const grainStress = (t) =>
  grid("Stress of grains", sets(t.in("sigma_norm"), "by_material"), [
    ["mean_Pa", "\u27e8\u03c3_{hyd}\u27e9"],
    "P0",
    "beta",
    ["maximum", "max \u03c3_{norm}"],
  ]);

const forces = (t) =>
  grid("Contact forces", sets(t.in("force"), "by_type"), [
    ["mean_N", "\u27e8F_{n}\u27e9"],
    ["strong_share", "above mean"],
    "alpha",
    "beta",
    ["beta2_over_product", "T eq. 1.5"],
  ]);

/** What is measured of a packing, in three columns with a caption, notes and at the end whatever no row names; `title`
    above it. */
export function textureCard(title, t) {
  const column = (...tables) => h("div", {}, tables.filter(Boolean));
  return h(
    "section",
    { class: "card numbers" },
    h("div", { class: "title" }, h("h3", {}, title)),
    h(
      "div",
      { class: "tables" },
      column(structure(t), coordination(t)),
      column(fabric(t), forces(t)),
      column(grainStress(t), stress(t)),
    ),
    h(
      "p",
      { class: "caption" },
      rich(
        "With standard errors, from grains away from the walls. a_{c}, \u03b8_{c}: contact orientations; " +
          "noise: a_{c} of the same number of random orientations; a_{n}: normal forces.",
      ),
    ),
    remainder(t),
    notes(t),
  );
}

const stageOf = (sample, state) => sample.stages[sample.about.snapshots[state.get("snapshot")].stage];

/** The numbers of the state shown, and what its stage gave. */
function numbersOf(sample, state) {
  const { numbers, meanings, elsewhere } = stageOf(sample, state);
  return new Numbers(
    { ...sample.texture(state.get("snapshot")), ...numbers },
    { ...sample.about.meanings, ...meanings },
    elsewhere,
  );
}

/** The six numbers that one asks for first: those of the stage's test that are known, then those of the grains. */
export function packingHeadlines(sample, state) {
  const box = h("div");
  const refresh = () => {
    const numbers = numbersOf(sample, state),
      stage = stageOf(sample, state),
      ofTest = tilesOf(numbers, stage.headlines).filter(({ known }) => known);
    box.replaceChildren(headlines([...ofTest, ...tilesOf(numbers, stage.headlines_of_grains)].slice(0, 6)));
  };
  state.watch(["snapshot"], refresh);
  refresh();
  return box;
}

/** What the sides of the stage shown were to press with, and what they did. */
export function loadsCard(sample, state) {
  const holder = h("div", { class: "loads" });
  const refresh = () => {
    const { numbers, meanings } = stageOf(sample, state),
      loads = new Numbers(numbers, meanings).in("loads"),
      names = Object.keys(Object.assign({}, ...loads.parts.map(([, side]) => side.tree))),
      column = (stem, words) => names.filter((name) => name.startsWith(stem)).map((name) => [name, words]);
    const table = grid("Loads", loads.parts, [
      ...column("asked_", "prescribed"),
      ...column("reached_", "reached"),
      ...column("spread_", "standard deviation"),
    ]);
    holder.replaceChildren(...(table ? [h("section", { class: "card" }, h("div", { class: "scroller" }, table))] : []));
    holder.hidden = !table;
  };
  state.watch(["snapshot"], refresh);
  refresh();
  return holder;
}

/** Every number with its standard error and unit, for the state that is shown; what is unfolded stays so. */
export function numbersTable(sample, state) {
  const holder = h("div");
  const refresh = () => {
    const open = holder.querySelector("details")?.open;
    holder.replaceChildren(textureCard("Numbers", numbersOf(sample, state)));
    if (open) holder.querySelector("details").open = true;
  };
  state.watch(["snapshot"], refresh);
  refresh();
  return holder;
}
