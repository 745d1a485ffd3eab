import { inWords, isEstimate, named, valueOf } from "./declared.js";
import { h, rich } from "./dom.js";
import { prefixOf } from "./text.js";

const cell = ({ value, error, unit }, withUnit = true) => [
  value,
  error && h("small", {}, ` \u00b1 ${error}`),
  withUnit && unit && h("small", {}, "\u202f", rich(unit)),
];

/** A table with a row a number, by dotted names, or [name, symbol] where one is to stand beside its words; null where
    none is known. */
export function list(title, numbers, dotted) {
  const rows = dotted
    .map((one) => [one].flat())
    .flatMap(([name, symbol]) => numbers.row(name).map((row) => ({ ...row, symbol: symbol ?? row.symbol })));
  if (rows.length === 0) return null;
  return h(
    "table",
    {},
    h("caption", {}, rich(title)),
    h(
      "tbody",
      {},
      rows.map(({ name, symbol, value, unit, sentence }) =>
        h(
          "tr",
          { title: sentence || null },
          h("td", {}, rich(name), symbol && [" ", h("span", { class: "symbol" }, rich(symbol))]),
          h("td", {}, cell(inWords(value, unit))),
        ),
      ),
    ),
  );
}

/** A table with a row a set, [[name, its Numbers]], and a column a number; `columns` = names, or [name, symbol] where a
    symbol stands for the words. A unit that a whole column has stands in its head. */
export function grid(title, sets, columns) {
  const shown = columns
    .map((column) => [column].flat())
    .flatMap(([name, symbol]) => {
      const rows = sets.map(([, numbers]) => numbers.row(name)); // of a tensor three, a column each
      return Array.from({ length: Math.max(...rows.map((row) => row.length)) }, (_, part) => ({
        symbol,
        cells: rows.map((row) => row[part]),
      }));
    });
  if (shown.length === 0) return null;
  const heads = shown.map(({ symbol, cells }) => {
    const known = cells.filter(Boolean),
      units = new Set(known.map(({ unit }) => unit)),
      [{ name, unit, sentence }] = known;
    const size = units.size === 1 && unit ? Math.max(...known.map(({ value }) => Math.abs(valueOf(value)))) : undefined;
    return { words: symbol ?? name, sentence, size, unit: size === undefined ? "" : prefixOf(size, unit).unit };
  });
  return h(
    "table",
    {},
    h("caption", {}, rich(title)),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th"),
        heads.map(({ words, sentence, unit }) =>
          h("th", { title: sentence || null }, rich(words), unit && h("small", {}, ", ", rich(unit))),
        ),
      ),
    ),
    h(
      "tbody",
      {},
      sets.map(([name, numbers], row) =>
        h(
          "tr",
          {},
          h("td", {}, rich(nameOf(name, numbers))),
          shown.map(({ cells }, k) =>
            h(
              "td",
              {},
              cells[row] &&
                cell(inWords(cells[row].value, cells[row].unit, heads[k].size), heads[k].size === undefined),
            ),
          ),
        ),
      ),
    ),
  );
}

/** A group's name; where all of its numbers have a unit, this may be in the name. */
function nameOf(group, numbers) {
  const units = new Set(Object.keys(numbers.tree).map((name) => numbers.about(name).unit));
  return named(group, units.size === 1 ? [...units][0] : "").name;
}

function areAlike(sets) {
  if (sets.length < 2) return false;
  const keys = sets.map(([, set]) => [...set.left, ...set.parts.map(([name]) => name)]),
    most = keys.reduce((a, b) => (b.length > a.length ? b : a));
  return keys.every((own) => own.length > 0 && own.filter((key) => most.includes(key)).length * 2 > own.length);
}

/** "Stress, σ_yy, tail"; whose parts are sets of nodes or grains is not said. */
function within(title, key, numbers) {
  if (["sets", "by_material", "by_type"].includes(key)) return title;
  return [title, nameOf(key, numbers)]
    .filter(Boolean)
    .join(", ")
    .replace(/^[a-z]/, (letter) => letter.toUpperCase());
}

/** What a group holds that nothing has shown, as { title, names, sets }: its own numbers, then its parts. What is said
    of several sets alike stands in one table for all of them, level by level; without sets it is a row a number. */
export function tables(title, numbers) {
  const sets = numbers.parts,
    own = numbers.left.length > 0 ? [{ title: title || "Result", names: numbers.left, numbers }] : [];
  if (!areAlike(sets)) return [...own, ...sets.flatMap(([key, part]) => tables(within(title, key, part), part))];
  return [...own, ...ofSets(title, sets)];
}

/** One table for all sets, and one for what is in each of them. */
function ofSets(title, sets) {
  const distinct = (of) => [...new Set(sets.flatMap(([, set]) => of(set)))],
    names = distinct((set) => set.left);
  const deeper = distinct((set) => set.parts.map(([key]) => key)).map((key) => [
    key,
    sets.filter(([, set]) => set.tree[key]).map(([name, set]) => [name, set.in(key)]),
  ]);
  return [
    ...(names.length > 0 ? [{ title, names, sets }] : []),
    ...deeper.flatMap(([key, of]) => ofSets(within(title, key, of[0][1]), of)),
  ];
}

const drawn = ({ title, names, sets, numbers }) => (sets ? grid(title, sets, names) : list(title, numbers, names));

/** Every number that no row names, in tables that are folded; null where there is none. */
export function remainder(numbers) {
  const title = numbers.shown.size > 0 ? "All other numbers" : "All numbers",
    all = tables("", numbers);
  if (all.length === 0) return null;
  const between = (least, most) =>
    all.filter(({ sets, names }) => (sets ? names.length : 1) >= least && (sets ? names.length : 1) <= most).map(drawn);
  return h(
    "details",
    { class: "remainder" },
    h("summary", {}, h("h3", {}, title)),
    h("div", { class: "tables flowing" }, between(1, 2)),
    h("div", { class: "tables even" }, between(3, 5)),
    between(6, Infinity).map((table) => h("div", { class: "scroller" }, table)),
  );
}

/** Every number of a result, as `arenite show --json` gives it, that no other card shows. */
export function resultNumbers(numbers) {
  const rest = remainder(numbers);
  return rest && h("section", { class: "card numbers" }, rest, notes(numbers));
}

export const notes = ({ tree }) =>
  h(
    "ul",
    { class: "notes" },
    (tree.notes ?? []).map((note) => h("li", {}, note)),
  );

/** Numbers that one asks for first: rows = [words, symbol, dotted name], with "%" behind them where a share is said in
    per cent, "\u2030" in per mille; or { words, value, unit } as they are written. */
export function tilesOf(numbers, rows) {
  return rows.map((row) => {
    if (!Array.isArray(row)) return { symbol: "", error: "", known: true, ...row };
    const [words, symbol, name, share] = row;
    const number = numbers.at(name),
      { unit, sentence } = numbers.about(name),
      times = { "%": 100, "\u2030": 1000 }[share] ?? 1;
    const scaled = isEstimate(number)
      ? { value: times * number.value, error: times * number.error }
      : typeof number === "number" && times > 1
        ? { value: times * number }
        : number;
    return {
      words,
      symbol,
      sentence,
      known: number !== undefined,
      ...(number === undefined ? { value: "\u2013", error: "", unit: "" } : inWords(scaled, unit)),
      ...(share && { unit: share }),
    };
  });
}

/** The tiles side by side. */
export function headlines(tiles) {
  return h(
    "div",
    { class: "headlines" },
    tiles.map(({ words, symbol, sentence, value, error, unit }) =>
      h(
        "div",
        { class: "tile", title: sentence || null },
        h("p", {}, words, symbol && [" ", h("i", {}, rich(symbol))]),
        h(
          "strong",
          {},
          value,
          (error || unit) && h("small", {}, error && ` \u00b1 ${error}`, unit && ["\u202f", rich(unit)]),
        ),
      ),
    ),
  );
}
