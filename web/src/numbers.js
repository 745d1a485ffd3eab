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

/** The prefix that suits the largest of some estimates: { scale, unit }. */
function inUnit(estimates, unit) {
  const largest = Math.max(0, ...estimates.filter(Boolean).map((e) => Math.abs(e.value ?? e)));
  const { factor, prefix } = prefixOf(largest, unit);
  return { scale: 1 / factor, unit: prefix + unit };
}

/** A table with a row a set and a column a statistic; `columns` = [{ head, unit, of, scale, digits }]. */
export function grid(title, sets, columns) {
  const shown = columns.filter(({ of }) => sets.some(([, set]) => of(set) !== undefined && of(set) !== null));
  return h("table", {}, h("caption", {}, title),
    h("thead", {}, h("tr", {}, h("th"), shown.map(({ head, unit }) => h("th", {}, rich(head), unit && h("small", {}, `, ${unit}`))))),
    h("tbody", {}, sets.map(([name, set]) => h("tr", {}, h("td", {}, plain(name)), shown.map(({ of, scale, digits }) => h("td", {}, written(of(set), scale, digits)))))));
}

/** A table of single numbers; rows = [name, symbol, estimate, unit, scale]. */
function list(title, rows) {
  const known = rows.filter(([, , estimate]) => estimate !== undefined && estimate !== null);
  if (known.length === 0) return null;
  return h("table", {}, h("caption", {}, title), h("tbody", {}, known.map(([name, symbol, estimate, unit = "", scale = 1]) =>
    h("tr", {}, h("td", {}, name, symbol && [" ", h("span", { class: "symbol" }, rich(symbol))]), h("td", {}, written(estimate, scale), unit && h("small", {}, `\u202f${unit}`))))));
}

function structure(t) {
  return list("Structure", [
    ["grains", "N_{p}", t.considered?.grains], ["contacts", "N_{c}", t.considered?.contacts],
    ["solid fraction", "\u03c6", t.solid_fraction], ["local order", "\u03c8_{6}", t.local_order?.psi6],
    ["rattlers", "", t.coordination?.rattlers, "%", 100],
  ]);
}

function coordination(t, materials) {
  const z = t.coordination ?? {};
  const names = materials.length > 1 ? Object.keys(z).filter((name) => name.includes("-")) : [];
  return list("Coordination z", [["all", "", z.all], ["without rattlers", "", z.without_rattlers],
    ...names.sort((a, b) => b.endsWith("-ANY") - a.endsWith("-ANY")).map((name) => [plain(name).replace("ANY", "any"), "", z[name]])]);
}

function fabric({ fabric: f }) {
  if (!f?.a_c) return null;
  const sets = [["all", f], ...Object.entries(f.sets ?? {}).filter(([name]) => !/ (strong|weak)$/.test(name))];
  return grid("Fabric", sets, [
    { head: "N_{c}", of: (s) => s.contacts }, { head: "a_{c}", of: (s) => s.a_c }, { head: "noise", digits: 2, of: (s) => s.a_c_noise },
    { head: "\u03b8_{c}", unit: "\u00b0", of: (s) => s.theta_c_deg }, { head: "a_{n}", of: (s) => s.a_n },
  ]);
}

function stress(t) {
  const d = t.stress_details ?? {};
  const part = (i, j) => t.stress && { value: t.stress.value[i][j], error: t.stress.error?.[i]?.[j] };
  const { scale, unit } = inUnit([part(0, 0), part(1, 1)], "Pa");
  return list("Stress of the assembly", [
    ["", "\u03c3_{xx}", part(0, 0), unit, scale], ["", "\u03c3_{yy}", part(1, 1), unit, scale], ["", "\u03c3_{xy}", part(0, 1), unit, scale],
    ["pressure", "p", d.pressure_Pa, unit, scale], ["deviator", "q", d.deviator_Pa, unit, scale],
    ["axis of compression", "", d.axis_of_compression_deg, "\u00b0"],
    ["strong share of p", "", d.strong_share_of_pressure, "%", 100], ["strong share of q", "", d.strong_share_of_deviator, "%", 100],
  ]);
}

function sets(all, parts) { return all ? [["all", all], ...Object.entries(parts ?? {})] : []; }

function grainStress({ sigma_norm: s }) {
  const rows = sets(s, s?.by_material);
  if (rows.length === 0) return null;
  const { scale, unit } = inUnit(rows.map(([, set]) => set.mean_Pa), "Pa");
  return grid("Stress of grains", rows, [
    { head: "\u27e8\u03c3_{hyd}\u27e9", unit, scale, of: (d) => d.mean_Pa }, { head: "P_{0}", unit: "%", scale: 100, of: (d) => d.P0 },
    { head: "\u03b2", of: (d) => d.beta }, { head: "max \u03c3_{norm}", digits: 3, of: (d) => d.maximum },
  ]);
}

function forces({ force: f }) {
  const rows = sets(f, f?.by_type);
  if (rows.length === 0) return null;
  const { scale, unit } = inUnit(rows.map(([, set]) => set.mean_N), "N");
  return grid("Contact forces", rows, [
    { head: "\u27e8F_{n}\u27e9", unit, scale, of: (d) => d.mean_N }, { head: "above mean", unit: "%", scale: 100, of: (d) => d.strong_share },
    { head: "\u03b1", of: (d) => d.alpha }, { head: "\u03b2", of: (d) => d.beta }, { head: "\u03b2\u00b2/(1\u2212\u03b1)(2\u2212\u03b1)", of: (d) => d.beta2_over_product },
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
