// What the tests of the page of spheres look at it by.
import { difference, painted, pause } from "../browser.mjs";
import { rgb } from "../run.mjs";

export const card = rgb("#ffffff"),
  glass = rgb("#5b8fc9");
export const asItBegins = {
  show: "material",
  chains: false,
  spheres: true,
  cutx: 100,
  cuty: 100,
  cutz: 100,
  snapshot: 1,
  half: "above",
  azimuth: 35,
  elevation: 25,
};

export const set = (page, changes) => page.evaluate((values) => window.arenite.spheres.state.set(values), changes);
export const get = (page, key) => page.evaluate((name) => window.arenite.spheres.state.get(name), key);
export const canvasOf = (page) => page.locator("canvas.spheres:visible");

/** The picture as it is after some changes, without lines over it: [r, g, b] at its pixels. */
export async function pictureWith(page, changes) {
  await set(page, changes);
  await page.evaluate(() => {
    window.arenite.spheres.view.over.style.visibility = "hidden";
  });
  await canvasOf(page).scrollIntoViewIfNeeded();
  await page.mouse.move(2, 2);
  await page.waitForTimeout(pause);
  const at = await painted(page),
    box = await canvasOf(page).boundingBox();
  return (x, y) => at(box.x + x, box.y + y);
}

/** Places of the picture around which four pixels show the same sphere, or none. */
export const placesIn = (page) =>
  page.evaluate(() => {
    const { view } = window.arenite.spheres,
      { width, height } = view.camera,
      found = [];
    for (let x = 0.05; x < 0.95; x += 0.0413)
      for (let y = 0.05; y < 0.95; y += 0.0413) {
        const at = (dx, dy) => view.sphereAt([x * width + dx, y * height + dy]),
          sphere = at(0, 0);
        if ([at(4, 0), at(-4, 0), at(0, 4), at(0, -4)].some((other) => other !== sphere)) continue;
        found.push({ x: x * width, y: y * height, sphere });
      }
    return found;
  });

export const differs = (a, b) => difference(a, b) > 12;
