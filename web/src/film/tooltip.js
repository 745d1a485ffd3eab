import { drawn } from "../drawn.js";
import { materialColour } from "../theme.js";
import { capital, prefixOf, text } from "../text.js";

/** A value and its standard error in the unit that suits the larger one: "3.60 ± 0.17 kN". */
export function quantityWithError(value, error, unit) {
  if (!(error > 0)) return text.quantity(value, unit);
  const { factor, unit: prefixed } = prefixOf(Math.max(Math.abs(value), error), unit),
    { value: v, error: e } = text.withError(value / factor, error / factor);
  return `${v}${e && ` \u00b1 ${e}`}\u202f${prefixed}`;
}

/** The numbers of the pixel under the pointer, and of the grain that it lies in. */
export function pixelNumbers(film, pixel, grain, theme) {
  const column = pixel % film.width,
    row = Math.floor(pixel / film.width);
  const rows = Object.entries(film.about.maps)
    .filter(([, { on }]) => !on)
    .map(([name, { label, cyclic }]) => {
      const value = film.values(name)[pixel],
        unit = film.unitOf(name);
      if (name === "picture")
        return [
          label.toLowerCase(),
          Number.isFinite(value) ? `${value.toFixed(unit === "K" ? 3 : 0)}\u202f${unit}` : "\u2013",
        ];
      return [label.toLowerCase(), cyclic ? `${text.number(value, 3)}\u00b0` : text.quantity(value, unit)];
    });
  if (film.bad.includes(pixel)) rows.push(["replaced", "bad pixel"]);
  const place = `column ${column}, row ${row}`;
  if (grain === null) return { title: capital(place), colour: theme.weak, rows };
  return {
    title: `Grain ${film.grains.id[grain]}${nameOf(film, grain)}`,
    colour: materialColour(theme, film.grains.material[grain]),
    rows: [...grainRows(film, grain), ["pixel", `${column}, ${row}`], ...rows],
  };
}

const nameOf = (film, grain) =>
  film.materials[film.grains.material[grain]] ? `, ${film.materials[film.grains.material[grain]].name}` : "";

function grainRows(film, g) {
  const { radius, sigma_hyd: sigma, error, motion_x: mx, motion_y: my } = film.grains,
    { pixel } = film.about.film;
  const rows = [
    ["radius", `${text.number(radius[g], 3)}\u202fpx${pixel > 0 ? `, ${text.millimetres(radius[g] * pixel)}` : ""}`],
  ];
  if (sigma) rows.push(["\u03c3_{hyd}", quantityWithError(sigma[g], error?.[g], sigma.unit)]);
  if (film.stresses.film) rows.push(["\u03c3_{norm}", text.number(film.stresses.film.sigma_norm[g])]);
  const simulated = film.stresses.simulation_peak_to_peak?.sigma_hyd;
  if (simulated) rows.push(["simulated \u03c3_{hyd}", text.quantity(simulated[g], simulated.unit)]);
  if (mx) rows.push(["motion x, y", `${text.number(mx[g], 2)}, ${text.number(-my[g], 2)}\u202fpx`]);
  return rows;
}

/** "Contact 12 – 40", "Contact 3 – bottom wall". */
export function contactName({ contacts: { i, j }, grains: { id }, count }, c) {
  const other = j[c] < count ? id[j[c]] : `${drawn().sides[j[c] - count]} wall`;
  return `Contact ${id[i[c]]}\u2009\u2013\u2009${other}`;
}

export function contactNumbers(film, c, theme) {
  const { fn, ft, fn_error: fe, ft_error: te, over_error: over, presence } = film.contacts;
  const rows = [
    ["F_{n}", quantityWithError(fn[c], fe?.[c], fn.unit)],
    ["F_{t}", quantityWithError(ft[c], te?.[c], ft.unit)],
  ];
  if (over) rows.push(["F_{n}/s.e.", text.number(over[c], 3)]);
  if (film.isUncertain(c)) rows.push(["may be absent", `${text.number(100 * (1 - presence[c]), 2)}\u202f%`]);
  return { title: contactName(film, c), colour: fn[c] < 0 ? theme.tension : theme.strong, rows };
}
