import { pointer } from "d3-selection";

const still = 4; // pixels that a click may move
const keyTurn = 5; // degrees
const keyZoom = 1.25,
  notch = 0.5; // powers of two, at most
const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const middleOf = (places) => [0, 1].map((c) => places.reduce((sum, place) => sum + place[c], 0) / places.length);
const spreadOf = ([a, b]) => (b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 1);

/** What pointer, fingers and keys do on a picture of space: dragging and one finger turn it, with Shift or two fingers
    it moves, Ctrl and the wheel or a pinch zoom, double click and 0 show all as in the beginning; a finger that moves
    up or down first scrolls the page. Calls back: `turn(dx, dy)` and `move(dx, dy)` in pixels, `zoom(factor, place)`,
    `hover(place)`, `leave()`, `click(place)`, `reset()`, `scrolled()`. */
export function turning(canvas, { turn, move, zoom, hover, leave, click, reset, scrolled }) {
  const down = new Map(); // places of the pointers that are down
  let travelled = 0,
    turns = false,
    start = [0, 0];
  /** A finger that starts upwards or downwards is the page's. */
  const scrolls = (event, place) =>
    event.pointerType === "touch" && !turns && Math.abs(place[1] - start[1]) > Math.abs(place[0] - start[0]);
  const drag = (event) => {
    const before = [...down.values()];
    down.set(event.pointerId, pointer(event, canvas));
    const now = [...down.values()],
      [x0, y0] = middleOf(before),
      [x1, y1] = middleOf(now);
    travelled += Math.hypot(x1 - x0, y1 - y0);
    if (travelled <= still) return;
    leave();
    if (now.length === 1 && scrolls(event, now[0])) {
      down.delete(event.pointerId);
      return scrolled();
    }
    turns = true;
    if (now.length > 1) zoom(spreadOf(now) / spreadOf(before), [x1, y1]);
    if (now.length > 1 || event.shiftKey) move(x1 - x0, y1 - y0);
    else turn(x1 - x0, y1 - y0);
  };
  const on = (name, then, options) => canvas.addEventListener(name, then, options);
  on("pointerdown", (event) => {
    if (event.button || event.ctrlKey || down.size > 1) return;
    if (down.size === 0) [travelled, turns, start] = [0, false, pointer(event, canvas)];
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, pointer(event, canvas));
  });
  on("pointermove", (event) => (down.has(event.pointerId) ? drag(event) : hover(pointer(event, canvas))));
  on("pointerup", (event) => {
    if (!down.delete(event.pointerId) || down.size || travelled > still) return;
    hover(pointer(event, canvas));
    click(pointer(event, canvas));
  });
  on("pointercancel", (event) => down.delete(event.pointerId));
  on("pointerleave", leave);
  on("dblclick", reset);
  on(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return scrolled();
      event.preventDefault();
      const turns = -event.deltaY * (event.deltaMode === 1 ? 0.5 : event.deltaMode ? 10 : 0.02);
      zoom(2 ** Math.max(-notch, Math.min(notch, turns)), pointer(event, canvas));
    },
    { passive: false },
  );
  on("keydown", (event) => {
    const factor = { "+": keyZoom, "=": keyZoom, "-": 1 / keyZoom }[event.key],
      way = arrows[event.key];
    if (factor) zoom(factor, [canvas.clientWidth / 2, canvas.clientHeight / 2]);
    else if (event.key === "0" || event.key === "Escape") reset();
    else if (way) {
      event.preventDefault();
      turn(...way.map((w, c) => (keyTurn / degreesAPixel) * (c ? -w : w)));
    }
  });
}

/** How far a drag turns. */
export const degreesAPixel = 0.4;
