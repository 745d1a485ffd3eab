/** Every figure of a film, in the order of the page; `sample` is its FilmResult and there is no texture. */
export const filmFigures = [];
