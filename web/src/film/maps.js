const convention = (film) => (film.about.film.convention === "peak_to_peak" ? "peak to peak" : "half of peak to peak");

/** What may be painted on the pixels of a film. A member gives: label; `stored` (a map of the document); `title(film)`;
    `unit` where it is not the stored map's; `palette` (a name in the theme); `around` (what the scale is centred on, of
    field/scale.js); `cyclic` where colours come back, and are pale where the amplitude is lost in noise. A new one is
    one more row. */
export const maps = {
  picture: {
    label: "Picture",
    stored: "picture",
    title: () => "Image at the smallest load",
    palette: "grey",
    around: "ends",
  },
  amplitude: {
    label: "Amplitude",
    stored: "amplitude",
    title: (film) => `Amplitude (${convention(film)})`,
    palette: "stress",
    around: "ends",
  },
  phase: {
    label: "Phase",
    stored: "phase",
    title: () => "Phase relative to the load, \u00b0",
    unit: "",
    palette: "cyclic",
    around: "ends",
    cyclic: true,
  },
  in_phase: {
    label: "Signed",
    stored: "in_phase",
    title: (film) => `Warming with the load (${convention(film)})`,
    palette: "diverging",
    around: "zero",
  },
  fitted: {
    label: "From forces",
    stored: "fitted",
    title: () => "Warming predicted from the contact forces (peak to peak)",
    palette: "diverging",
    around: "zero",
  },
  fit_residual: {
    label: "Misfit",
    stored: "fit_residual",
    title: () => "Warming beyond that predicted from the contact forces (peak to peak)",
    palette: "diverging",
    around: "zero",
  },
  second_harmonic: {
    label: "2\u2009f",
    stored: "second_harmonic",
    title: () => "Amplitude at twice the frequency",
    palette: "stress",
    around: "ends",
  },
  standard_error: {
    label: "Noise",
    stored: "standard_error",
    title: () => "Standard error of the signed amplitude",
    palette: "size",
    around: "ends",
  },
  residual: {
    label: "Residual",
    stored: "residual",
    title: () => "Residual of the fit (r.m.s.)",
    palette: "size",
    around: "ends",
  },
  bad: {
    label: "Bad pixels",
    stored: "picture",
    title: () => "Image at the smallest load",
    palette: "grey",
    around: "ends",
    when: (film) => film.bad.length > 0,
    marks: true,
  },
};

export const available = (film) =>
  Object.keys(maps).filter((name) => film.about.maps[maps[name].stored] && (maps[name].when?.(film) ?? true));

export const faintBelow = 3; // standard errors

/** Whether a pixel's amplitude is lost in noise, so that its phase says nothing. */
export function faintness(film) {
  if (!film.about.maps.amplitude || !film.about.maps.standard_error) return null;
  const amplitude = film.values("amplitude"),
    error = film.values("standard_error");
  return (k) => amplitude[k] < faintBelow * error[k];
}
