import { s } from "../dom.js";
import { drawn } from "../drawn.js";
import { fileName, saveSvg } from "../save.js";
import { bytes } from "../theme.js";
import { legend, legendHeight } from "./legend.js";
import { paint } from "./paint.js";
import { isField } from "./scale_controls.js";

/** Saves what a FieldView shows: as SVG with the nodes as an embedded picture, or painted at twice the screen's size.
 */
export class Picture {
  constructor(view, title) {
    Object.assign(this, { view, title });
  }

  /** With the name of what is painted as other files have it, "sigma_yy". */
  get name() {
    const { result, state } = this.view,
      show = state.get("show");
    return fileName(this.title, result.name, isField(show) ? result.quantity(state.get("component")).name : show);
  }

  saveSvg() {
    const { result, state, theme, camera, broken } = this.view;
    const { width, height } = camera;
    const whole = { width, height: height + legendHeight + 4 };
    const svg = s("svg", {
      xmlns: "http://www.w3.org/2000/svg",
      ...whole,
      viewBox: `0 0 ${whole.width} ${whole.height}`,
    });
    const seen = s("g", { "clip-path": "url(#seen)" }, nodes(this.view), bars(this.view), dots(this.view));
    svg.append(
      s("defs", {}, s("clipPath", { id: "seen" }, s("rect", { width, height }))),
      seen,
      s("g", { transform: `translate(0 ${height + 4})` }, legend(result, camera, theme, state, width, broken)),
    );
    saveSvg(this.name, svg, theme);
  }

  savePng() {
    const { view } = this,
      { camera, theme } = view;
    return view.savePainted(
      this.name,
      camera.height + legendHeight + 4,
      s(
        "g",
        { transform: `translate(0 ${camera.height + 4})` },
        legend(view.result, camera, theme, view.state, camera.width, view.broken),
      ),
    );
  }
}

/** The nodes in sight, a pixel each; a chosen grain stands out as on the screen. */
function nodes(view) {
  const { result, state, theme, camera, look } = view;
  if (look.deformed) return s("image", { href: painted(view), x: 0, y: 0, width: camera.width, height: camera.height });
  const { map } = result,
    d = map.spacing;
  const [left, top] = camera.toWorld(0, 0),
    [right, bottom] = camera.toWorld(camera.width, camera.height);
  const x0 = Math.max(0, Math.floor(left / d)),
    x1 = Math.min(map.width, Math.ceil(right / d));
  const y0 = Math.max(0, Math.floor(bottom / d)),
    y1 = Math.min(map.height, Math.ceil(top / d));
  if (x1 <= x0 || y1 <= y0) return s("g");
  const rgba = paint(result, state, theme),
    card = bytes(theme.card);
  const image = new ImageData(x1 - x0, y1 - y0);
  for (let y = y0; y < y1; ++y)
    for (let x = x0; x < x1; ++x) {
      const node = x + map.width * y,
        to = 4 * (x - x0 + (x1 - x0) * (y1 - 1 - y));
      const veil = 1 - (1 - look.fade) * (look.chosen && map.label[node] !== look.chosen ? 0.28 : 1);
      for (let c = 0; c < 3; ++c) image.data[to + c] = rgba[4 * node + c] + veil * (card[c] - rgba[4 * node + c]);
      image.data[to + 3] = 255;
    }
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: image.width, height: image.height });
  canvas.getContext("2d").putImageData(image, 0, 0);
  const [px, py] = camera.toScreen(x0 * d, y1 * d);
  return s("image", {
    href: canvas.toDataURL("image/png"),
    x: px,
    y: py,
    width: (x1 - x0) * d * camera.scale,
    height: (y1 - y0) * d * camera.scale,
    preserveAspectRatio: "none",
    style: "image-rendering: pixelated",
  });
}

/** What is on the canvas; cracks are drawn on it. */
function painted(view) {
  view.paint();
  return view.canvas.toDataURL("image/png");
}

function bars(view) {
  const { camera } = view;
  return s(
    "g",
    { "stroke-linecap": "round" },
    view.bars().map(({ ends, width, colour, size }) => {
      const [x1, y1] = camera.toScreen(ends[0], ends[1]),
        [x2, y2] = camera.toScreen(ends[2], ends[3]);
      const [a, b, c, d] = [x1, y1, x2, y2].map((v) => v.toFixed(2));
      return s("line", {
        x1: a,
        y1: b,
        x2: c,
        y2: d,
        stroke: colour,
        "stroke-width": (width * camera.scale).toFixed(2),
        "stroke-opacity": size < 1 ? 0.67 : 1,
      });
    }),
  );
}

function dots({ result, camera, theme, broken, look }) {
  const group = s("g"),
    { cracks } = result;
  if (look.deformed) return group;
  const r = Math.max(1.5, 0.55 * result.map.about.dx * camera.scale).toFixed(2);
  for (let k = 0; k < broken; ++k) {
    const [cx, cy] = camera.toScreen(cracks.x[k], cracks.y[k]);
    group.append(
      s("circle", {
        cx: cx.toFixed(2),
        cy: cy.toFixed(2),
        r,
        fill: theme.crack[cracks.type[k]] ?? theme.crack[1],
        "data-type": drawn().cracks[cracks.type[k]],
      }),
    );
  }
  return group;
}
