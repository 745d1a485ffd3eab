import { h } from "./dom.js";

/** Buttons that save a picture, one a format: { svg: () => .., png: () => .. }. */
export const saveButtons = (what, forms) =>
  h(
    "span",
    { class: "saves" },
    Object.entries(forms).map(([form, onclick]) =>
      h(
        "button",
        {
          class: "save",
          "data-save": form,
          title: `Save ${what} as ${form.toUpperCase()}`,
          "aria-label": `Save ${what} as ${form.toUpperCase()}`,
          onclick,
        },
        form.toUpperCase(),
      ),
    ),
  );
