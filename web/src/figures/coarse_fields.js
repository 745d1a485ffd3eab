import { label, richSvg, s } from "../dom.js";
import { evaluateAll, namesIn } from "../formula.js";
import { prefixOf, text, typeset } from "../text.js";
import { bytes, mapOfScale } from "../theme.js";

/** How the coarse-grained fields are drawn, beside what the program says of them (`layers` of the document: labels,
    symbols, units, formulas, scales of colours): `arrows` = with velocities. */
export const layers = {
  solid_fraction: {},
  density: {},
  speed: { arrows: true },
  vx: {},
  vy: {},
  vz: {},
  pressure: {},
  deviator: {},
  shear: {},
  shear_yz: {},
  shear_xz: {},
  kinetic: {},
};

/** Those that fields have: [[name, { label, symbol, unit }]]. `about` has what the program says of all. */
export const known = (fields, { about }) =>
  Object.keys(layers)
    .filter((name) => about.layers[name])
    .map((name) => [name, aboutLayer(name, about)])
    .filter(([name, { formula }]) => namesIn(formula || name).every((part) => part in (fields ?? {})));

export function aboutLayer(name, { layers: all }) {
  const [label, symbol, unit, formula, scale] = all[name];
  return { ...layers[name], label, symbol, unit, formula, map: mapOfScale[scale] };
}

export function valuesOf(fields, name, about) {
  const { formula } = aboutLayer(name, about);
  return formula ? evaluateAll(formula, fields.size, (part) => fields[part]) : fields[name];
}

export const inOrder = (values) => Float64Array.from(values).filter(Number.isFinite).sort();

/** The cells as a picture, one pixel a cell, which the drawing stretches. */
function pictureOf({ columns, rows }, values, [low, high], theme, map) {
  const canvas = Object.assign(document.createElement("canvas"), { width: columns, height: rows }),
    context = canvas.getContext("2d");
  const image = context.createImageData(columns, rows),
    table = Array.from({ length: 256 }, (_, k) => bytes(theme.maps[map](k / 255)));
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const value = values[row * columns + column],
        at = 4 * ((rows - 1 - row) * columns + column);
      if (!Number.isFinite(value)) continue;
      image.data.set(table[Math.round(255 * Math.min(1, Math.max(0, (value - low) / (high - low))))], at);
      image.data[at + 3] = 255;
    }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

/** About 16 arrows along the longer side; the longest is as long as their distance. */
function arrowsOf(fields, speed, place, theme) {
  const { columns, rows, vx, vy } = fields,
    step = Math.max(1, Math.round(Math.max(columns, rows) / 16)),
    [x0] = place(0, 0),
    [x1] = place(step, 0);
  const speeds = speed.filter(Number.isFinite).sort(),
    most = speeds[Math.floor(0.98 * (speeds.length - 1))] || 1;
  const group = s("g", {
    stroke: theme.ink,
    "stroke-width": 1.1,
    fill: "none",
    "stroke-linecap": "round",
    class: "arrows",
  });
  for (let row = step >> 1; row < rows; row += step)
    for (let column = step >> 1; column < columns; column += step) {
      const k = row * columns + column,
        scale = (0.95 * (x1 - x0)) / most,
        dx = vx[k] * scale,
        dy = -vy[k] * scale,
        length = Math.hypot(dx, dy);
      if (!(length > 1.5)) continue;
      const [x, y] = place(column, row),
        head = Math.min(4, 0.4 * length),
        ux = dx / length,
        uy = dy / length,
        ex = x + dx / 2,
        ey = y + dy / 2;
      group.append(
        s("path", {
          d:
            `M${ex - dx},${ey - dy}L${ex},${ey}` +
            `M${ex - head * (ux + 0.6 * uy)},${ey - head * (uy - 0.6 * ux)}L${ex},${ey}` +
            `L${ex - head * (ux - 0.6 * uy)},${ey - head * (uy + 0.6 * ux)}`,
        }),
      );
    }
  return group;
}

function ramp(words, map, si, [low, high], theme, y) {
  const { factor, unit } = prefixOf(Math.max(Math.abs(low), Math.abs(high)), si),
    length = 170,
    steps = 48;
  const bars = Array.from({ length: steps }, (_, k) =>
    s("rect", {
      x: (k * length) / steps,
      y: y + 16,
      width: length / steps + 0.6,
      height: 8,
      fill: theme.maps[map]((k + 0.5) / steps),
    }),
  );
  const at = (share, anchor) =>
    label(share * length, y + 34, text.number((low + share * (high - low)) / factor, 3), anchor);
  return s(
    "g",
    {},
    label(0, y + 6, unit ? `${words}, ${unit}` : words, null, { fill: theme.ink }),
    bars,
    at(0),
    at(0.5, "middle"),
    at(1, "end"),
  );
}

export const coarseFields = {
  follows: ["snapshot", "field"],
  when: (texture, sample) => sample.fields(0),
  pickers: {
    field: [
      "",
      (sample) => known(sample.fields(sample.snapshotCount - 1), sample).map(([name, layer]) => [name, layer.label]),
    ],
  },
  draw({ sample, state, theme, width }) {
    const fields = sample.fields(state.get("snapshot")),
      wanted = state.get("field"),
      name = known(fields, sample).some(([one]) => one === wanted) ? wanted : "solid_fraction";
    const layer = aboutLayer(name, sample.about),
      { label: words, unit } = layer,
      values = valuesOf(fields, name, sample.about),
      range = fields.ends[name],
      [left, right, bottom, top] = fields.bounds;
    const scale = Math.min(width / (right - left), 420 / (top - bottom)),
      w = scale * (right - left),
      h = scale * (top - bottom),
      x = (width - w) / 2;
    const place = (column, row) => [x + ((column + 0.5) * w) / fields.columns, h - ((row + 0.5) * h) / fields.rows];
    const svg = s(
      "svg",
      {
        viewBox: `0 0 ${width} ${h + 52}`,
        width,
        height: h + 52,
        "font-family": theme.font,
        "font-size": 11.5,
        fill: theme.soft,
      },
      s("image", {
        href: pictureOf(fields, values, range, theme, layer.map),
        x,
        y: 0,
        width: w,
        height: h,
        preserveAspectRatio: "none",
      }),
      s("rect", { x, y: 0.5, width: w, height: Math.max(0, h - 1), fill: "none", stroke: theme.rule }),
      layer.arrows && arrowsOf(fields, values, place, theme),
      ramp(words, layer.map, unit, range, theme, h + 8),
    );
    svg.numbers = [tableOf(fields, sample)];
    return richSvg(svg);
  },
};

/** Every cell with all its fields, SI. */
function tableOf(fields, sample) {
  const {
    columns,
    bounds: [left, right, bottom, top],
    rows,
  } = fields;
  const at = (k) => ({
    x: left + (((k % columns) + 0.5) * (right - left)) / columns,
    y: bottom + ((Math.floor(k / columns) + 0.5) * (top - bottom)) / rows,
  });
  return { x: "x, m", y: "y, m", points: rowsOfCells(fields, sample, at) };
}

/** What all cells have: `at(k)` of each, and in `more` its fields by their names with units. */
export function rowsOfCells(fields, sample, at) {
  const arrays = known(fields, sample).map(([name, { symbol, unit }]) => [
    [symbol, typeset(unit)].filter(Boolean).join(", "),
    valuesOf(fields, name, sample.about),
  ]);
  return Array.from({ length: fields.size }, (_, k) => {
    const { more, ...place } = at(k);
    return { ...place, more: { ...more, ...Object.fromEntries(arrays.map(([head, values]) => [head, values[k]])) } };
  });
}
