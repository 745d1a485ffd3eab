/** The maps that a film has, in the library's order. */
export const available = (film) => Object.keys(film.about.maps);

/** Whether a pixel's amplitude is lost in noise, so that its phase says nothing. */
export function faintness(film) {
  if (!film.about.maps.amplitude || !film.about.maps.standard_error) return null;
  const amplitude = film.values("amplitude"),
    error = film.values("standard_error");
  return (k) => amplitude[k] < film.about.faint_below * error[k];
}
