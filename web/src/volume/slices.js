import { h, rich, s } from "../dom.js";
import { fileName, savePng, saveSvg, svgText } from "../save.js";
import { saveButtons } from "../save_buttons.js";
import { axes } from "../space/frame.js";
import { slider } from "../space/slider.js";
import { themeOf } from "../theme.js";
import { Tooltip } from "../tooltip.js";
import { legend, legendHeight } from "./legend.js";
import { indexOf, painted, tableOf } from "./paint.js";
import { voxelNumbers } from "./tooltip.js";

const highest = 480; // px, the largest slice
/** Normal of each slice, and the axes to the right and upwards. */
const planes = [
  { axis: 2, u: 0, v: 1 },
  { axis: 1, u: 0, v: 2 },
  { axis: 0, u: 1, v: 2 },
];

/** The card with a slice across each axis: { card, slices }. */
export function slicesCard(result, state) {
  const holder = h("div", { class: "slices" }),
    tooltip = new Tooltip(holder),
    slices = planes.map((plane) => new Slice(result, state, plane, holder, tooltip));
  holder.prepend(...slices.map(({ element }) => element));
  holder.style.setProperty("--columns", planes.map(({ u }) => `minmax(0, ${result.size[u]}fr)`).join(" "));
  const title = h("h3");
  const draw = () => {
    const theme = themeOf(state.get("theme")),
      table = new Uint32Array(tableOf(result, state, theme).buffer);
    title.replaceChildren(
      ...rich(`Slices: ${titleOf(result, state)}`)
        .flat()
        .filter(Boolean),
    );
    for (const slice of slices) slice.colour(table, theme);
  };
  state.watch(painted, draw);
  draw();
  const card = h(
    "section",
    { class: "card", "aria-label": "Slices" },
    h("div", { class: "title" }, title, saveButtons("the slices", saves(result, state, slices))),
    holder,
    h(
      "p",
      { class: "caption" },
      "Dashed lines: where the other two slices cut this one; a click in a slice moves them there.",
    ),
  );
  return { card, slices };
}

const titleOf = (result, state) =>
  state.get("show") === "field" ? result.quantity(state.get("component")).symbol : "phases";

/** A slice of voxels on a canvas of one pixel a voxel, with its slider below. */
class Slice {
  constructor(result, state, plane, holder, tooltip) {
    Object.assign(this, { result, state, ...plane, holder, tooltip });
    const [width, height] = [result.size[plane.u], result.size[plane.v]],
      name = axes[plane.axis];
    this.canvas = h("canvas", { width, height, role: "img", "aria-label": `Slice across ${name}`, "data-slice": name });
    this.over = s("svg", { class: "over", viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none" });
    const stage = h("div", { class: "slice-stage" }, this.canvas, this.over);
    stage.style.aspectRatio = `${width} / ${height}`;
    stage.style.maxWidth = `${Math.round((highest * width) / Math.max(result.size[1], result.size[2]))}px`;
    const place = (layer) => `${name} = ${result.length(result.place(layer))}`,
      ends = [0, result.size[plane.axis] - 1];
    const foot = slider(name, `Place of the slice across ${name}`, name, state, ends, place, "slice-slider");
    foot.append(h("span", { class: "directions" }, `${axes[plane.u]} \u2192, ${axes[plane.v]} \u2191`));
    this.element = h("div", { class: "slice" }, stage, foot);
    state.watch([name], () => this.draw());
    state.watch([axes[plane.u], axes[plane.v]], () => this.drawLines());
    this.canvas.addEventListener("pointermove", (event) => this.#tell(event));
    this.canvas.addEventListener("pointerleave", () => tooltip.hide());
    this.canvas.addEventListener("click", (event) => this.#lead(event));
  }

  /** The voxel under the pointer. */
  cellAt({ clientX, clientY }) {
    const { left, top, width, height } = this.canvas.getBoundingClientRect(),
      { size } = this.result;
    const within = (share, n) => Math.min(n - 1, Math.max(0, Math.floor(share * n)));
    const cell = [];
    cell[this.axis] = this.state.get(axes[this.axis]);
    cell[this.u] = within((clientX - left) / width, size[this.u]);
    cell[this.v] = within(1 - (clientY - top) / height, size[this.v]);
    return cell;
  }

  #tell(event) {
    const { left, top } = this.holder.getBoundingClientRect(),
      numbers = voxelNumbers(this.result, this.cellAt(event), this.theme, this.state.get("component"));
    this.tooltip.write(numbers, [event.clientX - left, event.clientY - top]);
  }

  #lead(event) {
    const cell = this.cellAt(event);
    this.state.set({ [axes[this.u]]: cell[this.u], [axes[this.v]]: cell[this.v] });
    this.#tell(event);
  }

  colour(table, theme) {
    Object.assign(this, { table, theme });
    this.draw();
    this.drawLines();
  }

  draw() {
    const { result, axis, u, v, table } = this,
      [width, height] = [result.size[u], result.size[v]],
      index = indexOf(result, this.state),
      image = new ImageData(width, height),
      pixels = new Uint32Array(image.data.buffer);
    const steps = [1, result.size[0], result.size[0] * result.size[1]],
      first = steps[axis] * this.state.get(axes[axis]);
    for (let row = 0; row < height; ++row)
      for (let column = 0; column < width; ++column)
        pixels[column + width * (height - 1 - row)] = table[index[first + steps[u] * column + steps[v] * row]];
    this.canvas.getContext("2d").putImageData(image, 0, 0);
  }

  drawLines() {
    this.over.replaceChildren(...this.lines());
  }

  lines() {
    const { size } = this.result,
      [width, height] = [size[this.u], size[this.v]],
      x = this.state.get(axes[this.u]) + 0.5,
      y = height - this.state.get(axes[this.v]) - 0.5;
    const line = (ends, stroke, dash) =>
      s("line", {
        ...ends,
        stroke,
        "stroke-width": 1,
        "stroke-dasharray": dash,
        "vector-effect": "non-scaling-stroke",
      });
    return [
      { x1: x, x2: x, y1: 0, y2: height },
      { x1: 0, x2: width, y1: y, y2: y },
    ].flatMap((ends) => [line(ends, this.theme.card, null), line(ends, this.theme.ink, "5 4")]);
  }
}

/** The three slices side by side at one scale over their legend, as SVG or painted. */
function saves(result, state, slices) {
  const gap = 12,
    margin = 10,
    scale = Math.max(1, 240 / Math.max(...result.size));
  const picture = () => {
    const theme = themeOf(state.get("theme")),
      svg = s("svg", {}),
      below = margin + Math.max(...slices.map(({ canvas }) => scale * canvas.height));
    let x = margin;
    for (const { canvas, axis } of slices) {
      const [width, height] = [scale * canvas.width, scale * canvas.height];
      svg.append(
        s("image", {
          href: canvas.toDataURL("image/png"),
          x,
          y: below - height,
          width,
          height,
          preserveAspectRatio: "none",
          style: "image-rendering: pixelated",
        }),
        s("rect", { x, y: below - height, width, height, fill: "none", stroke: theme.rule }),
        s(
          "text",
          { x, y: below + 16, "font-family": theme.font, "font-size": 12, fill: theme.ink },
          `${axes[axis]} = ${result.length(result.place(state.get(axes[axis])))}`,
        ),
      );
      x += width + gap;
    }
    const [width, height] = [Math.max(x - gap + margin, 320), below + legendHeight + 34];
    svg.append(
      s("g", { transform: `translate(${margin} ${below + 30})` }, legend(result, state, theme, width - 2 * margin)),
    );
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    return { svg, theme, width, height };
  };
  const name = () => fileName(result.title, result.name, "slices");
  return {
    svg: () => {
      const { svg, theme } = picture();
      saveSvg(name(), svg, theme);
    },
    png: () => {
      const { svg, theme, width, height } = picture();
      return savePng(name(), svgText(svg, theme), width, height, 3);
    },
  };
}
