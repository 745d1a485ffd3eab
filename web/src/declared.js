import { prefixOf, text } from "./text.js";

let called = {};

/** Name and symbol of keys whose own words are not the field's are one thought of the program's
    (`report/number_words.hpp`): the page's data hold them, { key: [name, symbol] }. */
export function readWords(words) {
  called = words;
}

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
    own = stem
      .replaceAll("_", " ")
      .replace("-ANY", "-any")
      .replace(/(?<=\w)-(?=\w)/, "\u2013"),
    [name, symbol] = called[stem] ?? [own, ""];
  return { name, symbol };
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
