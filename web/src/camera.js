import { zoomIdentity } from "d3-zoom";

/** Which part of the plane is seen: `scale` in pixels a metre, (x, y) the point in the middle, y upwards; `whole` is
    the same where all is seen. */
export class Camera {
  constructor() {
    Object.assign(this, { scale: 1, x: 0, y: 0, width: 1, height: 1, whole: { scale: 1, x: 0, y: 0 } });
  }

  resize(width, height) {
    Object.assign(this, { width, height });
  }

  /** Shows a box as large as it fits. */
  show(box, margin) {
    const width = box.right - box.left,
      height = box.top - box.bottom;
    this.scale = Math.min((this.width - 2 * margin) / width, (this.height - 2 * margin) / height);
    this.x = (box.left + box.right) / 2;
    this.y = (box.bottom + box.top) / 2;
  }

  /** Shows the box of all that there is. */
  fit(box, margin) {
    this.show(box, margin);
    this.whole = { scale: this.scale, x: this.x, y: this.y };
  }

  get fitted() {
    return this.scale === this.whole.scale;
  }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toWorld(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** From places on the screen where all is seen to where they are now: what d3-zoom calls the transform. */
  get transform() {
    const { whole, scale, width, height } = this,
      k = scale / whole.scale;
    return zoomIdentity
      .translate(
        (1 - k) * (width / 2) + (whole.x - this.x) * scale,
        (1 - k) * (height / 2) - (whole.y - this.y) * scale,
      )
      .scale(k);
  }

  follow({ k, x, y }) {
    const { whole, width, height } = this;
    this.scale = k * whole.scale;
    this.x = whole.x - (x - (1 - k) * (width / 2)) / this.scale;
    this.y = whole.y + (y - (1 - k) * (height / 2)) / this.scale;
  }
}
