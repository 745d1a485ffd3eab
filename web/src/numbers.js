import { h, rich } from "./dom.js";
import { criticalTiles } from "./figures/test_curves.js";
import { prefixOf, text } from "./text.js";
import { tile } from "./tile.js";

const plain = (name) => name.replace("-", "\u2013");

/** An estimate times `scale`, as text: "0.124 ± 0.029". */
function written(estimate, scale = 1, digits = 4) {
  if (estimate === undefined || estimate === null) return "";
  if (typeof estimate === "number") return Number.isInteger(estimate) && scale === 1 ? text.count(estimate) : text.number(estimate * scale, digits);
  const { value, error } = text.withError(estimate.value * scale, estimate.error * Math.abs(scale));
  return [value, error && h("small", {}, ` \u00b1 ${error}`)];
}

/** What the program declares of a number of the texture, by its dotted name: unit and sentence. */
function declared(t, name) {
  const [unit, sentence] = t.meanings?.[name] ?? ["", ""];
  return { unit: unit === "deg" ? "\u00b0" : unit, sentence };
}

/** The prefix that suits the largest of some estimates: { scale, unit }. */
function inUnit(estimates, unit) {
  const largest = Math.max(0, ...estimates.filter(Boolean).map((e) => Math.abs(e.value ?? e)));
  const { factor, prefix } = prefixOf(largest, unit);
  return { scale: 1 / factor, unit: prefix + unit };
}

/** A table with a row a set and a column a statistic; `columns` = [{ head, unit, of, scale, digits, sentence }]. */
export function grid(title, sets, columns) {
  const shown = columns.filter(({ of }) => sets.some(([, set]) => of(set) !== undefined && of(set) !== null));
  return h("table", {}, h("caption", {}, title),
    h("thead", {}, h("tr", {}, h("th"), shown.map(({ head, unit, sentence }) => h("th", { title: sentence || null }, rich(head), unit && h("small", {}, `, ${unit}`))))),
    h("tbody", {}, sets.map(([name, set]) => h("tr", {}, h("td", {}, plain(name)), shown.map(({ of, scale, digits }) => h("td", {}, written(of(set), scale, digits)))))));
}

/** The same of sets of a texture: `columns` = [[head, key, digits]], the unit and what it is as the program declares them for the set of all. */
function gridOf(t, group, title, sets, columns) {
  return grid(title, sets, columns.map(([head, key, digits]) => {
    const { unit, sentence } = declared(t, `${group}.${key}`), of = (set) => set[key];
    return { head, sentence, of, digits, ...(unit === "" || unit === "\u00b0" ? { unit } : inUnit(sets.map(([, set]) => of(set)), unit)) };
  }));
}

/** A table of single numbers; rows = [name, symbol, estimate, its dotted name], with the unit that the program declares. */
function list(t, title, rows) {
  const known = rows.filter(([, , estimate]) => estimate !== undefined && estimate !== null);
  if (known.length === 0) return null;
  return h("table", {}, h("caption", {}, title), h("tbody", {}, known.map(([name, symbol, estimate, dotted]) => {
    const about = declared(t, dotted), { scale, unit } = inUnit([estimate], about.unit);
    return h("tr", { title: about.sentence || null }, h("td", {}, name, symbol && [" ", h("span", { class: "symbol" }, rich(symbol))]), h("td", {}, written(estimate, scale), unit && h("small", {}, `\u202f${unit}`)));
  })));
}

function structure(t) {
  return list(t, "Structure", [
    ["grains", "N_{p}", t.considered?.grains, "considered.grains"], ["contacts", "N_{c}", t.considered?.contacts, "considered.contacts"],
    ["solid fraction", "\u03c6", t.solid_fraction, "solid_fraction"], ["local order", "\u03c8_{6}", t.local_order?.psi6, "local_order.psi6"],
    ["rattlers", "", t.coordination?.rattlers, "coordination.rattlers"],
  ]);
}

function coordination(t, materials) {
  const z = t.coordination ?? {};
  const names = materials.length > 1 ? Object.keys(z).filter((name) => name.includes("-")) : [];
  return list(t, "Coordination z", [["all", "", z.all, "coordination.all"], ["without rattlers", "", z.without_rattlers, "coordination.without_rattlers"],
    ...names.sort((a, b) => b.endsWith("-ANY") - a.endsWith("-ANY")).map((name) => [plain(name).replace("ANY", "any"), "", z[name], `coordination.${name}`])]);
}

function fabric(t) {
  const f = t.fabric;
  if (!f?.a_c) return null;
  const sets = [["all", f], ...Object.entries(f.sets ?? {}).filter(([name]) => !/ (strong|weak)$/.test(name))];
  return gridOf(t, "fabric", "Fabric", sets, [["N_{c}", "contacts"], ["a_{c}", "a_c"], ["noise", "a_c_noise", 2], ["\u03b8_{c}", "theta_c_deg"], ["a_{n}", "a_n"]]);
}

function stress(t) {
  const d = t.stress_details ?? {};
  const part = (i, j) => t.stress && { value: t.stress.value[i][j], error: t.stress.error?.[i]?.[j] };
  return list(t, "Stress of the assembly", [
    ["", "\u03c3_{xx}", part(0, 0), "stress"], ["", "\u03c3_{yy}", part(1, 1), "stress"], ["", "\u03c3_{xy}", part(0, 1), "stress"],
    ...[["pressure", "p", "pressure_Pa"], ["deviator", "q", "deviator_Pa"], ["axis of compression", "", "axis_of_compression_deg"], ["strong share of p", "", "strong_share_of_pressure"],
      ["strong share of q", "", "strong_share_of_deviator"]].map(([name, symbol, key]) => [name, symbol, d[key], `stress_details.${key}`]),
  ]);
}

function sets(all, parts) { return all ? [["all", all], ...Object.entries(parts ?? {})] : []; }

function grainStress(t) {
  const rows = sets(t.sigma_norm, t.sigma_norm?.by_material);
  return rows.length === 0 ? null : gridOf(t, "sigma_norm", "Stress of grains", rows, [["\u27e8\u03c3_{hyd}\u27e9", "mean_Pa"], ["P_{0}", "P0"], ["\u03b2", "beta"], ["max \u03c3_{norm}", "maximum", 3]]);
}

function forces(t) {
  const rows = sets(t.force, t.force?.by_type);
  return rows.length === 0 ? null : gridOf(t, "force", "Contact forces", rows, [
    ["\u27e8F_{n}\u27e9", "mean_N"], ["above mean", "strong_share"], ["\u03b1", "alpha"], ["\u03b2", "beta"], ["T eq. 1.5", "beta2_over_product"],
  ]);
}

/** The six numbers that one asks for first; those of a critical state before all others. */
export function headlines(sample, state) {
  const box = h("div", { class: "headlines" });
  const refresh = () => {
    const t = sample.texture(state.get("frame"));
    if (!t) return box.replaceChildren();
    const critical = criticalTiles(sample.stages[sample.about.frames[state.get("frame")].stage]).map((tile) => [...tile, 1, ""]);
    const tiles = [
      ...critical,
      ["solid fraction", "\u03c6", t.solid_fraction, 1, ""],
      ["coordination", "z", t.coordination?.all, 1, ""],
      ["anisotropy", "a_{c}", t.fabric?.a_c, 1, ""],
      ["mean force", "\u27e8F_{n}\u27e9", t.force?.mean_N, null, "N"],
      ["strong contacts", "", t.force?.strong_share, 100, "%"],
      ["grains above mean", "P_{0}", t.sigma_norm?.P0, 100, "%"],
    ].slice(0, 6);
    box.replaceChildren(...tiles.map(([name, symbol, estimate, scale, unit]) => {
      if (!estimate) return tile(name, symbol, "\u2013");
      const { factor, prefix } = scale === null ? prefixOf(estimate.value, unit) : { factor: 1 / scale, prefix: "" };
      const { value, error } = text.withError(estimate.value / factor, estimate.error / factor);
      return tile(name, symbol, value, h("small", {}, error && ` \u00b1 ${error}`, unit && `\u202f${prefix}${unit}`));
    }));
  };
  state.watch(["frame"], refresh);
  refresh();
  return box;
}

/** What is measured of a packing, in three columns with a caption and notes; `title` above it. */
export function textureCard(title, t, materials) {
  const column = (...tables) => h("div", {}, tables.filter(Boolean));
  return h("section", { class: "card numbers" }, h("div", { class: "title" }, h("h3", {}, title)),
    h("div", { class: "tables" }, column(structure(t), coordination(t, materials)), column(fabric(t), forces(t)), column(grainStress(t), stress(t))),
    h("p", { class: "caption" }, rich("With standard errors, from grains away from the walls. a_{c}, \u03b8_{c}: contact orientations; noise: a_{c} of as many random orientations; a_{n}: normal forces.")), h("ul", { class: "notes" }, (t.notes ?? []).map((note) => h("li", {}, note))));
}

/** Every number with its standard error and unit, for the state that is shown. */
export function numbersTable(sample, state) {
  const holder = h("div");
  const refresh = () => holder.replaceChildren(textureCard("Numbers", sample.texture(state.get("frame")) ?? {}, sample.materials));
  state.watch(["frame"], refresh);
  refresh();
  return holder;
}
