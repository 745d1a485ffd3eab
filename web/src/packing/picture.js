import { s } from "../dom.js";
import { isPresent } from "../sample.js";
import { chainColour, chainWidth, segmentsOf, shownContacts } from "./chains.js";
import { fadeUnderChains, grainColour, scaleOf } from "./colouring.js";
import { legend, legendHeight } from "./legend.js";
import { overlay } from "./overlay.js";
import { rimOf } from "./shapes.js";

export const mostVectors = 20000;

/** The packing as an SVG of its own: disks, chains, walls and legend, as they are seen now. */
export function packingSvg(sample, snapshot, camera, theme, state) {
  const { width, height } = camera;
  const svg = s("svg", {
    xmlns: "http://www.w3.org/2000/svg",
    width,
    height: height + legendHeight + 8,
    viewBox: `0 0 ${width} ${height + legendHeight + 8}`,
  });
  svg.append(s("rect", { width: "100%", height: "100%", fill: theme.card }));
  const clip = s("clipPath", { id: "seen" }, s("rect", { width, height }));
  const seen = s("g", { "clip-path": "url(#seen)" }, grains(sample, snapshot, camera, theme, state));
  if (state.get("chains")) seen.append(chains(sample, snapshot, camera, theme, state));
  seen.append(overlay(sample, snapshot, camera, theme, { walls: true }));
  svg.append(
    s("defs", {}, clip),
    seen,
    s("g", { transform: `translate(0 ${height + 4})` }, legend(sample, snapshot, camera, theme, state, width)),
  );
  return svg;
}

function grains(sample, snapshot, camera, theme, state) {
  const colour = grainColour(sample, snapshot, state.get("colour"), scaleOf(sample, state), theme);
  const opacity = state.get("chains") ? 1 - fadeUnderChains(state.get("colour")) : 1;
  const group = s("g", { "fill-opacity": opacity, stroke: theme.ink, "stroke-opacity": 0.3, "stroke-width": 0.75 });
  if (sample.shapes) {
    const corners = (g) =>
      rimOf(sample, snapshot, g)
        .map(([x, y]) =>
          camera
            .toScreen(x, y)
            .map((v) => v.toFixed(2))
            .join(","),
        )
        .join(" ");
    for (let g = 0; g < sample.count; ++g) group.append(s("polygon", { points: corners(g), fill: colour(g) }));
    return group;
  }
  for (let g = 0; g < sample.count; ++g) {
    if (!isPresent(snapshot, g)) continue;
    const [cx, cy] = camera.toScreen(snapshot.x[g], snapshot.y[g]);
    group.append(
      s("circle", {
        cx: cx.toFixed(2),
        cy: cy.toFixed(2),
        r: (sample.radius[g] * camera.scale).toFixed(2),
        fill: colour(g),
      }),
    );
  }
  return group;
}

function chains(sample, snapshot, camera, theme, state) {
  const group = s("g", { "stroke-linecap": "round" });
  for (const c of shownContacts(state, sample, snapshot)) {
    const fn = snapshot.contacts.fn[c];
    for (const [ax, ay, bx, by] of segmentsOf(sample, snapshot, c)) {
      const [x1, y1] = camera.toScreen(ax, ay),
        [x2, y2] = camera.toScreen(bx, by);
      group.append(
        s("line", {
          x1: x1.toFixed(2),
          y1: y1.toFixed(2),
          x2: x2.toFixed(2),
          y2: y2.toFixed(2),
          stroke: chainColour(theme, snapshot, fn),
          "stroke-width": Math.max(0.4, chainWidth(sample, snapshot, fn) * camera.scale).toFixed(2),
        }),
      );
    }
  }
  return group;
}
