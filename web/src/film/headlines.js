import { h } from "../dom.js";
import { prefixOf, text } from "../text.js";
import { tile } from "../tile.js";

/** The numbers that one asks for first. */
export function filmHeadlines(film) {
  const { film: about, agreement } = film.about, { contacts } = film;
  const tiles = about.frequency > 0 ? [["load frequency", "f", quantity(about.frequency, about.frequency_error, "Hz")]] : [];
  const noise = film.numbers?.lockin?.standard_error_K;
  if (noise) tiles.push(["noise of a pixel", "", quantity(noise, 0, about.unit)]);
  if (film.count) tiles.push(["grains", "N_{p}", [text.count(film.count)]]);
  if (film.stresses.film?.mean) tiles.push(["stress", "\u27e8\u03c3_{hyd}\u27e9", quantity(film.stresses.film.mean, 0, "Pa")]);
  if (film.hasForces) tiles.push(["force", "\u27e8F_{n}\u27e9", quantity(film.meanForce, 0, "N")]);
  const r = agreement.simulation_peak_to_peak?.all?.correlation, sure = film.hasForces ? Array.from(contacts.fn.keys()).filter((c) => !film.isUncertain(c)).length : 0;
  if (r) tiles.push(["correlation with simulation", "r", quantity(r.value, r.error, "")]);
  if (film.hasForces) tiles.push(["certain contacts", "", [text.count(sure), `of ${text.count(contacts.fn.length)}`]]);
  tiles.push(["frames", "", [text.count(about.used || about.frames)]], ["pixels", "", [`${about.width}\u202f\u00d7\u202f${about.height}`]]);
  return h("div", { class: "headlines" }, tiles.slice(0, tiles.length >= 6 ? 6 : 3).map(([name, symbol, [value, unit, error]]) =>
    tile(name, symbol, value, (error || unit) && h("small", {}, error && ` \u00b1 ${error}`, unit && `\u202f${unit}`))));
}

/** [value, unit, error] as text. */
function quantity(value, error, unit) {
  const { factor, prefix } = prefixOf(Math.abs(value), unit);
  const { value: v, error: e } = error > 0 ? text.withError(value / factor, error / factor) : { value: text.number(value / factor, 3), error: "" };
  return [v, prefix + unit, e];
}
