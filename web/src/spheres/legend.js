import { colourBar } from "../colour_bar.js";
import { label, richSvg, s } from "../dom.js";
import { kindOfForce } from "../drawn.js";
import { flow, square } from "../field/legend.js";
import { mapOf } from "../field/paint.js";
import { crackKey } from "../packing/bonds.js";
import { scaleBar } from "../scale_bar.js";
import { text } from "../text.js";
import { materialColour } from "../theme.js";
import { thicknessOf } from "./chains.js";
import { scaleOf } from "./paint.js";

export const legendHeight = 92;

const narrow = 480; // px

/** The strip below the picture: what the colours mean, how thick which force is, and a bar of known length. */
export function legend(result, state, theme, width, camera = null) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft }),
    scale = scaleOf(result, state);
  group.append(scale ? scaleKey(result, scale, theme, width) : materialKey(result, theme, width - 130));
  if (state.get("chains") && camera) group.append(forceKey(result, theme, width, camera, scale ? 82 : 46));
  else if (state.get("bonds") && camera) group.append(bondKey(result, theme, scale ? 82 : 46));
  if (camera) group.append(scaleBar(camera, theme, width));
  return richSvg(group);
}

function scaleKey(result, scale, theme, width) {
  const { label: title, unit } = result.quantity(scale.name);
  return colourBar({
    title,
    unit,
    scale,
    palette: mapOf(theme, scale),
    theme,
    length: Math.max(150, Math.min(420, width - 150)),
    mean: scale.mean,
  });
}

function materialKey(result, theme, room) {
  const counts = result.materials.map(() => 0);
  for (const m of result.state.material) ++counts[m];
  const entries = result.materials.map((material, m) => ({
    m,
    name: `${text.material(material)} (${text.count(counts[m])})`,
  }));
  return flow(entries, room, ({ m }, x, y) => square(x, y, materialColour(theme, m), theme));
}

/** What holds, and the ways in which bonds broke. */
function bondKey({ state }, theme, y) {
  const group = s("g", { transform: `translate(0 ${y})` });
  group.append(s("line", { x1: 3, x2: 23, stroke: theme.weak, "stroke-width": 3 }), label(32, 0, "bond"));
  let x = 70;
  for (const { name, colour } of crackKey(state, theme)) {
    group.append(s("circle", { cx: x, cy: 0, r: 5, fill: colour }), label(x + 10, 0, `broken in ${name}`));
    x += 84 + 6.2 * name.length;
  }
  return group;
}

function forceKey(result, theme, width, camera, y) {
  const { force_scale: scale, forces: acting } = result.state,
    { mean, tension } = scale,
    group = s("g", { transform: `translate(0 ${y})` }),
    forces = [0.5 * mean, 3 * mean, ...(acting.fn.some((force) => force < tension) ? [-mean] : [])];
  let x = 3;
  for (const force of forces) {
    const name = kindOfForce(force, scale),
      thick = Math.min(9, Math.max(1, 2 * thicknessOf(result, force) * camera.scale));
    group.append(
      s("line", { x1: x, x2: x + 20, stroke: theme[name], "stroke-width": thick, "stroke-linecap": "round" }),
      label(x + 29, 0, name),
    );
    x += 46 + 6.4 * name.length;
  }
  const strong = `F_{n} > \u27e8F_{n}\u27e9 = ${text.quantity(mean, "N")}`;
  group.append(label(x + 2, 0, width < narrow ? strong : `thickness \u221d F_{n};  strong: ${strong}`));
  return group;
}
