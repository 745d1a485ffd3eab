/** The values of a coded field (src/report/number_block.hpp): codes are predicted from the neighbours to the left and
    below, and a table turns each code into its value. */
export function decodeField(width, residual, { law, centre, width: unit, levels }) {
  const n = residual.length,
    code = new Int32Array(n);
  let least = 0,
    most = 0;
  for (let k = 0, x = 0; k < n; ++k) {
    const guess = prediction(code, width, x, k);
    const z = residual[k];
    const c = guess + ((z >>> 1) ^ -(z & 1));
    code[k] = c;
    if (c < least) least = c;
    if (c > most) most = c;
    if (++x === width) x = 0;
  }
  const table = new Float32Array(most - least + 1);
  for (let c = least; c <= most; ++c)
    table[c - least] = centre + unit * (law === "sinh" ? Math.sinh(c / levels) : c / levels);
  const values = new Float32Array(n);
  for (let k = 0; k < n; ++k) values[k] = table[code[k] - least];
  return values;
}

function prediction(code, width, x, k) {
  if (k < width) return x === 0 ? 0 : code[k - 1];
  if (x === 0) return code[k - width];
  const left = code[k - 1],
    below = code[k - width];
  const plane = left + below - code[k - width - 1];
  const low = left < below ? left : below,
    high = left < below ? below : left;
  return plane < low ? low : plane > high ? high : plane;
}
