import { h, rich } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { State } from "../state.js";
import { studyFigure } from "./figure.js";
import { LiveSpheres } from "./live_spheres.js";

const lives = {
  running: "running",
  stopped: "stopped; the same command continues from the checkpoint",
  died: "its process has ended; the same command continues from the last checkpoint",
  unknown: "no status for a minute",
  waiting: "not started",
  ended: "ended",
};

const span = (s) =>
  s < 90 ? `${Math.round(s)} s` : s < 5400 ? `${Math.round(s / 60)} min` : `${(s / 3600).toFixed(1)} h`;

/** Where a run stands, in a line. */
export function progressText({ life, status }) {
  if (!status) return "";
  const { stage, stages, name, increment, increments, settles, share, step, field, seconds_left } = status;
  return [
    `stage ${stage + 1} of ${stages}, ${name}`,
    increments > 1 && `increment ${increment} of ${increments}`,
    settles ? `${(100 * share).toFixed(0)} %` : "does not settle",
    step && `${field ? "iteration" : "step"} ${step}`,
    life === "running" && seconds_left !== null && `about ${span(seconds_left)} left`,
  ]
    .filter(Boolean)
    .join(", ");
}

/** A run while it goes on: asked for every second, its figures drawn anew when they have changed. */
export function livePage(state) {
  const where = h("p", {}),
    title = h("h1", {}),
    now = h("p", { class: "now", "aria-live": "polite" }),
    done = h("div"),
    bar = h("div", { class: "bar", role: "progressbar", "aria-valuemin": 0, "aria-valuemax": 100 }, done),
    link = h("a", { href: "page", hidden: true }, "Full page of the finished stages"),
    answer = h("span", {}),
    stop = h("button", { class: "toggle", hidden: true, onclick: ask }, "Stop the run"),
    stages = h("ol", {}),
    cards = h("div", { class: "figures study" }),
    spheres = new LiveSpheres(state);
  let figures = [],
    drawn = "",
    missed = 0;

  async function ask() {
    const { ok } = await fetch("stop", { method: "POST" });
    answer.textContent = ok ? "stop requested; the run writes its checkpoint and exits" : "it is no longer running";
  }
  // Cards get a state of their own each time, so that those that are gone hear of nothing.
  function draw() {
    const own = new State({ theme: state.get("theme") }),
      sample = { title: title.textContent, texture: () => null };
    const flat = figures.filter((figure) => !figure.spheres);
    cards.replaceChildren(...flat.map((figure) => figureCard(studyFigure(figure), sample, own)));
  }
  function show(run) {
    const share = run.life === "ended" ? 1 : (run.status?.share ?? 0);
    title.textContent = document.title = run.title || run.folder;
    where.textContent = `${run.folder}: ${lives[run.life] ?? run.life}`;
    now.textContent = progressText(run);
    done.style.width = `${100 * share}%`;
    bar.setAttribute("aria-valuenow", Math.round(100 * share));
    link.hidden = run.stages.length === 0;
    stop.hidden = run.life !== "running";
    stages.replaceChildren(...run.stages.map(({ name, outcome }) => h("li", {}, rich(`${name}: ${outcome}`))));
    if (run.at === drawn) return;
    drawn = run.at;
    figures = run.figures;
    spheres.show(figures.find((figure) => figure.spheres) ?? null);
    draw();
  }
  async function look() {
    try {
      show(await (await fetch("state")).json());
      missed = 0;
    } catch {
      if (++missed > 2) where.textContent = "this page is no longer served; `arenite watch FOLDER` serves it again";
    }
    setTimeout(look, 1000);
  }
  state.watch(["theme"], draw);
  look();
  return {
    head: [title, where],
    body: [
      h("section", { class: "card live" }, now, bar, h("p", {}, link, " ", stop, " ", answer), stages),
      spheres.element,
      cards,
    ],
  };
}
