/** Which part of the plane is seen: `scale` in pixels a metre, (x, y) the point in the middle, y upwards. */
export class Camera {
  constructor() { Object.assign(this, { scale: 1, x: 0, y: 0, width: 1, height: 1, least: 1 }); }

  resize(width, height) { Object.assign(this, { width, height }); }

  fit(box, margin) {
    const width = box.right - box.left, height = box.top - box.bottom;
    this.scale = Math.min((this.width - 2 * margin) / width, (this.height - 2 * margin) / height);
    this.least = this.scale;
    this.x = (box.left + box.right) / 2;
    this.y = (box.bottom + box.top) / 2;
  }

  get fitted() { return this.scale === this.least; }

  toScreen(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toWorld(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** Zooms so that the point under (px, py) stays there. */
  zoom(px, py, factor) {
    const [x, y] = this.toWorld(px, py);
    this.scale = Math.min(Math.max(this.scale * factor, this.least * 0.5), this.least * 400);
    const [newX, newY] = this.toWorld(px, py);
    this.x += x - newX;
    this.y += y - newY;
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }
}
