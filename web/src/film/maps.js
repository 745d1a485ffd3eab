/** Names in the theme of the palettes that the maps of a film have; what else is to be said of a map the library says
    (`film.about.maps`). A map is drawn on the values of another where it names one in `on`. */
export const palettes = {
  picture: "grey",
  amplitude: "stress",
  phase: "cyclic",
  in_phase: "diverging",
  fitted: "diverging",
  fit_residual: "diverging",
  second_harmonic: "stress",
  standard_error: "size",
  residual: "size",
  bad: "grey",
};

/** The maps that a film has, in the library's order. */
export const available = (film) => Object.keys(film.about.maps);

/** Whether a pixel's amplitude is lost in noise, so that its phase says nothing. */
export function faintness(film) {
  if (!film.about.maps.amplitude || !film.about.maps.standard_error) return null;
  const amplitude = film.values("amplitude"),
    error = film.values("standard_error");
  return (k) => amplitude[k] < film.about.faint_below * error[k];
}
