/** What may be painted on the nodes of a loaded sample. A member gives: symbol, and either `stored` (a field of the
    document, which has its unit) or `from(parts)` of other members; `grain` from a grain's mean stress { xx, yy, xy }.
    A new one is one more row. */
export const components = {
  yy: { symbol: "\u03c3_{yy}", stored: "sigma_yy", grain: (g) => g.yy },
  xx: { symbol: "\u03c3_{xx}", stored: "sigma_xx", grain: (g) => g.xx },
  xy: { symbol: "\u03c3_{xy}", stored: "sigma_xy", grain: (g) => g.xy },
  hydrostatic: {
    symbol: "\u03c3_{hyd}",
    needs: ["xx", "yy"],
    from: (xx, yy) => (xx + yy) / 2,
    grain: (g) => (g.xx + g.yy) / 2,
  },
  principal: {
    symbol: "\u03c3_{1}",
    needs: ["xx", "yy", "xy"],
    from: (xx, yy, xy) => principal(xx, yy, xy).first,
    grain: (g) => principal(g.xx, g.yy, g.xy).first,
  },
  ux: { symbol: "u_{x}", stored: "ux" },
  uy: { symbol: "u_{y}", stored: "uy" },
  travel: { symbol: "|u|", needs: ["ux", "uy"], from: (ux, uy) => Math.hypot(ux, uy), sequential: true },
};

/** Principal stresses, first >= second, and the direction of the first one, rad. */
export function principal(xx, yy, xy) {
  const middle = (xx + yy) / 2,
    reach = Math.hypot((xx - yy) / 2, xy);
  return { first: middle + reach, second: middle - reach, angle: 0.5 * Math.atan2(2 * xy, xx - yy) };
}

export const available = (result) => Object.keys(components).filter((name) => result.has(name));
