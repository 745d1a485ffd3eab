import { h, rich, s } from "../dom.js";
import { fileName, savePng, saveSvg, svgText } from "../save.js";
import { saveButtons } from "../save_buttons.js";
import { themeOf } from "../theme.js";
import { Tooltip } from "../tooltip.js";
import { axes } from "./frame.js";
import { slider } from "./slider.js";

const highest = 480; // px, the largest slice
/** Normal of each slice, and the axes to the right and upwards, by the axis that is upright. */
const planesBy = {
  2: [
    { axis: 2, u: 0, v: 1 },
    { axis: 1, u: 0, v: 2 },
    { axis: 0, u: 1, v: 2 },
  ],
  1: [
    { axis: 2, u: 0, v: 1 },
    { axis: 0, u: 2, v: 1 },
    { axis: 1, u: 0, v: 2 },
  ],
};

/** The card with a slice across each axis: { card, slices }. What is sliced (`result`) gives `size` (cells along each
    axis), `sides` (lengths of these, in any unit) and `placed(axis, layer)` in words. How it looks (`look`) is up to
    whoever shows it: `painted` (keys of the state that colours follow from), `index(state)` (for each cell its row of
    the table), `table(state, theme)` (256 times RGBA), `numbers(cell, state, theme)` (for the pointer),
    `legend(state, theme, width)` with its `legendHeight`, `title(state)`, `name` (of the card), `file`, and if there
    are: `upright` (an axis, unless z), `isSmooth`, `isWide`, `controls`, `saves` (more forms), `showsLegend` and
    `caption(state)`. */
export function slicesCard(result, state, look) {
  const holder = h("div", { class: `slices${look.isSmooth ? " smooth" : ""}` }),
    tooltip = new Tooltip(holder),
    planes = planesBy[look.upright ?? 2],
    slices = planes.map((plane) => new Slice(result, state, look, plane, holder, tooltip));
  holder.prepend(...slices.map(({ element }) => element));
  const title = h("h3"),
    key = look.showsLegend && s("svg", { class: "slices-key", role: "img", "aria-label": "Colours" }),
    caption = h("p", { class: "caption" });
  const drawKey = () => {
    const width = Math.floor(holder.clientWidth);
    if (!key || width < 50) return;
    for (const [name, value] of Object.entries({ width, height: look.legendHeight })) key.setAttribute(name, value);
    key.replaceChildren(look.legend(state, themeOf(state.get("theme")), width));
  };
  const draw = () => {
    const theme = themeOf(state.get("theme")),
      table = new Uint32Array(look.table(state, theme).buffer);
    title.replaceChildren(...rich(look.title(state)).flat().filter(Boolean));
    caption.textContent = [look.caption?.(state), howToMove].filter(Boolean).join(" ");
    holder.style.setProperty("--columns", columnsOf(planes, result.sides));
    const height = Math.max(...planes.map(({ v }) => result.sides[v]));
    for (const slice of slices) {
      slice.shape(highest / height);
      slice.colour(table, theme);
    }
    drawKey();
  };
  state.watch(look.painted, draw);
  draw();
  if (key) new ResizeObserver(drawKey).observe(holder);
  const buttons = saveButtons("the slices", { ...saves(result, state, look, slices), ...look.saves });
  if (look.controls) buttons.prepend(look.controls);
  const card = h(
    "section",
    { class: `card${look.isWide ? " figure wide" : ""}`, "aria-label": look.name },
    h("div", { class: "title" }, title, buttons),
    holder,
    key,
    caption,
  );
  return { card, slices };
}

/** As wide as the slices; parts of 1 that are less than it in sum would not fill the card. */
const columnsOf = (planes, sides) =>
  planes.map(({ u }) => `minmax(0, ${(100 * sides[u]) / Math.max(...sides)}fr)`).join(" ");

const howToMove = "Dashed lines: where the other two slices cut this one; a click in a slice moves them there.";

/** A slice on a canvas of one pixel a cell, with its slider below. */
class Slice {
  constructor(result, state, look, plane, holder, tooltip) {
    Object.assign(this, { result, state, look, ...plane, holder, tooltip });
    const [width, height] = [result.size[plane.u], result.size[plane.v]],
      name = axes[plane.axis];
    this.canvas = h("canvas", { width, height, role: "img", "aria-label": `Slice across ${name}`, "data-slice": name });
    this.over = s("svg", { class: "over", viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none" });
    this.stage = h("div", { class: "slice-stage" }, this.canvas, this.over);
    const place = (layer) => `${name} = ${result.placed(plane.axis, layer)}`,
      ends = [0, result.size[plane.axis] - 1];
    const foot = slider(name, `Place of the slice across ${name}`, name, state, ends, place, "slice-slider");
    foot.append(h("span", { class: "directions" }, `${axes[plane.u]} \u2192, ${axes[plane.v]} \u2191`));
    this.element = h("div", { class: "slice" }, this.stage, foot);
    state.watch([name], () => this.draw());
    state.watch([axes[plane.u], axes[plane.v]], () => this.drawLines());
    this.canvas.addEventListener("pointermove", (event) => this.#tell(event));
    this.canvas.addEventListener("pointerleave", () => tooltip.hide());
    this.canvas.addEventListener("click", (event) => this.#lead(event));
  }

  /** As long and as high as what it cuts is in the state shown, at most at this scale. */
  shape(most) {
    const { sides } = this.result;
    this.stage.style.aspectRatio = `${sides[this.u]} / ${sides[this.v]}`;
    this.stage.style.maxWidth = `${Math.round(most * sides[this.u])}px`;
  }

  /** The cell under the pointer. */
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
      numbers = this.look.numbers(this.cellAt(event), this.state, this.theme);
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
      index = this.look.index(this.state),
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
function saves(result, state, look, slices) {
  const gap = 12,
    margin = 10;
  const picture = () => {
    const theme = themeOf(state.get("theme")),
      svg = s("svg", {}),
      { sides } = result,
      scale = Math.max(Math.max(...result.size), 240) / Math.max(...sides),
      below = margin + scale * Math.max(...slices.map(({ v }) => sides[v]));
    let x = margin;
    for (const { canvas, axis, u, v } of slices) {
      const [width, height] = [scale * sides[u], scale * sides[v]];
      svg.append(
        s("image", {
          href: canvas.toDataURL("image/png"),
          x,
          y: below - height,
          width,
          height,
          preserveAspectRatio: "none",
          style: look.isSmooth ? null : "image-rendering: pixelated",
        }),
        s("rect", { x, y: below - height, width, height, fill: "none", stroke: theme.rule }),
        s(
          "text",
          { x, y: below + 16, "font-family": theme.font, "font-size": 12, fill: theme.ink },
          `${axes[axis]} = ${result.placed(axis, state.get(axes[axis]))}`,
        ),
      );
      x += width + gap;
    }
    const [width, height] = [Math.max(x - gap + margin, 320), below + look.legendHeight + 34];
    svg.append(
      s("g", { transform: `translate(${margin} ${below + 30})` }, look.legend(state, theme, width - 2 * margin)),
    );
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    return { svg, theme, width, height };
  };
  const name = () => fileName(result.title, result.name, look.file);
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
