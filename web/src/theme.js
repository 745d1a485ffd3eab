import { interpolateMagma, interpolateViridis } from "d3-scale-chromatic";

const families = 'Inter, ui-sans-serif, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", ' +
  '"Liberation Sans", Arial, sans-serif';

// Blue and amber stay apart for every kind of colour blindness; the rest follow Okabe and Ito.
const light = {
  name: "light", font: families,
  page: "#f6f5f2", card: "#ffffff", ink: "#1b2026", soft: "#5d6670", rule: "#e4e5e3", wall: "#8b9199",
  material: ["#5b8fc9", "#f0b44c", "#6bb592", "#c98bb5"],
  materialLine: ["#2468ad", "#c77f00", "#1f8a62", "#a3457f"],
  mixedLine: ["#3c8d7a", "#8a6bb0", "#6f7f2f", "#a8563d"],
  strong: "#14191f", weak: "#7c868f", tension: "#d81b60", fit: "#1b2026", accent: "#a4522a",
  stress: (t) => interpolateMagma(0.99 - 0.87 * t),
  size: (t) => interpolateViridis(0.92 - 0.74 * t),
};

const dark = {
  name: "dark", font: families,
  page: "#0e1114", card: "#161a1f", ink: "#e9eaea", soft: "#98a1ab", rule: "#2a3037", wall: "#6d7781",
  material: ["#4f86c6", "#e0a23c", "#4fa580", "#b87aa5"],
  materialLine: ["#6ea8e6", "#efb24a", "#5cc096", "#d692c0"],
  mixedLine: ["#62bfa8", "#b196dc", "#a8b65c", "#dc8d74"],
  strong: "#f6f2e9", weak: "#87919b", tension: "#ff5c98", fit: "#e9eaea", accent: "#e08a5c",
  stress: (t) => interpolateMagma(0.14 + 0.85 * t),
  size: (t) => interpolateViridis(0.2 + 0.74 * t),
};

const preference = () => window.matchMedia("(prefers-color-scheme: dark)");

export const themeOf = (name) => (name === "dark" ? dark : light);

/** The reader's system decides until the button is pressed. */
export function followTheme(state) {
  const apply = () => { document.documentElement.dataset.theme = state.get("theme"); };
  preference().addEventListener("change", () => state.set({ theme: preferredTheme() }));
  state.watch(["theme"], apply);
  apply();
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
