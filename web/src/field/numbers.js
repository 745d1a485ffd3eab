import { h, rich } from "../dom.js";
import { prefixOf, text } from "../text.js";

const units = [["_MPa", "MPa"], ["_Pa", "Pa"], ["_m2", "m\u00b2"], ["_J_m", "J/m"], ["_N_m", "N/m"], ["_N", "N"], ["_m", "m"], ["_s", "s"], ["_deg", "\u00b0"], ["_percent", "%"], ["_MB", "MB"], ["_mK", "mK"], ["_K", "K"], ["_Hz", "Hz"], ["_px", "px"]];
const hidden = new Set(["provenance", "stages", "notes", "curves", "pdf", "cumulative", "histogram", "recipe"]);

/** Symbols whose index looks like a unit. */
const symbols = /^(S_m|Z_[ls]{1,2})$/;

/** Name and unit of a key of the numbers: "mean_Pa" is "mean" in Pa. */
function named(key) {
  if (symbols.test(key)) return { name: key.replace(/_(.*)/, "_{$1}"), unit: "" };
  const [ending, unit] = units.find(([end]) => key.endsWith(end)) ?? ["", ""];
  return { name: key.slice(0, key.length - ending.length).replaceAll("_", " "), unit };
}

const isEstimate = (v) => v !== null && typeof v === "object" && !Array.isArray(v) && "value" in v && !Array.isArray(v.value);
const isLeaf = (v) => ["number", "string", "boolean"].includes(typeof v) || isEstimate(v);
const isGroup = (v) => v !== null && typeof v === "object" && !Array.isArray(v) && !isEstimate(v);

function written(value, unit) {
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value;
  const size = isEstimate(value) ? value.value : value;
  if (!unit && Number.isInteger(size) && !value.error) return text.count(size);
  const { factor, prefix } = prefixOf(Math.abs(size), unit);
  const { value: number, error } = text.withError(size / factor, (value.error ?? 0) / factor);
  return [number, error && h("small", {}, ` \u00b1 ${error}`), unit && h("small", {}, `\u202f${prefix}${unit}`)];
}

function leaves(group) {
  return Object.entries(group).filter(([key, v]) => isLeaf(v) && !hidden.has(key) && !(typeof v === "string" && v.length > 60));
}

function list(title, group) {
  const rows = leaves(group);
  if (rows.length === 0) return null;
  return h("table", {}, h("caption", {}, title), h("tbody", {}, rows.map(([key, value]) => {
    const { name, unit } = named(key);
    return h("tr", {}, h("td", {}, rich(name)), h("td", {}, written(value, unit)));
  })));
}

/** Groups that have their keys in common become the rows of one table. */
function grid(title, groups) {
  const keys = [...new Set(groups.flatMap(([, group]) => leaves(group).map(([key]) => key)))];
  return h("table", { class: "wide" }, h("caption", {}, title),
    h("thead", {}, h("tr", {}, h("th"), keys.map((key) => h("th", {}, rich(named(key).name))))),
    h("tbody", {}, groups.map(([name, group]) => h("tr", {}, h("td", {}, name.replaceAll("_", " ")),
      keys.map((key) => h("td", {}, isLeaf(group[key]) ? written(group[key], named(key).unit) : ""))))));
}

function alike(groups) {
  if (groups.length < 2) return false;
  const keys = groups.map(([, group]) => leaves(group).map(([key]) => key));
  return keys.every((list) => list.length > 0 && list.filter((key) => keys[0].includes(key)).length * 2 > list.length);
}

/** Tables of everything that a group of numbers holds, its parts after it. */
function tables(title, group) {
  const parts = Object.entries(group).filter(([key, v]) => isGroup(v) && !hidden.has(key));
  const own = list(title, group);
  if (alike(parts)) return [own, grid(`${title}${title ? ": " : ""}by set`, parts), ...parts.flatMap(([key, part]) => inner(`${title} ${key}`, part))];
  return [own, ...parts.flatMap(([key, part]) => tables(label(title, key), part))];
}

const inner = (title, part) => Object.entries(part).filter(([key, v]) => isGroup(v) && !hidden.has(key)).flatMap(([key, v]) => tables(label(title, key), v));

function label(title, key) {
  const words = `${title && title !== "Result" ? `${title}, ` : ""}${key.replaceAll("_", " ")}`;
  return words[0].toUpperCase() + words.slice(1);
}

const isWide = (table) => table.classList.contains("wide");

/** Every number of a result, as `arenite show --json` gives it, in tables. */
export function resultNumbers(result) {
  const all = tables("Result", result.numbers ?? {}).filter(Boolean);
  if (all.length === 0) return null;
  const notes = result.numbers.notes ?? [];
  return h("section", { class: "card numbers" }, h("div", { class: "title" }, h("h3", {}, "Numbers")),
    all.filter(isWide).map((table) => h("div", { class: "scroller" }, table)),
    h("div", { class: "tables flowing" }, all.filter((table) => !isWide(table))), h("ul", { class: "notes" }, notes.map((note) => h("li", {}, note))));
}
