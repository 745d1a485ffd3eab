/** What pages have of the program, as far as parts need it without one. */
export const units = {
  prefixed: ["N", "Pa", "m", "s", "Pa m^0.5", "K"],
  prefixes: [
    [1e9, "G"],
    [1e6, "M"],
    [1e3, "k"],
    [1, ""],
    [1e-3, "m"],
    [1e-6, "\u00b5"],
    [1e-9, "n"],
  ],
  from: 0.9995,
};
