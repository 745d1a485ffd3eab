/** What the pointer and the keys do on a picture with a camera: the wheel zooms, dragging moves, double click and 0 show
    all, + and - zoom. Calls back: `moved()` after the camera moved, `hover(place)`, `leave()`, `click(place)`, `reset()`. */
export function gestures(canvas, camera, { moved, hover, leave, reset, click = null }) {
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  let held = null, dragged = 0;
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    camera.zoom(...place(event), Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)));
    leave();
    moved();
  }, { passive: false });
  canvas.addEventListener("pointerdown", (event) => {
    held = place(event);
    dragged = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const now = place(event);
    if (!held) return hover(now);
    dragged += Math.hypot(now[0] - held[0], now[1] - held[1]);
    camera.pan(now[0] - held[0], now[1] - held[1]);
    held = now;
    leave();
    moved();
  });
  canvas.addEventListener("pointerup", (event) => {
    if (held && dragged < 4 && click) click(place(event));
    held = null;
  });
  canvas.addEventListener("pointercancel", () => { held = null; });
  canvas.addEventListener("pointerleave", () => { if (!held) leave(); });
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("keydown", (event) => {
    const factor = { "+": 1.25, "=": 1.25, "-": 0.8 }[event.key];
    if (factor) {
      camera.zoom(camera.width / 2, camera.height / 2, factor);
      moved();
    } else if (event.key === "0" || event.key === "Escape") reset();
  });
}
