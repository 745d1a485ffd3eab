import { prefixOf, text } from "./text.js";

/** Keys whose words are not the field's: what stands instead. */
const names = {
  sigma_yy: "\u03c3_{yy}",
  sigma_xx: "\u03c3_{xx}",
  sigma_xy: "\u03c3_{xy}",
  sigma_hyd: "\u03c3_{hyd}",
  sigma_norm: "\u03c3_{norm}",
  psi6: "local order \u03c8_{6}",
  a_c: "a_{c}",
  a_c_signed: "a_{c}, signed",
  a_c_noise: "noise of a_{c}",
  phi: "\u03c6",
  a_n: "a_{n}",
  a_t: "a_{t}",
  theta_c: "\u03b8_{c}",
  theta_n: "\u03b8_{n}",
  P0: "P_{0}",
  alpha: "\u03b1",
  beta: "\u03b2",
  S_m: "S_{m}",
  r2: "R^{2}",
  line_r2: "R^{2} of a line",
  q_gaussian: "q-Gaussian",
  p_value: "p-value",
  cv: "coefficient of variation",
  rms: "r.m.s.",
  dx: "node spacing",
  lockin: "lock-in",
  fn_error: "s.e. of F_{n}",
  ft_error: "s.e. of F_{t}",
  thinnest_neck_nodes: "nodes across the thinnest neck",
  smallest_grain_nodes: "nodes across the smallest grain",
  modulus: "apparent modulus",
};

/** Symbols that stand beside words. */
const symbols = { stress: "\u03c3", solid_fraction: "\u03c6", pressure: "p", deviator: "q", modulus: "E" };

const letters = (words) => words.replaceAll("_per_", "_").replace(/[^A-Za-z0-9]/g, "");

/** A key without the unit at its end: "work_J_per_m" in J/m is "work". */
function stemOf(key, unit) {
  for (let at = key.indexOf("_"); unit && at > 0; at = key.indexOf("_", at + 1))
    if (letters(key.slice(at)) === letters(unit)) return key.slice(0, at);
  return key;
}

/** Words and symbol of a key: { name, symbol }. */
export function named(key, unit = "") {
  const stem = stemOf(key, unit),
    coordination = /^Z_([ls]{1,2})$/.exec(stem);
  if (coordination) return { name: `Z_{${coordination[1]}}`, symbol: "" };
  return {
    name:
      names[stem] ??
      stem
        .replaceAll("_", " ")
        .replace("-ANY", "-any")
        .replace(/(?<=\w)-(?=\w)/, "\u2013"),
    symbol: symbols[stem] ?? "",
  };
}

export const isEstimate = (v) => v !== null && typeof v === "object" && "value" in v && !Array.isArray(v.value);
const isTensor = (v) => Array.isArray(v?.value);
const isLeaf = (v) =>
  ["number", "boolean"].includes(typeof v) || (typeof v === "string" && v.length <= 60) || isEstimate(v) || isTensor(v);
const isGroup = (v) => v !== null && typeof v === "object" && !Array.isArray(v) && !("value" in v) && !("as" in v);

export const valueOf = (number) => number?.value ?? number;

/** Numbers as statistics declare them: a group of a tree, with unit and sentence of each by its dotted name in the
    whole tree (`meanings` of the document). Whatever is shown of them is noted, so that what no row names can stand at
    the end. */
export class Numbers {
  /** `elsewhere`: names that the page tells otherwise than in a table. */
  constructor(tree, meanings = {}, elsewhere = [], path = "", shown = new Set()) {
    Object.assign(this, { tree: tree ?? {}, meanings, elsewhere, path, shown });
  }

  #dotted(name) {
    return this.path ? `${this.path}.${name}` : name;
  }

  /** A group within; empty where there is none. */
  in(name) {
    return new Numbers(this.tree[name], this.meanings, this.elsewhere, this.#dotted(name), this.shown);
  }

  /** Number at a dotted name; undefined where it is not known. */
  at(name) {
    return this.tree[name] ?? name.split(".").reduce((tree, step) => tree?.[step], this.tree) ?? undefined;
  }

  /** What the program declares of it: { unit, sentence }. */
  about(name) {
    const [unit, sentence] = this.meanings[this.#dotted(name)] ?? ["", ""];
    return { unit, sentence };
  }

  /** A number as a row shows it: [{ name, symbol, value, unit, sentence }], of a tensor its three components; none
      where it is not known. */
  row(name) {
    const value = this.at(name),
      about = this.about(name),
      words = named(name in this.tree ? name : name.split(".").at(-1), about.unit);
    if (value === undefined || !isLeaf(value)) return [];
    this.shown.add(this.#dotted(name));
    if (!isTensor(value)) return [{ ...words, ...about, value }];
    const part = (i, j) => ({ value: value.value[i][j], error: value.error?.[i]?.[j] });
    return [
      ["xx", part(0, 0)],
      ["yy", part(1, 1)],
      ["xy", part(0, 1)],
    ].map(([axes, one]) => ({ name: `${words.symbol || words.name}_{${axes}}`, symbol: "", ...about, value: one }));
  }

  /** Names of the numbers of this group that nothing has shown yet. */
  get left() {
    return Object.keys(this.tree).filter(
      (name) => isLeaf(this.tree[name]) && !this.elsewhere.includes(name) && !this.shown.has(this.#dotted(name)),
    );
  }

  /** Groups within: [[name, Numbers]]. */
  get parts() {
    return Object.keys(this.tree)
      .filter((name) => isGroup(this.tree[name]) && !this.elsewhere.includes(name))
      .map((name) => [name, this.in(name)]);
  }
}

/** A number as text with the prefix that suits it, or that of `size`: { value, error, unit }. */
export function inWords(number, unit, size = Math.abs(valueOf(number))) {
  if (typeof number === "boolean") return { value: number ? "yes" : "no", error: "", unit: "" };
  if (typeof number === "string") return { value: number, error: "", unit: "" };
  const value = valueOf(number),
    error = number?.error ?? 0;
  if (!unit && Number.isInteger(value) && !error) return { value: text.count(value), error: "", unit: "" };
  const { factor, unit: prefixed } = prefixOf(size, unit);
  return { ...text.withError(value / factor, error / factor), unit: prefixed };
}
