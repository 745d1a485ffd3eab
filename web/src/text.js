import { drawn } from "./drawn.js";

const minus = (text) => text.replace("-", "\u2212");

/** Numbers and names as they are written on the page. */
export const text = {
  /** With `digits` significant digits and a true minus sign. */
  number(value, digits = 3) {
    if (value === null || value === undefined || !Number.isFinite(value)) return "\u2013";
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size >= 1e5 || size < 1e-3) {
      const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
      return minus(`${mantissa}\u00b710${superscript(Number(exponent))}`);
    }
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    return minus(value.toFixed(decimals));
  },

  /** A quantity in SI with the prefix that suits it: 15000 N is "15.0 kN". */
  quantity(value, unit, digits = 3) {
    if (!Number.isFinite(value)) return "\u2013";
    const { factor, unit: prefixed } = prefixOf(Math.abs(value), unit);
    return `${text.number(value / factor, digits)}\u202f${prefixed}`;
  },

  /** { value, error } as text, both to the place that the error's two leading digits reach; an error of rounding is
      none. */
  withError(value, error) {
    if (!Number.isFinite(value)) return { value: "\u2013", error: "" };
    if (!(error > 1e-7 * Math.abs(value))) return { value: text.number(value, 4), error: "" };
    const decimals = Math.min(8, Math.max(0, decimalsOf(error)));
    return { value: minus(value.toFixed(decimals)), error: error.toFixed(decimals) };
  },

  count(value) {
    return value.toLocaleString("en-US").replaceAll(",", "\u202f");
  },

  millimetres(value, digits = 3) {
    return `${text.number(value * 1e3, digits)}\u202fmm`;
  },

  material(material) {
    return material?.name ?? "?";
  },
};

/** How many decimals show two digits of an error, as it is once rounded (statistics/written.hpp). */
function decimalsOf(error) {
  const decimals = 1 - Math.floor(Math.log10(error));
  return Math.round(error * 10 ** decimals) >= 100 ? decimals - 1 : decimals;
}

/** As a heading begins. */
export const capital = (words) => words[0].toUpperCase() + words.slice(1);

/** A whole number in raised figures. */
export function superscript(exponent) {
  return String(exponent).replace(
    /./g,
    (c) => "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"["-0123456789".indexOf(c)],
  );
}

/** A unit as it is printed: "kg/m^3" is kg/m³, "deg" the sign. */
export const typeset = (unit) =>
  unit
    .replace(/^deg$/, "\u00b0")
    .replace(/\^0\.5/g, "^{1/2}")
    .replace(/\^(-?\d+)/g, (_, power) => superscript(power))
    .replaceAll(" ", "\u2009");

/** The prefix under which a number of this size is written, by the program's table, and the unit with it. */
export function prefixOf(size, unit) {
  const { prefixed, prefixes, from } = drawn().units;
  if (!(size > 0) || !prefixed.includes(unit)) return { factor: 1, prefix: "", unit: typeset(unit) };
  const [factor, prefix] = prefixes.find(([f]) => size >= f * from) ?? prefixes.at(-1);
  return { factor, prefix, unit: prefix + typeset(unit) };
}

/** What a unit with its prefix is in the one without: 1e-3 of "mm". */
export function factorOf(unit) {
  const { prefixed, prefixes } = drawn().units;
  const [factor] = prefixes.find(([, prefix]) => prefixed.some((bare) => prefix + typeset(bare) === unit)) ?? [1];
  return factor;
}
