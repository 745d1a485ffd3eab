import { pointer, select } from "d3-selection";
import { zoom } from "d3-zoom";

const farthest = 0.5,
  nearest = 400; // against the view of the whole
const keyStep = 1.25,
  arrowStep = 0.1; // a factor; of the picture's width
const notch = 0.5; // powers of two, at most

const zoomsByWheel = (event) => event.ctrlKey || event.metaKey;

/** Not once the browser scrolls with the first of them. */
const isTwoFingers = (event) => event.touches.length > 1 && event.cancelable;

/** The wheel and one finger alone scroll the page. */
function isForThePicture(event) {
  if (event.type === "wheel") return zoomsByWheel(event);
  return event.touches ? isTwoFingers(event) : !event.button && !event.ctrlKey;
}

/** Powers of two: a touchpad's pinch comes as many small turns of the wheel with Ctrl, a mouse's wheel as few large
    ones. */
function powersOfTwo({ deltaY, deltaMode }) {
  return Math.max(-notch, Math.min(notch, -deltaY * (deltaMode === 1 ? 0.5 : deltaMode ? 10 : 0.02)));
}

const arrows = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** What pointer, fingers and keys do on a picture with a camera: Ctrl and the wheel or a pinch zoom, dragging moves,
    double click and 0 show all, + and - zoom, arrows move what is zoomed. Calls back: `moved()` after the camera moved,
    `hover(place)`, `leave()`, `click(place)`, `reset()`, `scrolled()` when one scrolled the page over the picture.
    Gives a function to call when the camera was moved by others. */
export function gestures(canvas, camera, { moved, hover, leave, reset, scrolled, click = () => {} }) {
  const picture = select(canvas);
  const behaviour = zoom()
    .filter(isForThePicture)
    .wheelDelta(powersOfTwo)
    .scaleExtent([farthest, nearest])
    .clickDistance(4)
    .on("zoom", ({ transform }) => {
      camera.follow(transform);
      leave();
      moved();
    });
  picture
    // or the browser scrolls with both
    .on("touchstart", (event) => isTwoFingers(event) && event.preventDefault(), { passive: false })
    .call(behaviour)
    .on("dblclick.zoom", null)
    // at its ends the zoom lets the browser zoom the page
    .on("wheel", (event) => (zoomsByWheel(event) ? event.preventDefault() : scrolled()), { passive: false })
    .on("touchmove", (event) => event.touches.length === 1 && scrolled(), { passive: true })
    .on("pointermove", (event) => event.buttons === 0 && hover(pointer(event, canvas)))
    .on("pointerleave", leave)
    .on("click", (event) => {
      hover(pointer(event, canvas));
      click(pointer(event, canvas));
    })
    .on("dblclick", reset)
    .on("keydown", (event) => {
      const factor = { "+": keyStep, "=": keyStep, "-": 1 / keyStep }[event.key],
        way = !camera.fitted && arrows[event.key];
      if (factor) behaviour.scaleBy(picture, factor);
      else if (event.key === "0" || event.key === "Escape") reset();
      else if (way) {
        event.preventDefault();
        behaviour.translateBy(picture, ...way.map((w) => (w * arrowStep * camera.width) / camera.transform.k));
      }
    });
  return () => behaviour.transform(picture, camera.transform);
}
