import { s } from "../dom.js";
import { drawn, kindOfForce, widthOfForce } from "../drawn.js";
import { boundaryShapes } from "../packing/overlay.js";
import { materialColour } from "../theme.js";

/** Colours of stresses over the mean, up to so many of them. */
export const stressKey = (theme, most) =>
  Array.from({ length: most + 1 }, (_, v) => ({
    name: v === most ? `${v} and more` : `${v}`,
    colour: theme.stress(v / most),
  }));

/** One sample: its grains by material, with their normal forces as lines as wide as strong, or coloured by their stress
    over the mean; its boundaries as the page of a run has them. */
export function sampleFigure(figure) {
  const { sample } = figure,
    [across, up] = sample.size;
  return {
    id: figure.id,
    title: figure.title,
    key: ({ theme }) => (sample.stress ? stressKey(theme, drawn().most_stress.grains) : materialKey(theme, sample)),
    draw({ theme, width }) {
      const scale = width / across,
        height = Math.ceil(up * scale);
      const toScreen = (x, y) => [x * scale, (up - y) * scale],
        place = (k) => toScreen(sample.x[k], sample.y[k]),
        outline = (k) => (sample.rims ? rim(sample.rims[k], toScreen) : disk(place(k), sample.r[k] * scale));
      const svg = s("svg", { viewBox: `0 0 ${width} ${height}`, width, height });
      const most = drawn().most_stress.grains,
        fill = sample.stress
          ? (k) => theme.stress(Math.round(24 * Math.min(1, Math.max(0, sample.stress[k] / most))) / 24)
          : (k) => materialColour(theme, sample.material[k]);
      const disks = grouped(sample.x.keys(), fill, outline);
      for (const [colour, d] of disks) svg.append(s("path", { d, fill: colour, "fill-opacity": sample.f ? 0.28 : 1 }));
      const glued = [...sample.x.keys()].filter((k) => sample.glued[k]);
      if (glued.length > 0)
        svg.append(
          s("path", {
            d: glued.map(outline).join(""),
            fill: "none",
            stroke: theme.accent,
            "stroke-width": 1.2,
          }),
        );
      if (sample.f) svg.append(...chains(sample, place, scale, theme));
      svg.append(...boundaryShapes(sample, { toScreen }, theme));
      return svg;
    },
  };
}

function materialKey(theme, { materials = [], material, glued, f, tension }) {
  const names = materials
    .map((name, m) => ({ name, colour: materialColour(theme, m) }))
    .filter((_, m) => material.includes(m));
  const last = [
    glued.includes(1) && { name: "glued", colour: theme.accent },
    ...kindsOfForces
      .filter((kind) => f?.some((force) => kindOfForce(force, { mean: 1, tension }) === kind))
      .map((name) => ({ name, colour: theme[name] })),
  ];
  return [...(names.length > 1 ? names : []), ...last.filter(Boolean)];
}

function grouped(keys, kind, shape) {
  const paths = new Map();
  for (const k of keys) paths.set(kind(k), (paths.get(kind(k)) ?? "") + shape(k));
  return paths;
}

function rim({ x, y }, toScreen) {
  const corner = (_, p) =>
    toScreen(x[p], y[p])
      .map((v) => v.toFixed(2))
      .join(",");
  return `M${x.map(corner).join("L")}Z`;
}

function disk([x, y], r) {
  const d = (2 * r).toFixed(2),
    a = `a${r.toFixed(2)},${r.toFixed(2)} 0 1,0`;
  return `M${(x - r).toFixed(2)},${y.toFixed(2)}${a} ${d},0${a} -${d},0`;
}

const steps = 4, // of the widths of lines in that of the mean force
  kindsOfForces = ["weak", "strong", "tension"]; // in the order of drawing

/** Forces over the mean as the page of a run draws them; lines of like colour and width are one path. */
function chains({ i, j, f, r, tension }, place, scale, theme) {
  const meanRadius = (scale * r.reduce((a, b) => a + b, 0)) / r.length,
    width = (c) => widthOfForce(Math.max(0.5, Math.round(steps * Math.abs(f[c]))) / steps, 1, meanRadius).toFixed(3),
    kind = (c) => kindOfForce(f[c], { mean: 1, tension });
  const line = (c) =>
    `M${[i[c], j[c]]
      .map((k) =>
        place(k)
          .map((v) => v.toFixed(2))
          .join(","),
      )
      .join("L")}`;
  return kindsOfForces.flatMap((name) => {
    const alike = [...f.keys()].filter((c) => kind(c) === name);
    return [...grouped(alike, width, line)].map(([wide, d]) =>
      s("path", { d, stroke: theme[name], "stroke-width": wide, "stroke-linecap": "round", fill: "none" }),
    );
  });
}
