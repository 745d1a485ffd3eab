import { interpolateCividis, interpolateMagma, interpolateViridis } from "d3-scale-chromatic";
import { drawn } from "./drawn.js";

const families =
  'Inter, ui-sans-serif, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", ' +
  '"Liberation Sans", Arial, sans-serif';

/** Colours between equally spaced stops: a function from 0..1 to "rgb(...)". */
function between(stops) {
  const parts = stops.map((stop) => bytes(stop));
  return (t) => {
    const at = Math.min(1, Math.max(0, t)) * (parts.length - 1),
      k = Math.min(parts.length - 2, Math.floor(at));
    return `rgb(${parts[k].map((v, c) => Math.round(v + (at - k) * (parts[k + 1][c] - v))).join(", ")})`;
  };
}

// Blue and amber stay apart for every kind of colour blindness; the rest follow Okabe and Ito.
const light = {
  name: "light",
  font: families,
  page: "#f6f5f2",
  card: "#ffffff",
  ink: "#1b2026",
  soft: "#5d6670",
  rule: "#e4e5e3",
  wall: "#8b9199",
  material: ["#5b8fc9", "#f0b44c", "#6bb592", "#c98bb5"],
  materialLine: ["#2468ad", "#c77f00", "#1f8a62", "#a3457f"],
  mixedLine: ["#3c8d7a", "#8a6bb0", "#6f7f2f", "#a8563d"],
  strong: "#14191f",
  weak: "#7c868f",
  tension: "#d81b60",
  fit: "#1b2026",
  accent: "#a4522a",
  stress: (t) => interpolateMagma(0.99 - 0.87 * t),
  size: (t) => interpolateViridis(0.92 - 0.74 * t),
  diverging: between([
    "#11305e",
    "#22589b",
    "#5d94c9",
    "#a9cbe2",
    "#efeadc",
    "#f3c089",
    "#e0803f",
    "#b54a1a",
    "#6f210b",
  ]),
  grey: between(["#22272c", "#f7f6f2"]),
  get cyclic() {
    return between(drawn().cyclic);
  },
  badPixel: "#ff2d95",
  kind: ["#ffffff", "#f4d27a", "#6e9fd0", "#2c5d9e", "#a6cbe9"],
  kindLine: ["#cf5d49", "#c28a00", "#4179b5", "#1f4e8f", "#5aa3dc"],
  field: { empty: "#ffffff", aside: "#d4d5d2", outline: "#14191f" },
  crack: [null, "#7a1fa2", "#0b0d10", "#00796b"],
  broken: ["#d81b60", "#c77f00", "#1f8a62", "#6a4fb0"],
  cross: { pull: "#14191f", push: "#d81b60" },
};

const dark = {
  name: "dark",
  font: families,
  page: "#0e1114",
  card: "#161a1f",
  ink: "#e9eaea",
  soft: "#98a1ab",
  rule: "#2a3037",
  wall: "#6d7781",
  material: ["#4f86c6", "#e0a23c", "#4fa580", "#b87aa5"],
  materialLine: ["#6ea8e6", "#efb24a", "#5cc096", "#d692c0"],
  mixedLine: ["#62bfa8", "#b196dc", "#a8b65c", "#dc8d74"],
  strong: "#f6f2e9",
  weak: "#87919b",
  tension: "#ff5c98",
  fit: "#e9eaea",
  accent: "#e08a5c",
  stress: (t) => interpolateMagma(0.14 + 0.85 * t),
  size: (t) => interpolateViridis(0.2 + 0.74 * t),
  diverging: between([
    "#b9dcff",
    "#7db4ea",
    "#4580bd",
    "#2a4c70",
    "#25292e",
    "#6b4022",
    "#b4642a",
    "#ec9a4c",
    "#ffdba6",
  ]),
  grey: between(["#101316", "#dcdbd6"]),
  cyclic: between(["#4b87cf", "#8d75d1", "#c266a8", "#dc6558", "#e39a35", "#b1b340", "#58ad71", "#32a0ac", "#4b87cf"]),
  badPixel: "#ff4fa6",
  kind: ["#0a0c0e", "#d8b04a", "#5e92c6", "#2a5793", "#8fbbe0"],
  kindLine: ["#d9705c", "#e5b84a", "#6ea8e6", "#4f83d1", "#a5d3f5"],
  field: { empty: "#0a0c0e", aside: "#31373d", outline: "#0a0c0e" },
  crack: [null, "#e29bff", "#ffffff", "#63e0c8"],
  broken: ["#ff5c98", "#efb24a", "#5cc096", "#b196dc"],
  cross: { pull: "#ffffff", push: "#ff5c98" },
};

/** The map of colours, of those below, for a scale that the program names. */
export const mapOfScale = { even: "viridis", stress: "magma", diverging: "diverging", grey: "grey" };

/** The maps by which a reader may colour a quantity. */
export const colourMaps = [
  ["viridis", "Viridis"],
  ["magma", "Magma"],
  ["cividis", "Cividis"],
  ["diverging", "Blue\u2013amber"],
  ["grey", "Grey"],
];
for (const theme of [light, dark]) {
  theme.scales = {
    even: theme.size,
    stress: theme.stress,
    diverging: theme.diverging,
    grey: theme.grey,
    get cyclic() {
      return theme.cyclic;
    },
  };
  theme.maps = {
    viridis: theme.size,
    magma: theme.stress,
    cividis: (t) => interpolateCividis(theme === light ? 1 - t : t),
    diverging: theme.diverging,
    grey: theme === light ? (t) => theme.grey(1 - t) : theme.grey,
  };
}

const preference = () => window.matchMedia("(prefers-color-scheme: dark)");

export const themeOf = (name) => (name === "dark" ? dark : light);

/** The reader's system decides until the button is pressed. */
export function followTheme(state) {
  const apply = () => {
    document.documentElement.dataset.theme = state.get("theme");
  };
  preference().addEventListener("change", () => state.set({ theme: preferredTheme() }));
  state.watch(["theme"], apply);
  apply();
  let shown = null; // on paper the page is light
  window.addEventListener("beforeprint", () => {
    shown = state.get("theme");
    state.set({ theme: "light" });
  });
  window.addEventListener("afterprint", () => shown && state.set({ theme: shown }));
}

export const preferredTheme = () => (preference().matches ? "dark" : "light");

const at = (list, k) => list[k % list.length];

/** Line colour of contacts between materials a <= b; walls have their own. */
export function pairColour(theme, type) {
  if (type.wall) return theme.wall;
  return type.a === type.b ? at(theme.materialLine, type.a) : at(theme.mixedLine, type.mixed);
}

export const materialColour = (theme, m) => at(theme.material, m);
export const materialLine = (theme, m) => at(theme.materialLine, m);

/** [r, g, b] in 0..255 of "#rrggbb" or "rgb(r, g, b)". */
export function bytes(colour) {
  if (colour.startsWith("#")) return [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
  return colour.match(/\d+/g).slice(0, 3).map(Number);
}

/** A colour as one 32-bit number whose bytes are red, green, blue, 255. */
export function packed(colour) {
  const [r, g, b] = bytes(colour);
  return ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
}
