import { h, readNotation, rich } from "../dom.js";
import { readDrawn } from "../drawn.js";
import { figureCard } from "../figures/card.js";
import { State } from "../state.js";
import { followTheme, preferredTheme } from "../theme.js";
import { studyFigure } from "./figure.js";
import { livePage } from "./live.js";
import { runsTable } from "./runs_table.js";
import { plainTable } from "./table.js";

function head(words, state) {
  const button = h(
    "button",
    {
      class: "theme",
      title: "Light or dark",
      onclick: () => state.set({ theme: state.get("theme") === "dark" ? "light" : "dark" }),
    },
    "\u25d0",
  );
  return h("header", {}, h("div", {}, words), button);
}

function main() {
  const page = document.getElementById("page");
  try {
    const about = JSON.parse(document.getElementById("figures").textContent);
    readNotation(about.notation);
    readDrawn(about.drawn);
    const state = new State({ theme: preferredTheme() });
    followTheme(state);
    if (about.live) {
      const live = livePage(state);
      page.replaceChildren(head(live.head, state), ...live.body);
      document.documentElement.dataset.ready = "true";
      return;
    }
    const sample = { title: about.title, texture: () => null };
    const cards = about.figures.map((figure) => figureCard(studyFigure(figure), sample, state));
    cards.forEach((card, k) => {
      card.id = about.figures[k].id;
    });
    const { first = [], tables = [] } = about;
    page.replaceChildren(
      head([h("h1", {}, rich(about.title)), h("p", {}, about.runs)], state),
      ...first.map(plainTable),
      h("div", { class: "figures study" }, cards),
      about.table ? runsTable(about.title, about.table) : "",
      ...tables.map(plainTable),
      h("footer", {}, h("p", {}, about.made)),
    );
    document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
    document.documentElement.dataset.ready = "true";
  } catch (error) {
    page.replaceChildren(h("p", { class: "failure" }, `The page cannot be drawn: ${error.message}.`));
    throw error;
  }
}

main();
