/** Place of a value between the ends of a scale (scaleOf of colouring.js), 0 to 1. */
export function shareOf({ low, high, log }, value) {
  if (!(high > low)) return 0.5;
  const share = log ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.min(1, Math.max(0, share || 0));
}

/** The value in the middle of the bar. */
export const middleOf = ({ low, high, log }) => (log ? Math.sqrt(low * high) : (low + high) / 2);

/** The state's `scales` with some members of one mode changed; those that are undefined are as usual again. */
export function withScale(state, mode, changes) {
  const scales = { ...state.get("scales") },
    changed = { ...scales[mode], ...changes };
  for (const name of Object.keys(changed))
    if (changed[name] === undefined || changed[name] === false) delete changed[name];
  if (Object.keys(changed).length) scales[mode] = changed;
  else delete scales[mode];
  return { scales };
}
