import { label, richSvg, s } from "../dom.js";
import { materialColour } from "../theme.js";
import { text } from "../text.js";
import { scaleBar } from "../scale_bar.js";
import { chainWidth } from "./chains.js";
import { crackKey } from "./bonds.js";
import { colourings, fadeUnderChains, scaleOf } from "./colouring.js";
import { middleOf } from "./scale.js";

export const legendHeight = 62;

/** The strip below the packing: what the colours mean, how thick which force is, and a bar of known length. */
export function legend(sample, snapshot, camera, theme, state, width) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft });
  const fade = state.get("chains") ? fadeUnderChains(state.get("colour")) : 0;
  group.append(colourKey(sample, theme, state, width, 1 - fade), brokenKey(sample, snapshot, theme, state, width));
  group.append(scaleBar(camera, theme, width));
  if (state.get("chains") && snapshot.meanForce > 0) group.append(chainKey(sample, snapshot, camera, theme, width));
  return richSvg(group);
}

const rampLength = (width) => Math.min(190, width * 0.34);

/** As pale as the grains are. */
function colourKey(sample, theme, state, width, opacity) {
  const scale = scaleOf(sample, state);
  if (scale) return ramp(scale, theme, rampLength(width), opacity);
  const names =
    colourings[state.get("colour")].key?.(sample, theme) ??
    sample.materials.map(({ name }, m) => [
      `${name} (${text.count(sample.materialCounts[m])})`,
      materialColour(theme, m),
    ]);
  const key = s("g");
  let x = 6;
  for (const [name, colour] of names) {
    key.append(dot(x + 1, 15, colour, theme, opacity), label(x + 13, 15, name));
    x += 34 + 6.4 * name.length;
  }
  return key;
}

/** How bonds broke, below the names of colours or beside their ramp. */
function brokenKey(sample, snapshot, theme, state, width) {
  const key = s("g");
  let x = scaleOf(sample, state) ? rampLength(width) + 26 : 0;
  for (const { name, colour } of crackKey(snapshot, theme)) {
    key.append(s("line", { x1: x, x2: x + 12, y1: 34, y2: 34, stroke: colour, "stroke-width": 2.5 }));
    key.append(label(x + 17, 34, name));
    x += 27 + 6.2 * name.length;
  }
  return key;
}

function dot(x, y, fill, theme, opacity) {
  return s("circle", { cx: x, cy: y, r: 6, fill, "fill-opacity": opacity, stroke: theme.ink, "stroke-opacity": 0.3 });
}

function ramp(scale, theme, length, opacity) {
  const group = s("g");
  const steps = 48,
    map = theme.maps[scale.map],
    write = (v) => text.number(v / scale.factor, 3);
  for (let k = 0; k < steps; ++k)
    group.append(
      s("rect", {
        x: (k * length) / steps,
        y: 18,
        width: length / steps + (opacity < 1 ? 0 : 0.6), // what is seen through would be darker twice
        height: 9,
        fill: map((k + 0.5) / steps),
        "fill-opacity": opacity,
      }),
    );
  const title = scale.unit ? `${scale.title}, ${scale.unit}` : scale.title;
  group.append(
    label(0, 8, title),
    label(0, 37, write(scale.low)),
    label(length / 2, 37, write(middleOf(scale)), "middle"),
    label(length, 37, (scale.open ? "\u2265\u202f" : "") + write(scale.high), "end"),
  );
  return group;
}

function chainKey(sample, snapshot, camera, theme, width) {
  const group = s("g");
  const entries = [
    { name: "weak", colour: theme.weak, force: 0.5 },
    { name: "strong", colour: theme.strong, force: 3 },
  ];
  if (snapshot.hasTension) entries.push({ name: "tension", colour: theme.tension, force: 1 });
  let x = 3;
  for (const { name, colour, force } of entries) {
    const stroke = Math.max(1.2, Math.min(9, chainWidth(sample, snapshot, force * snapshot.meanForce) * camera.scale));
    group.append(
      s("line", {
        x1: x,
        x2: x + 20,
        y1: 53,
        y2: 53,
        stroke: colour,
        "stroke-width": stroke,
        "stroke-linecap": "round",
      }),
      label(x + 29, 53, name),
    );
    x += 46 + 6.4 * name.length;
  }
  const mean = `F_{n} > \u27e8F_{n}\u27e9 = ${text.quantity(snapshot.meanForce, snapshot.contacts.fn.unit)}`;
  group.append(label(x + 2, 53, width < 480 ? mean : `thickness \u221d F_{n};  strong: ${mean}`));
  return group;
}
