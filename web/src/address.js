/** A number between two, a whole one if it is to be. */
function between(least, most, whole = false) {
  const fits = (value) => value >= least && value <= most && (!whole || Number.isInteger(value));
  return { write: String, read: (text) => (text !== "" && fits(Number(text)) ? Number(text) : undefined) };
}

/** How a key of the state is written behind the # of the page's address: `write(value)` -> text, `read(text)` -> value,
    undefined where the text says nothing that there is. */
export const forms = {
  word: (words) => ({ write: String, read: (text) => (words.includes(text) ? text : undefined) }),
  truth: { write: String, read: (text) => ({ true: true, false: false })[text] },
  whole: (below) => ({
    write: (v) => (v === null ? "" : String(v)),
    read: (text) => (text === "" ? null : /^\d+$/.test(text) && Number(text) < below ? Number(text) : undefined),
  }),
  between,
  share: between(0, 1),
  tree: {
    write: JSON.stringify,
    read: (text) => {
      try {
        return JSON.parse(text);
      } catch {
        return undefined;
      }
    },
  },
};

const parts = () => new URLSearchParams(window.location.hash.slice(1));

/** Keeps what the reader has chosen in the address, so that a reload or a link shows the same; what is as in the
    beginning is left out. `keys` = { name in the state: form }; `prefix` tells the states of one page apart. */
export function keepInAddress(state, keys, prefix = "") {
  const begin = Object.fromEntries(Object.entries(keys).map(([key, form]) => [key, form.write(state.get(key))]));
  const there = parts();
  for (const [key, form] of Object.entries(keys)) {
    const value = there.has(prefix + key) ? form.read(there.get(prefix + key)) : undefined;
    if (value !== undefined) state.set({ [key]: value });
  }
  state.watch(Object.keys(keys), () => {
    const now = parts();
    for (const [key, form] of Object.entries(keys)) {
      const text = form.write(state.get(key));
      if (text === begin[key]) now.delete(prefix + key);
      else now.set(prefix + key, text);
    }
    const hash = now.toString();
    if (hash !== window.location.hash.slice(1))
      window.history.replaceState(null, "", hash ? `#${hash}` : window.location.pathname + window.location.search);
  });
}
