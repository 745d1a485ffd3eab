// Pointer, wheel, fingers and keys over a packing.
import assert from "node:assert/strict";
import { settle, zoom } from "../run.mjs";
import { click, grain, chain } from "./looking.mjs";

export const tests = [];
const test = (name, run) => tests.push({ name, run });

test("hovering tells a grain's and a contact's numbers", async (page) => {
  const strong = await chain(page, "push");
  await page.mouse.move(strong.x, strong.y);
  const contact = await page.locator(".tooltip").innerText();
  for (const id of strong.ids) assert.ok(contact.includes(String(id)), contact);
  assert.match(contact, /Fn/);
  await click(page, "chains", "off");
  const { x, y, id, radius } = await grain(page, 20);
  await page.mouse.move(x + 0.3 * radius, y);
  const words = await page.locator(".tooltip").innerText();
  assert.ok(words.includes(`Grain ${id}`), words);
  assert.match(words, /diameter\s+1[06]\.\d+/);
  assert.match(words, /contacts z/);
  await page.mouse.move(2, 2);
  assert.equal(await page.locator(".tooltip").isVisible(), false);
  await click(page, "chains", "all");
});

test("the wheel over the picture scrolls the page, leaves the picture, and a line says how to zoom", async (page) => {
  const hint = page.locator(".hint"),
    opacity = () => hint.evaluate((line) => Number(getComputedStyle(line).opacity));
  assert.equal(await opacity(), 0);
  const { x, y, radius } = await grain(page, 20);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => window.scrollY > 60);
  assert.equal((await grain(page, 20)).radius, radius);
  assert.match(await hint.textContent(), /Ctrl \+ wheel zooms/);
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".hint")).opacity === "1");
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".hint")).opacity === "0");
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.waitForFunction(() => window.scrollY === 0);
});

test("Ctrl and the wheel zoom about the pointer without scrolling; a double click shows all again", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await zoom(page, 2);
  const after = await grain(page, 20);
  assert.ok(Math.abs(after.radius / before.radius - 2) < 1e-9, `${before.radius} -> ${after.radius}`);
  assert.ok(Math.hypot(after.x - before.x, after.y - before.y) < 1);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  await page.mouse.dblclick(before.x, before.y);
  await settle(page);
  assert.ok(Math.abs((await grain(page, 20)).radius - before.radius) < 1e-6);
  await page.mouse.move(2, 2);
});

test("a touchpad's pinch, many small turns with Ctrl, zooms as far as fingers move", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await page.keyboard.down("Control");
  for (let k = 0; k < 50; ++k) await page.mouse.wheel(0, -1);
  await page.keyboard.up("Control");
  await settle(page);
  assert.ok(Math.abs((await grain(page, 20)).radius / before.radius - 2) < 1e-6);
  await page.mouse.dblclick(before.x, before.y);
});

test("at the end of its range the zoom does not zoom the page", async (page) => {
  const { x, y } = await grain(page, 20);
  await page.mouse.move(x, y);
  await zoom(page, -6);
  const wide = await page.evaluate(() => [window.innerWidth, devicePixelRatio]);
  const kept = await page.locator("canvas.grains").evaluate((canvas) => {
    const turn = new WheelEvent("wheel", { deltaY: 100, ctrlKey: true, bubbles: true, cancelable: true });
    canvas.dispatchEvent(turn);
    return turn.defaultPrevented;
  });
  assert.ok(kept);
  assert.deepEqual(await page.evaluate(() => [window.innerWidth, devicePixelRatio]), wide);
  await page.mouse.dblclick(x, y);
});

test("dragging moves the picture with the pointer, and a drag is no click", async (page) => {
  const before = await grain(page, 20);
  await page.mouse.move(before.x, before.y);
  await page.mouse.down();
  await page.mouse.move(before.x + 20, before.y + 10);
  await page.mouse.move(before.x + 60, before.y - 35);
  assert.equal(await page.locator(".tooltip").isVisible(), false);
  await page.mouse.up();
  await settle(page);
  const after = await grain(page, 20);
  assert.ok(
    Math.hypot(after.x - before.x - 60, after.y - before.y + 35) < 1e-6,
    `${after.x - before.x}, ${after.y - before.y}`,
  );
  await page.locator("canvas.grains").focus();
  await page.keyboard.press("0");
  await settle(page);
  assert.ok(Math.hypot((await grain(page, 20)).x - before.x, (await grain(page, 20)).y - before.y) < 1e-9);
});

test("keys zoom, move what is zoomed, and show all", async (page) => {
  const before = await grain(page, 20);
  await page.locator("canvas.grains").focus();
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.equal((await grain(page, 20)).x, before.x);
  await page.keyboard.press("+");
  await settle(page);
  const larger = await grain(page, 20),
    width = await page.evaluate(() => window.arenite.view.camera.width);
  assert.ok(Math.abs(larger.radius / before.radius - 1.25) < 1e-9);
  await page.keyboard.press("ArrowRight");
  await settle(page);
  const moved = await grain(page, 20);
  assert.ok(
    Math.abs(larger.x - moved.x - 0.1 * width) < 1e-6 && Math.abs(larger.y - moved.y) < 1e-9,
    `${larger.x} -> ${moved.x}`,
  );
  await page.keyboard.press("-");
  await page.keyboard.press("Escape");
  await settle(page);
  assert.ok(Math.hypot((await grain(page, 20)).x - before.x, (await grain(page, 20)).y - before.y) < 1e-9);
});
