// The spheres that the page of a small triaxial test paints: colours, cuts, forces, states, pointer.
import assert from "node:assert/strict";
import { difference, elsewhere, painted, saved } from "../browser.mjs";
import { becomes, rgb, settle } from "../run.mjs";
import {
  asItBegins,
  canvasOf,
  card,
  differs,
  get,
  glass,
  pictureWith,
  placesIn,
  set,
} from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("a line of sight is painted as the sphere that it meets, or as the card where it meets none", async (page) => {
  const picture = await pictureWith(page, asItBegins),
    seen = { sphere: 0, none: 0 };
  for (const { x, y, sphere } of await placesIn(page)) {
    const [r, g, b] = await picture(x, y);
    ++seen[sphere === null ? "none" : "sphere"];
    if (sphere === null) assert.ok(difference([r, g, b], card) <= 2, `beside all spheres is ${[r, g, b]}`);
    else assert.ok(b > g && g > r && difference([r, g, b], glass) < 170, `sphere ${sphere} is ${[r, g, b]}`);
  }
  assert.ok(seen.sphere > 30 && seen.none > 30, JSON.stringify(seen));
});

test("what is nearer to the viewer hides what is behind, from every side", async (page) => {
  for (const [azimuth, axis, sign] of [
    [0, "z", 1],
    [90, "x", 1],
    [180, "z", -1],
  ]) {
    await set(page, { ...asItBegins, azimuth, elevation: 0 });
    const [seen, all] = await page.evaluate((axis) => {
      const { view, result } = window.arenite.spheres,
        { width, height } = view.camera,
        mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length,
        found = [];
      for (let x = 0.3; x < 0.7; x += 0.02)
        for (let y = 0.3; y < 0.7; y += 0.02) {
          const sphere = view.sphereAt([x * width, y * height]);
          if (sphere !== null) found.push(result.state[axis][sphere]);
        }
      return [mean(found), mean([...result.state[axis]])];
    }, axis);
    assert.ok(sign * (seen - all) > 3e-3, `${axis} from ${azimuth}: ${seen} and ${all}`);
  }
});

test("pressure, contacts and speed have colours of their own, and a bar that tells them", async (page) => {
  const places = (await placesIn(page)).filter(({ sphere }) => sphere !== null);
  assert.ok(places.length > 20);
  let before = await pictureWith(page, asItBegins);
  for (const [show, title] of [
    ["pressure", /^Pressure of grains, [kM]?Pa.*mean/],
    ["coordination", /^Contacts per grain/],
    ["speed", /^Velocity/],
  ]) {
    const now = await pictureWith(page, { ...asItBegins, show });
    let changed = 0;
    for (const { x, y } of places) changed += differs(await before(x, y), await now(x, y));
    assert.ok(changed > places.length / 2, `${show}: ${changed} of ${places.length}`);
    assert.match(await page.locator("svg.sphere-key:visible").textContent(), title);
    before = now;
  }
});

test("spheres whose centres lie beyond a cut are not there", async (page) => {
  const places = await pictureWith(page, asItBegins).then(() => placesIn(page)),
    picture = await pictureWith(page, { ...asItBegins, cutx: 40 }),
    middle = await page.evaluate(() => {
      const { corner, size } = window.arenite.spheres.result.state.container;
      return corner[0] + 0.4 * size[0];
    });
  const left = await placesIn(page);
  const x = await page.evaluate(() => [...window.arenite.spheres.result.state.x]);
  for (const { sphere } of left) assert.ok(sphere === null || x[sphere] <= middle + 1e-6);
  const painted_ = (list) => list.filter(({ sphere }) => sphere !== null).length;
  assert.ok(painted_(left) < 0.8 * painted_(places), `${painted_(left)} of ${painted_(places)}`);
  for (const place of left.filter(({ sphere }) => sphere === null))
    assert.ok(difference(await picture(place.x, place.y), card) <= 2);
  await page.locator('[data-slider="cutx"]:visible').focus();
  await page.keyboard.press("End");
  await settle(page);
  assert.equal(await get(page, "cutx"), 100);
});

test("the pointer on a sphere is told its name, radius, contacts and pressure", async (page) => {
  await pictureWith(page, asItBegins);
  const box = await canvasOf(page).boundingBox(),
    { x, y, sphere } = (await placesIn(page)).find((place) => place.sphere !== null);
  await page.mouse.move(box.x + x, box.y + y);
  const words = await page.locator(".tooltip:visible").innerText();
  const known = await page.evaluate((g) => {
    const { result } = window.arenite.spheres;
    return [
      `Sphere ${result.state.id[g]}, glass`,
      ...["pressure", "coordination", "speed"].flatMap((id) => [result.quantity(id).label, result.written(id, g)]),
    ];
  }, sphere);
  for (const part of [...known, "radius"]) assert.ok(words.includes(part), `${words}: ${part}`);
  assert.match(words, /radius\s+[12]\.\d+\u202fmm/);
  await page.mouse.move(box.x + 3, box.y + 3);
  assert.equal(await page.locator(".tooltip:visible").count(), 0);
});

test("forces are lines between the spheres, which are then pale or not there", async (page) => {
  await pictureWith(page, asItBegins);
  const places = await placesIn(page);
  const dark = async (picture) => {
    let sum = 0;
    for (const { x, y } of places) sum += difference(await picture(x, y), card) > 60;
    return sum;
  };
  const solid = await dark(await pictureWith(page, asItBegins)),
    pale = await dark(await pictureWith(page, { ...asItBegins, chains: true })),
    alone = await dark(await pictureWith(page, { ...asItBegins, chains: true, spheres: false })),
    none = await dark(await pictureWith(page, { ...asItBegins, spheres: false }));
  assert.equal(none, 0);
  assert.ok(alone > 3, `${alone} places on lines`);
  assert.ok(alone < solid && pale < solid, `${[solid, pale, alone]}`);
  assert.match(await page.locator("svg.sphere-key:visible").textContent(), /glass \(150\)/);
});

test("every force of the state joins its spheres, or a sphere and a wall", async (page) => {
  const { longest, walls, all, radius } = await page.evaluate(() => {
    const { view, result } = window.arenite.spheres,
      { forces } = result.state;
    view.state.set({ chains: true });
    view.draw();
    const { ends } = view.forces,
      lengths = [];
    for (let k = 0; k < ends.length; k += 6)
      lengths.push(Math.hypot(ends[k] - ends[k + 3], ends[k + 1] - ends[k + 4], ends[k + 2] - ends[k + 5]));
    return {
      longest: Math.max(...lengths),
      all: lengths.length === forces.all,
      walls: [...forces.j].filter((j) => j >= result.count).length,
      radius: Math.max(...result.state.radius),
    };
  });
  assert.ok(all && walls > 20, `${walls} at walls`);
  assert.ok(longest <= 2 * radius * 1.0001, `${longest} between spheres of ${radius}`);
});

test("it turns by dragging; 0 shows it as in the beginning; picture and address can be kept", async (page) => {
  await pictureWith(page, asItBegins);
  const box = await canvasOf(page).boundingBox(),
    [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 50, y + 25, { steps: 4 });
  await page.mouse.up();
  const seen = () => Promise.all(["azimuth", "elevation"].map((key) => get(page, key)));
  await becomes(seen, [15, 35]);
  await becomes(() => /azimuth=15/.test(page.url()), true);
  await canvasOf(page).focus();
  await page.keyboard.press("0");
  await becomes(seen, [35, 25]);
  assert.equal(
    (await saved(page, '[aria-label="Spheres"]:visible [data-save="png"]')).subarray(1, 4).toString(),
    "PNG",
  );
  assert.match((await saved(page, '[aria-label="Spheres"]:visible [data-save="svg"]')).toString(), /data:image\/png/);
});

test("the slider shows the stored states, each with its own places and container", async (page) => {
  const heights = [];
  for (const [snapshot, label] of [
    [0, "1 of 2"],
    [1, "2 of 2"],
  ]) {
    await pictureWith(page, { ...asItBegins, snapshot });
    assert.match(await page.locator(".timeline:visible output").innerText(), new RegExp(`axial · ${label} · t = `));
    const { top, highest, lowest } = await page.evaluate(() => {
      const { state, size } = window.arenite.spheres.result,
        ends = [...state.y].map((y, g) => [y - state.radius[g], y + state.radius[g]]);
      return {
        top: state.container.corner[1] + size[1],
        lowest: Math.min(...ends.map(([low]) => low)) - state.container.corner[1],
        highest: Math.max(...ends.map(([, high]) => high)),
      };
    });
    assert.ok(Math.abs(highest - top) < 1e-4 && Math.abs(lowest) < 1e-4, "between its own platens");
    heights.push(top);
  }
  assert.ok(heights[1] < heights[0] - 2e-4, `${heights}: the top comes down`);
  await pictureWith(page, { ...asItBegins, snapshot: 0 });
  const first = await pictureWith(page, { ...asItBegins, snapshot: 0, show: "pressure" }),
    places = (await placesIn(page)).filter(({ sphere }) => sphere !== null);
  const last = await pictureWith(page, { ...asItBegins, show: "pressure" });
  let changed = 0;
  for (const { x, y } of places) changed += differs(await first(x, y), await last(x, y));
  assert.ok(changed > places.length / 4, `${changed} of ${places.length}`);
  await set(page, { snapshot: 0 });
  assert.match(page.url(), /axial-snapshot=0/);
  assert.match(await page.locator('[aria-label="Spheres"]:visible .note:visible').innerText(), /of the last state\.$/);
});

test("it opens dark, on a phone of 390 pixels", async (page) => {
  const phone = { viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true, isMobile: true };
  await elsewhere(page, phone, null, async (other) => {
    assert.equal(await other.evaluate(() => document.documentElement.scrollWidth), 390);
    await canvasOf(other).scrollIntoViewIfNeeded();
    const { x, y, width } = await canvasOf(other).boundingBox();
    assert.ok(width > 300);
    assert.ok(difference(await (await painted(other))(x + 3, y + 3), rgb("#161a1f")) <= 2);
  });
});

test("without WebGL2 a sentence stands in the picture's place, and the figures remain", async (page) => {
  const without = () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (name, options) {
      return name === "webgl2" ? null : getContext.call(this, name, options);
    };
  };
  await elsewhere(page, { viewport: { width: 1400, height: 900 } }, without, async (other) => {
    assert.match(await other.locator(".stage .nothing").innerText(), /no WebGL2.*figures/);
    assert.ok((await other.locator('[data-figure="forces"] .drawing svg').count()) > 0);
  });
});
