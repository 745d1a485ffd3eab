import { colourBar } from "../colour_bar.js";
import { label, s } from "../dom.js";
import { makeScale } from "../field/scale.js";
import { packed } from "../theme.js";
import { text } from "../text.js";

const shades = 512,
  gap = 12,
  line = 15,
  key = 76;

/** What the film shows, what the forces make of it, and the difference, as the program says, in the pixels that have
    both: [[label, values, root mean square]]. */
function pictures(film) {
  const known = film.values("fit_residual");
  return film.about.fit.pictures.map(({ label: words, map, factor, rms }) => {
    const values = film.values(map).map((v, k) => (Number.isFinite(known[k]) ? factor * v : NaN));
    return [words.toLowerCase(), values, rms];
  });
}

function painted(film, values, scale, palette, none) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: film.width, height: film.height });
  const table = Uint32Array.from({ length: shades }, (_, k) => packed(palette((k + 0.5) / shades)));
  const out = new Uint32Array(values.length);
  values.forEach((v, k) => {
    out[k] = Number.isFinite(v)
      ? table[Math.min(shades - 1, Math.max(0, Math.floor(scale.of(v) * shades)))]
      : packed(none);
  });
  canvas.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(out.buffer), film.width, film.height), 0, 0);
  return canvas.toDataURL("image/png");
}

export const fitMaps = {
  when: (_, film) => film.hasForces && film.about.maps.fit_residual,
  draw({ sample: film, theme, width }) {
    const all = pictures(film),
      order = all[0][1].filter(Number.isFinite).sort();
    if (order.length === 0) return null;
    const scale = { ...makeScale(order, { around: "zero", symlog: false, mean: 0, ends: film.about.fit.ends }), order };
    const { left, right, top, bottom } = around(film),
      wide = (width - 2 * gap) / 3,
      narrow = wide < 150,
      head = narrow ? 20 + line : 20,
      zoom = wide / (right - left),
      high = zoom * (bottom - top);
    const svg = s("svg", {
      xmlns: "http://www.w3.org/2000/svg",
      width,
      height: head + high + key,
      viewBox: `0 0 ${width} ${head + high + key}`,
      "font-family": theme.font,
      "font-size": 11.5,
      fill: theme.soft,
    });
    all.forEach(([name, values, rms], k) => {
      const x = k * (wide + gap),
        spread = `r.m.s. ${text.quantity(rms, film.about.film.unit)}`;
      svg.append(
        label(x, 9, narrow ? name : `${name}, ${spread}`, null, { fill: theme.ink }),
        narrow ? label(x, 9 + line, spread) : "",
        s(
          "svg",
          {
            x,
            y: head,
            width: wide,
            height: high,
            viewBox: `${left} ${top} ${right - left} ${bottom - top}`,
            preserveAspectRatio: "none",
            style: "overflow: hidden",
          },
          s("image", {
            href: painted(film, values, scale, theme.diverging, theme.field.aside),
            x: -0.5,
            y: -0.5,
            width: film.width,
            height: film.height,
            preserveAspectRatio: "none",
            style: "image-rendering: pixelated",
          }),
        ),
      );
    });
    svg.append(
      s(
        "g",
        { transform: `translate(0 ${head + high + 10})` },
        colourBar({
          title: film.about.fit.title,
          unit: film.about.film.unit,
          scale,
          palette: theme.diverging,
          theme,
          length: Math.min(420, width - 120),
        }),
      ),
    );
    return svg;
  },
};

/** The part of the film where grains are. */
function around({ grains: { x, y, radius }, count }) {
  const ends = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity };
  for (let g = 0; g < count; ++g) {
    ((ends.left = Math.min(ends.left, x[g] - radius[g] - 1)),
      (ends.right = Math.max(ends.right, x[g] + radius[g] + 1)));
    ((ends.top = Math.min(ends.top, y[g] - radius[g] - 1)),
      (ends.bottom = Math.max(ends.bottom, y[g] + radius[g] + 1)));
  }
  return ends;
}
