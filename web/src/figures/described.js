import { text } from "../text.js";
import { drawCells } from "./cells.js";
import { sideBySide } from "./chart.js";
import { colourOf, dashOf } from "./colours.js";
import { drawHemispheres } from "./hemispheres.js";
import { drawOutlines } from "./outlines.js";
import { drawPanel } from "./panel.js";
import { drawRoses } from "./roses.js";

/** Of the drawings of a figure that which agrees with most of the reader's choices. */
function pick(drawings, state) {
  const holds = ([key, value]) => state.get(key) === value;
  const agreed = ({ for: chosen = {} }) => Object.entries(chosen).filter(holds).length;
  return drawings.reduce((best, one) => (agreed(one) > agreed(best) ? one : best));
}

/** What is shown of a figure, and at which place of it the reader is; null where there is nothing. */
function shown({ id, nearest }, { sample, state }) {
  const { drawings, here, first } = sample.drawn(id, state, nearest) ?? {};
  return drawings ? { drawing: pick(drawings, state), here, first } : null;
}

export function keyOf({ key = [], panels }, here, theme) {
  return key.map(({ name = "", colour, line, mark, numbers = [], counts }) => {
    const series = counts === undefined ? null : panels[0].series[counts].y;
    return {
      name: series ? `${name} ${text.count(series[Math.min(here, series.length - 1)])}` : name,
      colour: colourOf(theme, colour),
      dash: dashOf(line),
      symbol: mark,
      numbers,
    };
  });
}

/** A drawing as an SVG; half of a sphere that is `turned` as the picture beside it is. */
export function draw({ panels, roses, hemispheres, outlines, cells, for: chosen = {} }, about) {
  if (roses) return drawRoses(roses, about);
  if (hemispheres) {
    const look = chosen.half === "turned" ? about.state.get("turned").split(" ").map(Number) : null;
    return drawHemispheres(hemispheres, { ...about, look });
  }
  if (outlines) return drawOutlines(outlines, about);
  if (cells) return drawCells(cells, about);
  const drawn = panels.map((panel) => (width) => drawPanel(panel, { ...about, width }));
  return drawn.length === 1 ? drawn[0](about.width) : sideBySide(about.width, drawn);
}

/** What else a drawing follows that a choice may give. */
const besides = { half: ["turned"] };

/** A figure that the program describes, as a card shows it. */
export function describedFigure(head) {
  const { id, title, caption, wide, choices = [] } = head;
  const buttons = choices.filter(({ silent }) => !silent).map(({ key, label, options }) => [key, [label, options]]);
  return {
    id,
    title,
    caption,
    wide,
    choices: Object.fromEntries(buttons),
    follows: ["snapshot", "step", "selected", ...choices.flatMap(({ key }) => [key, ...(besides[key] ?? [])])],
    when: (_, sample) => sample.hasDrawn(id),
    key: (about) => {
      const found = shown(head, about);
      return found ? keyOf(found.drawing, found.here, about.theme) : [];
    },
    draw(about) {
      const found = shown(head, about);
      return found && draw(found.drawing, { ...about, here: found.here, first: found.first });
    },
  };
}
