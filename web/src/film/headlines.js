import { headlines, tilesOf } from "../numbers.js";
import { text } from "../text.js";

const plainTile = (words, value, unit = "") => ({ words, symbol: "", value, error: "", unit });

/** The numbers that one asks for first. */
export function filmHeadlines(film) {
  const { film: about } = film.about,
    { contacts } = film,
    sure = film.hasForces ? Array.from(contacts.fn.keys()).filter((c) => !film.isUncertain(c)).length : 0;
  const tiles = tilesOf(film.declared, [
    ["load frequency", "f", "lockin.frequency_Hz"],
    ["noise of a pixel", "", "lockin.standard_error_K"],
    ["grains", "N_{p}", "grains.all"],
    ["stress", "\u27e8\u03c3_{hyd}\u27e9", "stresses.film.mean_Pa"],
    ["force", "\u27e8F_{n}\u27e9", "forces.mean_N"],
    ["correlation with simulation", "r", "agreement.simulation_peak_to_peak.all.correlation"],
  ]).filter(({ known }) => known);
  if (film.hasForces)
    tiles.push(plainTile("certain contacts", text.count(sure), `of ${text.count(contacts.fn.length)}`));
  tiles.push(
    plainTile("frames", text.count(about.used || about.frames)),
    plainTile("pixels", `${about.width}\u202f\u00d7\u202f${about.height}`),
  );
  return headlines(tiles.slice(0, tiles.length >= 6 ? 6 : 3));
}
