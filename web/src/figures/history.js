import * as Plot from "@observablehq/plot";
import { prefixOf } from "../text.js";
import { chart, logAxis } from "./chart.js";

const sides = ["bottom", "top", "left", "right"];

/** All stages one after the other; a row is { t, stage } with one value a column. */
function timeline(sample, names) {
  return names.map((name) => ({
    name,
    rows: sample.stages.flatMap((stage) => {
      const time = stage.history.time?.values, values = stage.history[name]?.values;
      return time && values ? Array.from(values, (y, k) => ({ x: time[k], y })) : [];
    }),
  })).filter(({ rows }) => rows.length > 1);
}

const has = (sample, names) => timeline(sample, names).length > 0;

function lineColours(theme) {
  return [theme.materialLine[0], theme.materialLine[1], theme.mixedLine[0], theme.materialLine[3], theme.mixedLine[1], theme.weak, theme.strong];
}

const dashes = [null, "6 3", null, "6 3"];

function now(sample, state, theme) {
  const { time } = sample.about.frames[state.get("frame")];
  return Plot.ruleX([time], { stroke: theme.accent, strokeWidth: 1.25 });
}

export const wallForces = {
  id: "wall-forces", title: "Forces on the walls", follows: true,
  caption: "Normal force of the grains on each wall over the loading; vertical line: the state shown.",
  when: (texture, sample) => has(sample, sides.map((side) => `${side}_force`)),
  key: ({ theme }) => sides.map((name, k) => ({ name, colour: lineColours(theme)[k], dash: dashes[k], values: [] })),
  draw({ sample, state, theme, width }) {
    const lines = timeline(sample, sides.map((side) => `${side}_force`));
    const largest = Math.max(...lines.flatMap(({ rows }) => rows.map((r) => Math.abs(r.y))));
    const { factor, prefix } = prefixOf(largest, "N");
    return chart(theme, {
      width, height: 254,
      x: { label: "time, s" }, y: { label: `force, ${prefix}N` },
      marks: [now(sample, state, theme), ...lines.map(({ rows, name }) => {
        const k = sides.findIndex((side) => name.startsWith(side));
        return Plot.line(rows, { x: "x", y: (r) => r.y / factor, stroke: lineColours(theme)[k], strokeWidth: 1.6, strokeDasharray: dashes[k] });
      })],
    });
  },
};

const stored = [["elastic", "elastic"], ["kinetic", "kinetic"], ["dissipated_friction", "friction"], ["dissipated_normal", "dashpots"], ["dissipated_drag", "drag"], ["work_walls", "work of walls"], ["work_gravity", "work of gravity"]];

function energyLines(sample) {
  return timeline(sample, stored.map(([name]) => name)).map((line) => ({ ...line, label: stored.find(([name]) => name === line.name)[1], rows: line.rows.filter((r) => r.y > 0) }))
    .filter((line) => line.rows.length > 1);
}

export const energies = {
  id: "energies", title: "Energies", follows: true,
  caption: "Stored and dissipated energy and work, logarithmic; only what is positive can be shown.",
  when: (texture, sample) => energyLines(sample).length > 0,
  key: ({ sample, theme }) => energyLines(sample).map(({ label }, k) => ({ name: label, colour: lineColours(theme)[k], values: [] })),
  draw({ sample, state, theme, width }) {
    const lines = energyLines(sample);
    const high = Math.max(...lines.flatMap(({ rows }) => rows.map((r) => r.y)));
    const domain = [10 ** (Math.ceil(Math.log10(high)) - 9), 10 ** Math.ceil(Math.log10(high))];
    return chart(theme, {
      width, height: 254,
      x: { label: "time, s" }, y: { ...logAxis("energy, J", domain), clamp: true },
      marks: [now(sample, state, theme), ...lines.map(({ rows }, k) => Plot.line(rows.filter((r) => r.y >= domain[0]), { x: "x", y: "y", stroke: lineColours(theme)[k], strokeWidth: 1.5 }))],
    });
  },
};

export const travel = {
  id: "travel", title: "Load against travel", follows: true,
  caption: "Force on the wall that moved farthest against its travel into the sample; dots: stored states.",
  when: (texture, sample) => movingWall(sample) !== null,
  draw({ sample, state, theme, width }) {
    const { side, inward } = movingWall(sample);
    const position = timeline(sample, [`${side}_position`])[0].rows, force = timeline(sample, [`${side}_force`])[0].rows;
    const { factor, prefix } = prefixOf(Math.max(...force.map((r) => Math.abs(r.y))), "N");
    const start = position[0].y;
    const rows = position.map((r, k) => ({ x: 1e3 * inward * (r.y - start), y: force[k].y / factor }));
    const index = ["left", "right", "bottom", "top"].indexOf(side);
    const states = sample.about.frames.map((frame, k) => ({
      x: 1e3 * inward * (frame.domain.walls[index].position - start), y: frame.domain.walls[index].force / factor, here: k === state.get("frame"),
    }));
    return chart(theme, {
      width, height: 254,
      x: { label: `travel of the ${side} wall, mm` }, y: { label: `force, ${prefix}N` },
      marks: [
        Plot.line(rows, { x: "x", y: "y", stroke: theme.weak, strokeWidth: 1, strokeOpacity: 0.8 }),
        Plot.dot(states, { x: "x", y: "y", fill: (d) => (d.here ? theme.accent : theme.strong), r: (d) => (d.here ? 5 : 3) }),
      ],
    });
  },
};

function movingWall(sample) {
  let best = null;
  for (const [side, inward] of [["left", 1], ["right", -1], ["bottom", 1], ["top", -1]]) {
    const rows = timeline(sample, [`${side}_position`])[0]?.rows;
    if (!rows || !timeline(sample, [`${side}_force`]).length) continue;
    const way = Math.abs(rows.at(-1).y - rows[0].y);
    if (way > (best?.way ?? 1e-9)) best = { side, inward, way };
  }
  return best;
}
