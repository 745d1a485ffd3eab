/** How the page finds the numbers of every sphere (quantities.js); a state has the others by their names. */
const own = {
  size: { find: (result, state) => state.radius.map((r) => 2 * r) },
};

export const findersOf = (quantities) =>
  Object.fromEntries(Object.keys(quantities).map((id) => [id, own[id] ?? { find: (_, state) => state[id] }]));
