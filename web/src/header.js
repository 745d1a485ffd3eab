import { h } from "./dom.js";
import { text } from "./text.js";

/** Title, what the page is about in a line, and the button for the colours. */
export function header(title, sample, results, state) {
  const button = h("button", {
    class: "theme",
    onclick: () => state.set({ theme: state.get("theme") === "dark" ? "light" : "dark" }),
  });
  const refresh = () => {
    const dark = state.get("theme") === "dark";
    button.textContent = dark ? "\u2600\ufe0e" : "\u263e\ufe0e";
    button.setAttribute("aria-label", dark ? "Light colours" : "Dark colours");
    button.title = button.getAttribute("aria-label");
  };
  state.watch(["theme"], refresh);
  refresh();
  return h(
    "header",
    {},
    h("div", {}, h("h1", {}, title), h("p", {}, subtitleOf(sample, results).join("  \u00b7  "))),
    button,
  );
}

function subtitleOf(sample, { fields, films, volumes, spheres }) {
  if (spheres.length) return spheresSubtitle(spheres.at(-1));
  if (volumes.length) return volumeSubtitle(volumes.at(-1));
  if (films.length) return filmSubtitle(films.at(-1));
  return fields.length ? gridSubtitle(fields.at(-1).map) : subtitle(sample);
}

function filmSubtitle({
  count,
  about: {
    film: { camera, width, height, frames, frame_rate: rate, pixel },
  },
}) {
  return [
    camera,
    `${width} \u00d7 ${height} pixels`,
    frames > 0 && `${text.count(frames)} frames${rate > 0 ? ` at ${text.number(rate, 4)}\u202fHz` : ""}`,
    pixel > 0 && `${text.millimetres(pixel)} per pixel`,
    count > 0 && `${text.count(count)} grains`,
  ].filter(Boolean);
}

function subtitle(sample) {
  const snapshot = sample.snapshot(sample.snapshotCount - 1),
    box = sample.box(snapshot);
  const counts = sample.materials.map((material, m) => `${text.count(sample.materialCounts[m])} ${material.name}`);
  const [width, height] = [box.right - box.left, box.top - box.bottom].map((side) => text.number(1e3 * side, 4));
  const size = `${width} \u00d7 ${height}\u202fmm`;
  const force = Math.max(...snapshot.domain.walls.map((wall) => wall.force));
  return [...counts, size, ...(force > 0 ? [`largest wall force ${text.quantity(force, "N")}`] : [])];
}

function gridSubtitle({
  about: {
    full: [width, height],
    dx,
  },
  grainKind,
}) {
  const size = `${text.number(1e3 * width * dx, 4)} \u00d7 ${text.number(1e3 * height * dx, 4)}\u202fmm`;
  return [
    `${text.count(width)} \u00d7 ${text.count(height)} nodes`,
    size,
    ...(grainKind.length ? [`${text.count(grainKind.length)} grains`] : []),
  ];
}

function volumeSubtitle(result) {
  const { full, dx } = result.about,
    grains = result.declared.at("map.grains");
  return [
    `${full.map(text.count).join(" \u00d7 ")} voxels`,
    !result.inVoxels && `${full.map((n) => text.number(1e3 * n * dx, 3)).join(" \u00d7 ")}\u202fmm`,
    grains > 1 && `${text.count(grains)} grains`,
  ].filter(Boolean);
}

function spheresSubtitle({ count, size, materials }) {
  return [
    `${text.count(count)} spheres`,
    materials.map(text.material).join(", "),
    `${size.map((side) => text.number(1e3 * side, 3)).join(" \u00d7 ")}\u202fmm`,
  ];
}
