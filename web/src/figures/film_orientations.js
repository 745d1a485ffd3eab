import { richSvg, s } from "../dom.js";
import { reachOf, rose } from "./roses.js";

/** Polar histograms of contact orientations in the film and in the simulation beside it, on one scale. */
export const filmOrientations = {
  id: "film-orientations",
  title: "Contact orientations",
  caption:
    "Fraction of contacts between grains in sectors of 10\u00b0, over the isotropic fraction (dashed circle), away from the border. Film: contacts whose force changes with the load; " +
    "simulation: those at the largest load. Line: 1 + a_{c} cos 2(\u03b8 \u2212 \u03b8_{c}).",
  when: (_, film) => Boolean(film.declared.at("contact_orientations.film.sectors")),
  draw({ sample, theme, width }) {
    const { film, simulation } = sample.declared.at("contact_orientations");
    const list = [
      { label: "film", colour: theme.strong, set: film },
      { label: "simulation", colour: theme.accent, set: simulation },
    ].filter(({ set }) => set?.sectors);
    const cell = width / list.length,
      radius = Math.min(0.5 * cell - 18, 110),
      height = 2 * radius + 96;
    const reach = Math.max(...list.map(({ set }) => reachOf(set)));
    const svg = s("svg", {
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      "font-family": theme.font,
      "font-size": 11.5,
      fill: theme.soft,
    });
    list.forEach((entry, k) =>
      svg.append(
        s(
          "g",
          { transform: `translate(${(k + 0.5) * cell} ${radius + 36})`, "data-set": entry.label },
          rose({ ...entry, reach }, radius, theme),
        ),
      ),
    );
    return richSvg(svg);
  },
};
