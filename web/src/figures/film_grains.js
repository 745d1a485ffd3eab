import { stressColour } from "../film/overlay.js";
import { stressKey } from "../film/legend.js";
import { richSvg, s } from "../dom.js";
import { capital } from "../text.js";

/** The sources of stresses that a film has, and what the program calls them: [[source, "Film"]]. */
export const known = (film) => Object.entries(film.stresses).map(([source, { name }]) => [source, capital(name)]);

/** Rectangle around all grains, in pixels of the film. */
function extent({ grains: { x, y, radius } }) {
  const ends = (v, sign) => v.reduce((most, c, g) => Math.max(most, sign * c + radius[g]), -Infinity);
  return { left: -ends(x, -1), right: ends(x, 1), top: -ends(y, -1), bottom: ends(y, 1) };
}

export const stressMaps = {
  when: (_, film) => film.hasSimulation && film.count > 0,
  draw({ sample, theme, width }) {
    const shown = known(sample),
      columns = width < 200 * shown.length ? 1 : shown.length,
      gap = 16;
    const box = extent(sample),
      part = (width - gap * (columns - 1)) / columns,
      scale = (part - 2) / (box.right - box.left);
    const tall = 24 + (box.bottom - box.top) * scale + 2,
      rows = Math.ceil(shown.length / columns),
      height = rows * (tall + 10) + 52;
    const svg = s("svg", {
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      "font-family": theme.font,
      "font-size": 11.5,
      fill: theme.soft,
    });
    shown.forEach(([name, title], k) => {
      const group = s(
        "g",
        { transform: `translate(${(k % columns) * (part + gap)} ${Math.floor(k / columns) * (tall + 10)})` },
        s("text", { x: 0, y: 12, fill: theme.ink, "font-weight": 600 }, title),
      );
      const disks = s("g", { stroke: theme.ink, "stroke-opacity": 0.35, "stroke-width": 0.6 }),
        { x, y, radius } = sample.grains;
      for (let g = 0; g < sample.count; ++g)
        disks.append(
          s("circle", {
            cx: (1 + (x[g] - box.left) * scale).toFixed(2),
            cy: (25 + (y[g] - box.top) * scale).toFixed(2),
            r: (radius[g] * scale).toFixed(2),
            fill: stressColour(theme, sample.stresses[name].sigma_norm[g]),
          }),
        );
      group.append(disks);
      svg.append(group);
    });
    svg.append(
      s("g", { transform: `translate(1 ${height - 51})` }, stressKey(theme, Math.min(260, width - 2))),
    );
    return richSvg(svg);
  },
};
