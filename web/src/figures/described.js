import { text } from "../text.js";
import { sideBySide } from "./chart.js";
import { colourOf, dashOf } from "./colours.js";
import { drawPanel } from "./panel.js";
import { drawRoses } from "./roses.js";

/** Of the drawings of a figure that which agrees with most of the reader's choices. */
function pick(drawings, state) {
  const agreed = ({ for: chosen = {} }) => Object.entries(chosen).filter(([key, value]) => state.get(key) === value).length;
  return drawings.reduce((best, one) => (agreed(one) > agreed(best) ? one : best));
}

/** What is shown of a figure, and at which place of it the reader is; null where there is nothing. */
function shown(id, { sample, state }) {
  const { drawings, here } = sample.drawn(id, state) ?? {};
  return drawings ? { drawing: pick(drawings, state), here } : null;
}

function keyOf({ key = [], panels }, here, theme) {
  return key.map(({ name, colour, line, numbers = [], counts }) => {
    const series = counts === undefined ? null : panels[0].series[counts].y;
    return {
      name: series ? `${name} ${text.count(series[Math.min(here, series.length - 1)])}` : name,
      colour: colourOf(theme, colour),
      dash: dashOf(line),
      numbers,
    };
  });
}

/** A figure that the program describes, as a card shows it. */
export function describedFigure({ id, title, caption, wide, choices = [] }) {
  const buttons = choices.filter(({ silent }) => !silent).map(({ key, label, options }) => [key, [label, options]]);
  return {
    id,
    title,
    caption,
    wide,
    choices: Object.fromEntries(buttons),
    follows: ["snapshot", "step", "selected", ...choices.map(({ key }) => key)],
    when: (_, sample) => sample.hasDrawn(id),
    key: (about) => {
      const found = shown(id, about);
      return found ? keyOf(found.drawing, found.here, about.theme) : [];
    },
    draw(about) {
      const found = shown(id, about);
      if (!found) return null;
      const { drawing, here } = found;
      if (drawing.roses) return drawRoses(drawing.roses, about);
      const panels = drawing.panels.map((panel) => (width) => drawPanel(panel, { ...about, here, width }));
      return panels.length === 1 ? panels[0](about.width) : sideBySide(about.width, panels);
    },
  };
}
