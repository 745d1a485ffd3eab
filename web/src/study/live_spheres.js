import { inflate } from "../block.js";
import { h, rich } from "../dom.js";
import { SphereResult } from "../spheres/result.js";
import { choices, panelOf } from "../spheres/section.js";
import { SphereView } from "../spheres/view.js";
import { State } from "../state.js";

/** What can be chosen of a state; where that changes the panel is made anew. */
const offers = (result) => [result.offered, result.hasForces, result.hasBonds, result.hasBoundaries].join(" ");

/** The spheres of a run under way, as the page of its result shows them, in one picture that keeps the reader's choices
    while its states follow one another. */
export class LiveSpheres {
  element = h("div", { class: "spheres" });

  constructor(page) {
    this.page = page;
    page.watch(["theme"], () => this.state?.set({ theme: page.get("theme") }));
  }

  /** A figure of spheres, or null where there is none. */
  async show(figure) {
    this.wanted = figure;
    if (!figure) return this.element.replaceChildren();
    const block = await inflate(figure.block);
    if (this.wanted !== figure) return; // a later one has come meanwhile
    const result = new SphereResult(figure.spheres, block, "");
    if (this.view?.stage.isConnected && offers(result) === this.offered) this.view.showState(result);
    else this.#begin(figure, result);
  }

  #begin(figure, result) {
    const before = this.state;
    this.state = new State({ theme: this.page.get("theme"), ...choices(result) });
    for (const key of before ? ["azimuth", "elevation", "zoom", "chains", "spheres"] : [])
      this.state.set({ [key]: before.get(key) });
    this.offered = offers(result);
    this.view = new SphereView(result, this.state);
    this.element.replaceChildren(h("h2", {}, rich(figure.title)), panelOf(result, this.state, this.view));
  }
}
