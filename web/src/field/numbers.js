import { h, rich } from "../dom.js";
import { prefixOf, text } from "../text.js";

const units = [["_Pa_m0.5", "Pa\u2009m^{1/2}"], ["_MPa", "MPa"], ["_Pa", "Pa"], ["_m2", "m\u00b2"], ["_J_per_m", "J/m"], ["_J_m", "J/m"], ["_N_m", "N/m"], ["_N", "N"], ["_m", "m"], ["_s", "s"], ["_deg", "\u00b0"], ["_percent", "%"], ["_MB", "MB"], ["_mK", "mK"], ["_K", "K"], ["_Hz", "Hz"], ["_px", "px"], ["_pixels", "px"]];

/** What is told elsewhere on the page, or is drawn. */
const hidden = new Set(["provenance", "stages", "notes", "curves", "pdf", "histogram", "own_histogram", "cumulative", "recipe", "texture", "contact_orientations"]);

/** Keys that are no words, and words that are not the field's. */
const names = {
  sigma_yy: "\u03c3_{yy}", sigma_xx: "\u03c3_{xx}", sigma_xy: "\u03c3_{xy}", sigma_hyd: "\u03c3_{hyd}", sigma_norm: "\u03c3_{norm}", S_m: "S_{m}", r2: "R^{2}", line_r2: "R^{2} of a line",
  q_gaussian: "q-Gaussian", beta: "\u03b2", p_value: "p-value", cv: "coefficient of variation", rms: "r.m.s.", dx: "node distance", lockin: "lock-in", fn_error: "s.e. of F_{n}", ft_error: "s.e. of F_{t}",
  bad_pixels: "bad pixels", lost_necks: "lost necks", thinnest_neck_nodes: "nodes across the thinnest neck", smallest_grain_nodes: "nodes across the smallest grain",
  fraction_above_mean: "fraction above the mean", fraction_above_own_mean: "fraction above own mean", fraction_above_sample_mean: "fraction above sample mean",
};

/** Name and unit of a key of the numbers: "mean_Pa" is "mean" in Pa. */
export function named(key) {
  const coordination = /^Z_([ls]{1,2})$/.exec(key);
  if (coordination) return { name: `Z_{${coordination[1]}}`, unit: "" };
  if (names[key]) return { name: names[key], unit: "" };
  const [ending, unit] = units.find(([end]) => key.endsWith(end)) ?? ["", ""], stem = key.slice(0, key.length - ending.length);
  return { name: names[stem] ?? stem.replaceAll("_", " "), unit };
}

const isEstimate = (v) => v !== null && typeof v === "object" && !Array.isArray(v) && "value" in v && !Array.isArray(v.value);
const isLeaf = (v) => ["number", "string", "boolean"].includes(typeof v) || isEstimate(v);
const isGroup = (v) => v !== null && typeof v === "object" && !Array.isArray(v) && !isEstimate(v) && !("value" in v);

function written(value, unit) {
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value;
  const size = isEstimate(value) ? value.value : value;
  if (!unit && Number.isInteger(size) && !value.error) return text.count(size);
  const { factor, prefix } = prefixOf(Math.abs(size), unit);
  const { value: number, error } = text.withError(size / factor, (value.error ?? 0) / factor);
  return [number, error && h("small", {}, ` \u00b1 ${error}`), unit && h("small", {}, "\u202f", rich(prefix + unit))];
}

const leaves = (group) => Object.entries(group).filter(([key, v]) => isLeaf(v) && !hidden.has(key) && !(typeof v === "string" && v.length > 60));
const parts = (group) => Object.entries(group).filter(([key, v]) => isGroup(v) && !hidden.has(key));
const kinds = (sets, of) => [...new Set(sets.flatMap(([, set]) => of(set).map(([key]) => key)))];


function areAlike(sets) {
  if (sets.length < 2) return false;
  const keys = sets.map(([, set]) => [...leaves(set), ...parts(set)].map(([key]) => key));
  return keys.every((own) => own.length > 0 && own.filter((key) => keys[0].includes(key)).length * 2 > own.length);
}

/** Tables of everything that a group of numbers holds, as { title, keys, rows: [[name, group]] }: its own, then its parts. What
    is said of several sets alike stands in one table for all of them, level by level. */
export function tables(title, group) {
  const sets = parts(group), own = leaves(group).length > 0 ? [{ title, keys: null, rows: leaves(group) }] : [];
  if (!areAlike(sets)) return [...own, ...sets.flatMap(([key, part]) => tables(within(title, key), part))];
  const deeper = kinds(sets, parts).map((key) => [key, Object.fromEntries(sets.filter(([, set]) => isGroup(set[key])).map(([name, set]) => [name, set[key]]))]);
  const keys = kinds(sets, leaves), together = keys.length > 0 ? [{ title, keys, rows: sets }] : [];
  return [...own, ...together, ...deeper.flatMap(([key, of]) => tables(within(title, key), of))];
}

/** "Stress, σ_yy, tail"; whose parts are sets of nodes or grains is not said. */
function within(title, key) {
  if (key === "sets") return title;
  const words = [title === "Result" ? "" : title, named(key).name].filter(Boolean).join(", ");
  return words[0].toUpperCase() + words.slice(1);
}

/** A row a number, or a row a set; a set's name may hold the unit of all its numbers. */
function drawn({ title, keys, rows }) {
  const cell = (value, unit) => h("td", {}, isLeaf(value) ? written(value, unit) : "");
  return h("table", {}, h("caption", {}, rich(title)),
    keys && h("thead", {}, h("tr", {}, h("th"), keys.map((key) => h("th", {}, rich(named(key).name))))),
    h("tbody", {}, rows.map(([key, value]) => [named(key), value]).map(([{ name, unit }, value]) => h("tr", {}, h("td", {}, rich(name)),
      keys ? keys.map((k) => cell(value[k], named(k).unit || unit)) : cell(value, unit)))));
}

const between = (all, least, most) => all.filter(({ keys }) => (keys?.length ?? 1) >= least && (keys?.length ?? 1) <= most).map(drawn);

/** Every number of a result, as `arenite show --json` gives it, in tables that are folded. */
export function resultNumbers(result) {
  const all = tables("Result", result.numbers ?? {});
  if (all.length === 0) return null;
  const notes = result.numbers.notes ?? [];
  return h("section", { class: "card numbers" }, h("details", {}, h("summary", {}, h("h3", {}, "All numbers")),
    h("div", { class: "tables flowing" }, between(all, 1, 2)), h("div", { class: "tables even" }, between(all, 3, 5)),
    between(all, 6, Infinity).map((table) => h("div", { class: "scroller" }, table))), h("ul", { class: "notes" }, notes.map((note) => h("li", {}, note))));
}
