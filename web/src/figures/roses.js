import { richSvg, s } from "../dom.js";
import { pairColour } from "../theme.js";
import { text } from "../text.js";

const sectorCount = 18;

/** Polar histograms of contact orientations: all, by strength, by type; strong contacts darker within. */
export const roses = {
  id: "fabric",
  title: "Contact orientations",
  wide: true,
  caption:
    "Fraction of contacts in sectors of 10\u00b0, over the isotropic fraction (dashed circle); darker: strong contacts, F_{n} > \u27e8F_{n}\u27e9. " +
    "Line: 1 + a_{c} cos 2(\u03b8 \u2212 \u03b8_{c}). \u25b6 marks the axis of compression.",
  when: (texture) => texture.fabric?.sectors,
  draw({ sample, texture, theme, width }) {
    const list = sets(sample, texture, theme);
    const perRow = Math.min(list.length, width >= 1000 ? 6 : width >= 380 ? 3 : 2);
    const cell = width / perRow,
      radius = Math.min(0.5 * cell - 18, 88),
      height = 2 * radius + 96;
    const rows = Math.ceil(list.length / perRow);
    const svg = s("svg", {
      viewBox: `0 0 ${width} ${rows * height}`,
      width,
      height: rows * height,
      "font-family": theme.font,
      "font-size": 11.5,
      fill: theme.soft,
    });
    list.forEach((set, k) => {
      const x = ((k % perRow) + 0.5) * cell,
        y = Math.floor(k / perRow) * height + 26 + radius + 10;
      svg.append(s("g", { transform: `translate(${x} ${y})` }, rose(set, radius, theme, texture.fabric.load_axis_deg)));
    });
    svg.numbers = [
      {
        x: "direction, \u00b0",
        y: "contacts",
        points: list.flatMap(({ label, set }) =>
          set.sectors.map((y, k) => ({ name: label, x: ((k + 0.5) * 180) / set.sectors.length, y })),
        ),
      },
    ];
    return richSvg(svg);
  },
};

function sets(sample, texture, theme) {
  const { sets: named = {}, ...all } = texture.fabric;
  const found = (name) => (named[name]?.contacts > 0 ? named[name] : null);
  const list = [{ label: "all", colour: theme.strong, set: all, inner: found("strong") }];
  if (found("strong")) list.push({ label: "strong", colour: theme.strong, set: named.strong, inner: named.strong });
  if (found("weak")) list.push({ label: "weak", colour: theme.weak, set: named.weak });
  for (const type of sample.types) {
    if (sample.materials.length === 1 && !type.wall) continue; // they are all
    const name = [type.key, type.wall ? "" : `${type.key.split("-").reverse().join("-")}`].find((key) => found(key));
    if (name)
      list.push({
        label: type.label,
        colour: pairColour(theme, type),
        set: named[name],
        inner: found(`${name} strong`),
      });
  }
  return list;
}

/** How far a set's petals and its line reach, over the isotropic share. */
export const reachOf = (set) =>
  Math.max(1.6, ...set.sectors.map((n) => (n * sectorCount) / set.contacts), 1 + (set.a_c?.value ?? 0));

/** The polar histogram of one set about the origin; `reach` is what the outer circle stands for. */
export function rose({ label, colour, set, inner, reach = reachOf(set) }, radius, theme, loadAxis) {
  const isotropic = set.contacts / sectorCount;
  const scale = radius / reach;
  const group = s("g");
  group.append(s("circle", { r: radius, fill: "none", stroke: theme.rule }));
  for (const angle of [0, 45, 90, 135]) {
    const [dx, dy] = direction(angle, radius);
    group.append(s("line", { x1: -dx, y1: -dy, x2: dx, y2: dy, stroke: theme.rule }));
  }
  group.append(...petals(set.sectors, isotropic, scale, colour, inner ? 0.35 : 0.5));
  if (inner) group.append(...petals(inner.sectors, isotropic, scale, colour, 0.75));
  group.append(s("circle", { r: scale, fill: "none", stroke: theme.soft, "stroke-dasharray": "3 3" }));
  if (set.a_c && set.theta_c_deg)
    group.append(s("path", { d: fitted(set, scale), fill: "none", stroke: theme.ink, "stroke-width": 1.5 }));
  group.append(...axisMarks(loadAxis, radius, theme), ...captions(label, set, radius, theme));
  return group;
}

/** The point at an angle and a radius in an SVG, whose y points down. */
export function direction(degrees, r) {
  const angle = (degrees * Math.PI) / 180;
  return [r * Math.cos(angle), -r * Math.sin(angle)];
}

function petals(counts, isotropic, scale, fill, opacity) {
  return [...counts, ...counts].map((n, k) => {
    const r = (n / isotropic) * scale,
      step = 180 / sectorCount;
    const [x1, y1] = direction(k * step + 0.8, r),
      [x2, y2] = direction((k + 1) * step - 0.8, r);
    return s("path", {
      d: `M0,0L${x1.toFixed(2)},${y1.toFixed(2)}A${r.toFixed(2)},${r.toFixed(2)} 0 0 0 ${x2.toFixed(2)},${y2.toFixed(2)}Z`,
      fill,
      "fill-opacity": opacity,
    });
  });
}

function fitted(set, scale) {
  const path = [];
  for (let angle = 0; angle <= 360; angle += 3) {
    const r = (1 + set.a_c.value * Math.cos((2 * (angle - set.theta_c_deg.value) * Math.PI) / 180)) * scale;
    path.push(
      direction(angle, r)
        .map((v) => v.toFixed(2))
        .join(","),
    );
  }
  return `M${path.join("L")}Z`;
}

function axisMarks(degrees, radius, theme) {
  if (degrees === undefined) return [];
  return [degrees, degrees + 180].map((angle) => {
    const [x, y] = direction(angle, radius + 6);
    return s("path", {
      d: "M-5,0 L3,-3.6 L3,3.6Z",
      fill: theme.accent,
      transform: `translate(${x} ${y}) rotate(${-angle})`,
    });
  });
}

function captions(label, set, radius, theme) {
  const a = text.withError(set.a_c?.value, set.a_c?.error);
  const lost = set.a_c && set.a_c_noise && set.a_c.value < set.a_c_noise;
  const theta = text.withError(set.theta_c_deg?.value, set.theta_c_deg?.error);
  return [
    s(
      "text",
      { y: -radius - 18, "text-anchor": "middle", fill: theme.ink, "font-weight": 600, "font-size": 12 },
      label,
      s("tspan", { fill: theme.soft, "font-weight": 400 }, `  ${text.count(set.contacts)}`),
    ),
    s("text", { y: radius + 24, "text-anchor": "middle" }, `a_{c} = ${a.value}${a.error && ` \u00b1 ${a.error}`}`),
    s(
      "text",
      { y: radius + 39, "text-anchor": "middle" },
      lost
        ? `below its noise, ${text.number(set.a_c_noise, 2)}`
        : `\u03b8_{c} = ${theta.value}${theta.error && ` \u00b1 ${theta.error}`}\u00b0`,
    ),
  ];
}
