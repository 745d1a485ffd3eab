import { bar, colourBar } from "../colour_bar.js";
import { label, richSvg, s } from "../dom.js";
import { drawn, kindWords } from "../drawn.js";
import { scaleBar } from "../scale_bar.js";
import { text } from "../text.js";
import { byType } from "./cracks.js";
import { mapOf, scaleOf } from "./paint.js";

export const legendHeight = 92;

const narrow = 420; // px: a phone, on which the counts alone fit

/** The strip below the picture: what the colours mean, how the values are spread over them, and a bar of known length.
 */
export function legend(result, camera, theme, state, width, broken) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft });
  const scale = scaleOf(result, state),
    room = Math.max(150, Math.min(420, width - 150));
  if (scale) group.append(scaleKey(result, scale, theme, room));
  else if (state.get("show") === "phases") group.append(phaseKey(result, theme, width - 130));
  else group.append(cavityKey(result, theme, state, room));
  if (broken > 0) group.append(crackKey(result, theme, broken, width));
  else if (state.get("crosses") && result.loaded) group.append(crossKey(theme, width));
  group.append(scaleBar(camera, theme, width));
  return richSvg(group);
}

function scaleKey(result, scale, theme, length) {
  const { symbol } = result.quantity(scale.name),
    largest = Math.max(Math.abs(scale.low), Math.abs(scale.high));
  const mean = scale.name === "yy" || scale.mean > 0.02 * largest ? scale.mean : null;
  return colourBar({
    title: symbol,
    unit: result.unitOf(scale.name),
    scale,
    palette: mapOf(theme, scale),
    theme,
    length,
    mean,
  });
}

export const square = (x, y, fill, theme) =>
  s("rect", { x, y: y - 6, width: 12, height: 12, rx: 2.5, fill, stroke: theme.ink, "stroke-opacity": 0.25 });

/** Entries one after the other, on a new line where the room ends. */
export function flow(entries, room, draw) {
  const key = s("g");
  let x = 1,
    y = 11;
  for (const entry of entries) {
    const wide = 26 + 6.1 * entry.name.length;
    if (x > 1 && x + wide > room) [x, y] = [1, y + 20];
    key.append(draw(entry, x, y), label(x + 18, y, entry.name));
    x += wide;
  }
  return key;
}

function phaseKey({ map }, theme, room) {
  const entries = [4, 3, 2, 1, 0]
    .filter((kind) => map.share(kind) > 0)
    .map((kind) => ({
      kind,
      name: `${kindWords(kind, true)} ${text.number(100 * map.share(kind), 3)}\u202f%`,
    }));
  return flow(entries, room, ({ kind }, x, y) => square(x, y, theme.kind[kind], theme));
}

function cavityKey({ map }, theme, state, length) {
  const { nodes, fewest_nodes: fewest, specks, cut } = map.cavities[state.get("show")];
  const grey = `${text.count(cut)} cut by the edge, ${text.count(specks)} below ${fewest} nodes`;
  const words = `${text.count(nodes.length)} counted; grey: ${grey}`;
  const group = s("g", {}, label(0, state.get("cavities") === "size" ? 66 : 11, words));
  if (state.get("cavities") !== "size") return group;
  group.append(
    label(0, 11, "nodes, logarithmic"),
    bar(theme.stress, 0, 24, length, 11),
    label(0, 46, text.count(fewest)),
    label(length, 46, text.count(nodes.reduce((a, b) => Math.max(a, b), 0)), "end"),
  );
  return group;
}

function crackKey(result, theme, broken, width) {
  const counts = byType(result, broken),
    group = s("g", { transform: "translate(0 70)" });
  const entries = [1, 2, 3].map((type) => ({ type, name: `${drawn().cracks[type]} ${text.count(counts[type])}` }));
  group.append(
    flow([...(width < narrow ? [] : [{ type: 0, name: "broken bonds:" }]), ...entries], 1e9, ({ type }, x, y) =>
      type ? s("circle", { cx: x + 9, cy: y, r: 4, fill: theme.crack[type] }) : s("g"),
    ),
  );
  return group;
}

function crossKey(theme, width) {
  return s(
    "g",
    { transform: "translate(0 81)" },
    ...[
      ["tension", theme.cross.pull, 2],
      ["compression", theme.cross.push, 86],
    ].flatMap(([name, stroke, x]) => [
      s("line", { x1: x, x2: x + 18, y1: 0, y2: 0, stroke, "stroke-width": 3.5, "stroke-linecap": "round" }),
      label(x + 25, 0, name),
    ]),
    width > 460 ? label(196, 0, "principal stresses, thickness \u221d stress") : "",
  );
}
