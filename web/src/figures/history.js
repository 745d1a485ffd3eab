import * as Plot from "@observablehq/plot";
import { prefixOf } from "../text.js";
import { chart, decadesAround, logAxis } from "./chart.js";

const sides = ["bottom", "top", "left", "right"];

/** The stage of the state that is shown. */
export const stageOf = (sample, state) => sample.stages[sample.about.snapshots[state.get("snapshot")].stage];

/** The columns of these names of one stage: { name, unit, rows: [{ x: time since the stage began, s; y }] }. */
function columns(stage, names) {
  const { time } = stage.history;
  if (!time || time.length < 2) return [];
  return names
    .filter((name) => stage.history[name])
    .map((name) => ({
      name,
      unit: stage.history[name].unit,
      rows: Array.from(stage.history[name], (y, k) => ({ x: time[k] - time[0], y })),
    }));
}

const anyStageHas = (sample, names) => sample.stages.some((stage) => columns(stage, names).length > 0);

function lineColours(theme) {
  return [
    theme.materialLine[0],
    theme.materialLine[1],
    theme.mixedLine[0],
    theme.materialLine[3],
    theme.mixedLine[1],
    theme.weak,
    theme.strong,
  ];
}

const dashes = [null, "6 3", null, "6 3"];

function now(sample, state, theme) {
  const start = stageOf(sample, state).history.time[0];
  return Plot.ruleX([Math.max(0, sample.about.snapshots[state.get("snapshot")].time - start)], {
    stroke: theme.accent,
    strokeWidth: 1.25,
  });
}

const timeAxis = (sample, state) => ({
  label: `time in \u201c${stageOf(sample, state).name}\u201d`,
  short: "time",
  unit: stageOf(sample, state).history.time.unit,
  ticks: 5,
});

/** The points of lines for tips: { rows, name }. */
const pointsOf = (lines) => lines.flatMap(({ rows, name }) => rows.map((r) => ({ ...r, name })));

export const wallForces = {
  id: "wall-forces",
  title: "Forces on the walls",
  follows: true,
  caption: "Normal force of the grains on each wall over the loading; vertical line: the state shown.",
  when: (texture, sample) =>
    anyStageHas(
      sample,
      sides.map((side) => `${side}_force`),
    ),
  key: ({ theme }) => sides.map((name, k) => ({ name, colour: lineColours(theme)[k], dash: dashes[k], values: [] })),
  draw({ sample, state, theme, width }) {
    const lines = columns(
      stageOf(sample, state),
      sides.map((side) => `${side}_force`),
    );
    if (lines.length === 0) return null;
    const largest = Math.max(...lines.flatMap(({ rows }) => rows.map((r) => Math.abs(r.y))));
    const { factor, unit } = prefixOf(largest, lines[0].unit);
    return chart(theme, {
      width,
      height: 254,
      x: timeAxis(sample, state),
      y: { label: "force", unit },
      tips: {
        points: pointsOf(
          lines.map(({ rows, name }) => ({
            name: name.replace("_force", " wall"),
            rows: rows.map(({ x, y }) => ({ x, y: y / factor })),
          })),
        ),
      },
      marks: [
        now(sample, state, theme),
        ...lines.map(({ rows, name }) => {
          const k = sides.findIndex((side) => name.startsWith(side));
          return Plot.line(rows, {
            x: "x",
            y: (r) => r.y / factor,
            stroke: lineColours(theme)[k],
            strokeWidth: 1.6,
            strokeDasharray: dashes[k],
          });
        }),
      ],
    });
  },
};

const stored = [
  ["elastic", "elastic"],
  ["kinetic", "kinetic"],
  ["dissipated_friction", "friction"],
  ["dissipated_normal", "dashpots"],
  ["dissipated_drag", "drag"],
  ["work_walls", "work of walls"],
  ["work_gravity", "work of gravity"],
];

function energyLines(stage) {
  return columns(
    stage,
    stored.map(([name]) => name),
  )
    .map((line) => ({
      label: stored.find(([name]) => name === line.name)[1],
      unit: line.unit,
      rows: line.rows.filter((r) => r.y > 0),
    }))
    .filter((line) => line.rows.length > 1);
}

export const energies = {
  id: "energies",
  title: "Energies",
  follows: true,
  caption: "Stored and dissipated energy and work, on a logarithmic scale, which shows positive values only.",
  when: (texture, sample) => sample.stages.some((stage) => energyLines(stage).length > 0),
  key: ({ sample, state, theme }) =>
    energyLines(stageOf(sample, state)).map(({ label }, k) => ({
      name: label,
      colour: lineColours(theme)[k],
      values: [],
    })),
  draw({ sample, state, theme, width }) {
    const lines = energyLines(stageOf(sample, state));
    if (lines.length === 0) return null;
    const high = Math.max(...lines.flatMap(({ rows }) => rows.map((r) => r.y)));
    const low = Math.max(Math.min(...lines.flatMap(({ rows }) => rows.map((r) => r.y))), 1e-7 * high);
    const domain = decadesAround(low, high);
    return chart(theme, {
      width,
      height: 254,
      x: timeAxis(sample, state),
      y: { ...logAxis("energy", domain), unit: lines[0].unit, clamp: true },
      tips: {
        points: pointsOf(lines.map(({ label, rows }) => ({ name: label, rows: rows.filter((r) => r.y >= domain[0]) }))),
      },
      marks: [
        now(sample, state, theme),
        ...lines.map(({ rows }, k) =>
          Plot.line(
            rows.filter((r) => r.y >= domain[0]),
            { x: "x", y: "y", stroke: lineColours(theme)[k], strokeWidth: 1.5 },
          ),
        ),
      ],
    });
  },
};

const measures = [
  ["unbalanced_ratio", "unbalanced force ratio"],
  ["kinetic_ratio", "kinetic/elastic energy"],
  ["loose_kinetic_ratio", "kinetic/elastic energy of rattlers"],
  ["falling", "fraction of falling grains"],
  ["mobilisation", "mean |F_{t}|/F_{n}"],
];

export const approach = {
  id: "equilibrium",
  title: "Approach to equilibrium",
  follows: true,
  caption: "Distance of the sample from equilibrium during loading; every increment ends in equilibrium.",
  when: (texture, sample) => anyStageHas(sample, ["unbalanced_ratio"]),
  key: ({ theme }) => measures.map(([, name], k) => ({ name, colour: lineColours(theme)[k], values: [] })),
  draw({ sample, state, theme, width }) {
    const lines = columns(
      stageOf(sample, state),
      measures.map(([name]) => name),
    ).map(({ name, rows }) => ({
      k: measures.findIndex(([known]) => known === name),
      rows: rows.filter((r) => r.y > 0 && r.y < 1e3),
    }));
    if (lines.every(({ rows }) => rows.length < 2)) return null;
    const all = lines.flatMap(({ rows }) => rows.map((r) => r.y));
    const domain = decadesAround(Math.max(1e-10, Math.min(...all)), Math.max(...all));
    return chart(theme, {
      width,
      height: 254,
      x: timeAxis(sample, state),
      y: logAxis("ratio", domain),
      tips: {
        points: pointsOf(
          lines.map(({ k, rows }) => ({ name: measures[k][1], rows: rows.filter((r) => r.y >= domain[0]) })),
        ),
      },
      marks: [
        now(sample, state, theme),
        ...lines.map(({ rows, k }) =>
          Plot.line(
            rows.filter((r) => r.y >= domain[0]),
            { x: "x", y: "y", stroke: lineColours(theme)[k], strokeWidth: 1.3 },
          ),
        ),
      ],
    });
  },
};

export const forceDisplacement = {
  id: "travel",
  title: "Force-displacement curve",
  follows: true,
  caption:
    "Force on the wall that moves farthest in this stage against its displacement into the sample; dots: stored states.",
  when: (texture, sample) => sample.stages.some((stage) => movingWall(stage)),
  draw({ sample, state, theme, width }) {
    const stage = stageOf(sample, state),
      moving = movingWall(stage);
    if (!moving) return null;
    const { side, inward } = moving;
    const position = stage.history[`${side}_position`],
      force = stage.history[`${side}_force`];
    const { factor, unit } = prefixOf(
      force.reduce((most, f) => Math.max(most, Math.abs(f)), 0),
      force.unit,
    );
    const point = (x, f) => ({ x: 1e3 * inward * (x - position[0]), y: f / factor });
    const curve = Array.from(position, (x, k) => point(x, force[k]));
    const wall = ["left", "right", "bottom", "top"].indexOf(side);
    const states = sample.about.snapshots
      .map((snapshot, k) => ({ snapshot, k }))
      .filter(({ snapshot }) => sample.stages[snapshot.stage] === stage)
      .map(
        ({
          snapshot: {
            domain: { walls },
          },
          k,
        }) => ({ ...point(walls[wall].position, walls[wall].force), here: k === state.get("snapshot") }),
      );
    return chart(theme, {
      width,
      height: 254,
      x: { label: `displacement of the ${side} wall`, short: "displacement", unit: "mm" },
      y: { label: "force", unit },
      tips: { points: curve, by: "both", reach: 200 },
      marks: [
        Plot.line(curve, { x: "x", y: "y", stroke: theme.weak, strokeWidth: 1.1 }),
        Plot.dot(states, {
          x: "x",
          y: "y",
          fill: (d) => (d.here ? theme.accent : theme.strong),
          r: (d) => (d.here ? 5 : 3),
        }),
      ],
    });
  },
};

function movingWall(stage) {
  let best = null;
  for (const [side, inward] of [
    ["left", 1],
    ["right", -1],
    ["bottom", 1],
    ["top", -1],
  ]) {
    const position = stage.history[`${side}_position`];
    if (!position || position.length < 2 || !stage.history[`${side}_force`]) continue;
    const way = Math.abs(position.at(-1) - position[0]);
    if (way > (best?.way ?? 1e-9)) best = { side, inward, way };
  }
  return best;
}
