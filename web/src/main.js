import { forms, keepInAddress } from "./address.js";
import { loadData } from "./block.js";
import { readWords } from "./declared.js";
import { h, readNotation } from "./dom.js";
import { readDrawn } from "./drawn.js";
import { FieldResult, PhaseMap } from "./field/result.js";
import { fieldSection } from "./field/section.js";
import { FilmResult } from "./film/result.js";
import { filmSection } from "./film/section.js";
import { header } from "./header.js";
import { packingSection } from "./packing/section.js";
import { provenance } from "./provenance.js";
import { Sample } from "./sample.js";
import { SphereResult } from "./spheres/result.js";
import { sphereSection } from "./spheres/section.js";
import { State } from "./state.js";
import { tabs } from "./tabs.js";
import { followTheme, preferredTheme, themeOf } from "./theme.js";
import { VolumeResult } from "./volume/result.js";
import { volumeSection } from "./volume/section.js";

/** The packing if there is one, then every result on a grid, every film, every stage of spheres, and every sample in
    space. */
function partsOf(sample, { fields, films, volumes, spheres }, state) {
  const packing =
    sample.snapshotCount > 0 ? [{ name: "packing", title: "Packing", make: () => packingSection(sample, state) }] : [];
  return [
    ...packing,
    ...fields.map((result, k) => ({
      name: `field-${k}`,
      title: titleOf(result),
      make: () => fieldSection(result, state, sample.about.figures.field),
    })),
    ...films.map((film, k) => ({
      name: `film-${k}`,
      title: titleOf(film),
      make: () => filmSection(film, state, sample.about.figures.film),
    })),
    ...spheres.map((stage, k) => ({
      name: `spheres-${k}`,
      title: titleOf(stage),
      make: () => sphereSection(stage, state, sample.about.figures.spheres),
    })),
    ...volumes.map((volume, k) => ({
      name: `volume-${k}`,
      title: titleOf(volume),
      make: () => volumeSection(volume, state, sample.about.figures.voxels),
    })),
  ];
}

const titleOf = ({ name }) => name[0].toUpperCase() + name.slice(1);

async function main() {
  const page = document.getElementById("page");
  try {
    const { about, block } = await loadData();
    readNotation(about.notation);
    readDrawn(about.drawn);
    readWords(about.words);
    const sample = new Sample(about, block);
    const maps = (about.maps ?? []).map((map) => new PhaseMap(map, block));
    const fields = (about.fields ?? []).map((field) => new FieldResult(field, maps, block, about.title));
    const films = (about.films ?? []).map((film) => new FilmResult(film, block, about.title));
    const volumes = (about.volumes ?? []).map((volume) => new VolumeResult(volume, block, about.title));
    const spheres = (about.spheres ?? []).map((stage) => new SphereResult(stage, block, about.title));
    const results = { fields, films, volumes, spheres };
    const state = new State({ theme: preferredTheme() }),
      parts = partsOf(sample, results, state);
    state.set({ tab: parts.at(-1)?.name });
    keepInAddress(state, { tab: forms.word(parts.map(({ name }) => name)) });
    if (parts.length === 0) throw new Error("this result holds no state of a packing");
    followTheme(state);
    const { elements, made } = tabs(parts, state);
    page.replaceChildren(
      header(about.title, sample, results, state),
      ...elements,
      provenance([
        ...sample.stages,
        ...Object.values(results)
          .flat()
          .map((result) => result.about),
      ]),
    );
    window.arenite = {
      state,
      made,
      ...made.get("packing"),
      get field() {
        return made.get(state.get("tab"));
      },
      get film() {
        return made.get(state.get("tab"));
      },
      get volume() {
        return made.get(state.get("tab"));
      },
      get spheres() {
        return made.get(state.get("tab"));
      },
      get theme() {
        return themeOf(state.get("theme"));
      },
    };
    document.documentElement.dataset.ready = "true";
  } catch (error) {
    page.replaceChildren(h("p", { class: "failure" }, `The page cannot be drawn: ${error.message}.`));
    throw error;
  }
}

main();
