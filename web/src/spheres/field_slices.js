import { colourBar } from "../colour_bar.js";
import { picker } from "../choice.js";
import { richSvg, s } from "../dom.js";
import { known, rowsOfCells, valuesOf } from "../figures/coarse_fields.js";
import { csvOf } from "../figures/csv.js";
import { fileName, saveText } from "../save.js";
import { axes } from "../space/frame.js";
import { slicesCard } from "../space/slices.js";
import { prefixOf, text } from "../text.js";
import { bytes } from "../theme.js";

const codes = 255; // rows of the table with colours; row 0 is for cells that no grain reaches
const legendHeight = 66;

/** The card with slices through the coarse-grained fields of the state shown: { card, slices, fields }. `head`: what
    the program says of it. */
export function fieldSlices(fields, state, head) {
  const show = () => fields.show(state.get("snapshot"));
  state.watch(["snapshot"], show);
  show();
  return { ...slicesCard(fields, state, lookOf(fields, state, head)), fields };
}

const shownOf = (fields, state) => fields.layer(state.get("field"));

const lookOf = (fields, state, { id, title, caption }) => ({
  painted: ["field", "snapshot", "theme"],
  index: (state) => {
    const { values, scale } = shownOf(fields, state);
    return Uint8Array.from(values, (v) =>
      Number.isFinite(v) ? 1 + Math.round((codes - 1) * Math.min(1, Math.max(0, scale.of(v)))) : 0,
    );
  },
  table: (state, theme) => {
    const { map } = shownOf(fields, state),
      table = new Uint8Array(4 * (codes + 1));
    table.set([...bytes(theme.field.empty), 255]);
    for (let k = 0; k < codes; ++k) table.set([...bytes(theme.maps[map](k / (codes - 1))), 255], 4 * (k + 1));
    return table;
  },
  numbers: (cell, state, theme) => numbersOf(fields, cell, shownOf(fields, state), theme),
  legend: (state, theme, width) => {
    const { label, symbol, unit, map, scale } = shownOf(fields, state),
      length = Math.max(150, Math.min(420, width - 60));
    const bar = colourBar({ title: `${label} ${symbol}`, unit, scale, palette: theme.maps[map], theme, length });
    return richSvg(s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft }, bar));
  },
  legendHeight,
  showsLegend: true,
  upright: 1,
  isSmooth: true,
  isWide: true,
  title: () => title,
  name: title,
  file: id,
  controls: pickerOf(fields, state),
  saves: { csv: () => saveText(`${fileName(fields.title, fields.name, id)}.csv`, "text/csv", tableOf(fields)) },
  caption: (state) => [caption, otherState(fields, state.get("snapshot")), kernelOf(fields)].filter(Boolean).join(" "),
});

/** Of which state they are where that is not the one that is shown. */
const otherState = ({ shown, about }, snapshot) =>
  shown === snapshot ? null : `These are of state ${about.states[shown].label}.`;

const kernelOf = ({ state, size }) =>
  `Standard deviation of the kernel along an axis: ${text.quantity(state.width, "m")}; ` +
  `${size.map(text.count).join(" \u00d7 ")} cells.`;

const pickerOf = (fields, state) =>
  picker(
    "",
    "field",
    state,
    fields.offered.map(([name, { label }]) => [name, label]),
  );

/** A cell: its place, the field that is shown, and the others of its state. */
function numbersOf(fields, cell, shown, theme) {
  const k = fields.indexOf(cell),
    { state } = fields,
    places = cell.map((layer, axis) => state.place(axis, layer)),
    { factor, unit } = prefixOf(Math.max(...places.map(Math.abs)), "m"),
    isReached = Number.isFinite(shown.values[k]);
  const rows = [["x, y, z", `${places.map((place) => text.number(place / factor, 3)).join(", ")}\u202f${unit}`]];
  if (isReached)
    for (const [name, { symbol, unit: of }] of known(state, fields))
      rows.push([symbol, text.quantity(valuesOf(state, name, fields.about)[k], of)]);
  return {
    title: isReached ? `${shown.label} ${text.quantity(shown.values[k], shown.unit)}` : "No grain in reach",
    colour: isReached ? theme.maps[shown.map](shown.scale.of(shown.values[k])) : theme.field.empty,
    rows,
  };
}

/** Every cell with all its fields, SI. */
function tableOf(fields) {
  const { state } = fields,
    [width, height] = state.cells;
  const at = (k) => {
    const cell = [k % width, Math.floor(k / width) % height, Math.floor(k / (width * height))],
      [x, y, z] = cell.map((layer, axis) => state.place(axis, layer));
    return { x, y, more: { [`${axes[2]}, m`]: z } };
  };
  return csvOf({ numbers: [{ x: `${axes[0]}, m`, y: `${axes[1]}, m`, points: rowsOfCells(state, fields, at) }] });
}
