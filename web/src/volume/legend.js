import { colourBar } from "../colour_bar.js";
import { richSvg, s } from "../dom.js";
import { kindWords } from "../drawn.js";
import { flow, square } from "../field/legend.js";
import { mapOf } from "../field/paint.js";
import { scaleBar } from "../scale_bar.js";
import { text } from "../text.js";
import { scaleOf } from "./paint.js";

export const legendHeight = 66;

/** The strip below the picture: what the colours mean, and where a camera is given a bar of known length. */
export function legend(result, state, theme, width, camera = null) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft }),
    scale = scaleOf(result, state);
  group.append(scale ? scaleKey(result, scale, theme, width) : phaseKey(result, theme, width - 130));
  const write = (length) => (result.inVoxels ? `${text.number(length, 1)}\u202fvoxels` : text.quantity(length, "m", 1));
  if (camera) group.append(scaleBar(camera, theme, width, write));
  return richSvg(group);
}

function scaleKey(result, scale, theme, width) {
  const largest = Math.max(Math.abs(scale.low), Math.abs(scale.high));
  return colourBar({
    title: result.quantity(scale.name).symbol,
    unit: result.unitOf(scale.name),
    scale,
    palette: mapOf(theme, scale),
    theme,
    length: Math.max(150, Math.min(420, width - 150)),
    mean: scale.name === result.loaded || scale.mean > 0.02 * largest ? scale.mean : null,
  });
}

function phaseKey(result, theme, room) {
  const entries = [2, 1, 0]
    .filter((phase) => result.share(phase) > 0)
    .map((phase) => ({
      phase,
      name: `${kindWords(phase, true)} ${text.number(100 * result.share(phase), 3)}\u202f%`,
    }));
  return flow(entries, room, ({ phase }, x, y) => square(x, y, theme.kind[phase], theme));
}
