import assert from "node:assert/strict";
import { settle } from "./run.mjs";

const phone = { width: 360, height: 780 };
/** Pictures in space are painted soon without a graphics card in a small window. */
const small = { width: 400, height: 600 },
  stops = 5;

/** Paints a quarter of the pixels while `then` looks at none of them. */
async function coarsely(page, size, then) {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setDeviceMetricsOverride", { ...size, deviceScaleFactor: 0.5, mobile: false });
  try {
    await then();
  } finally {
    await session.send("Emulation.clearDeviceMetricsOverride");
    await session.detach();
  }
}

/** Every part of a page in turn. */
async function eachPart(page, then) {
  const tabs = await page.locator('[role="tab"]').all();
  if (tabs.length === 0) return then();
  for (const tab of tabs) {
    await tab.click();
    await settle(page);
    await then();
  }
}

/** A slider from its first position (Home) to its last (End) in so many stops, and a step by the keyboard. */
async function walkSlider(page, slider) {
  await slider.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await settle(page);
  const { min, max, step } = await slider.evaluate((one) => ({ min: +one.min, max: +one.max, step: +one.step || 1 }));
  const steps = Math.round((max - min) / step);
  for (let k = 1; k < stops; ++k) {
    await slider.fill(String(+(min + step * Math.round((k * steps) / stops)).toPrecision(12)));
    await settle(page);
  }
  await page.keyboard.press("End");
  await settle(page);
}

/** All that a list offers, and then what it had. */
async function walkList(page, list) {
  const before = await list.inputValue();
  for (const value of await list.locator("option").evaluateAll((all) => all.map((one) => one.value))) {
    await list.selectOption(value);
    await settle(page);
  }
  await list.selectOption(before);
}

/** Presses each button with the mouse, whose middle must be in sight and beneath nothing else. Buttons are counted anew
    after each, which may make or hide others. */
async function pressButtons(page) {
  const buttons = page.locator("button:visible:enabled:not([role=tab])");
  for (let k = 0; ; ++k) {
    // One question to the page for each: a locator's click asks a dozen, which takes longer than what the button does.
    const found = await buttons.evaluateAll((all, at) => {
      const one = all[at];
      if (!one) return null;
      one.scrollIntoView({ block: "center", inline: "center", behavior: "instant" });
      const { x, y, width, height } = one.getBoundingClientRect(),
        middle = [x + width / 2, y + height / 2];
      return { middle, free: one.contains(document.elementFromPoint(...middle)), name: one.outerHTML.slice(0, 120) };
    }, k);
    if (!found) return;
    assert.ok(found.free, `covered or out of sight: ${found.name}`);
    await page.mouse.click(...found.middle);
    await settle(page);
  }
}

async function playFromTheEnd(page) {
  const play = page.locator("button.play:visible"),
    slider = page.locator(".timeline .track input:visible");
  if ((await play.count()) === 0) return;
  await slider.focus();
  await page.keyboard.press("End");
  await play.click();
  await page.waitForTimeout(1000);
  await play.click();
  await settle(page);
}

/** What every kind of page is asked: whatever can be chosen is chosen once without an error in the console (runTests
    reads it), and on a phone nothing is wider than the screen. */
export const everyPage = [
  {
    name: "every slider from end to end, every choice and every button can be had",
    run: async (page) => {
      const before = page.viewportSize(),
        inSpace = (await page.locator("canvas.volume, canvas.spheres").count()) > 0;
      await coarsely(page, inSpace ? small : before, () =>
        eachPart(page, async () => {
          for (const slider of await page.locator("input[type=range]:visible:enabled").all())
            await walkSlider(page, slider);
          for (const list of await page.locator("select:visible").all()) await walkList(page, list);
          await pressButtons(page);
          await playFromTheEnd(page);
          assert.equal(await page.locator(".failure").count(), 0);
        }),
      );
      await page.setViewportSize(before);
    },
  },
  {
    name: "on a phone no page is wider than the screen",
    run: async (page) => {
      const before = page.viewportSize();
      await page.setViewportSize(phone);
      await eachPart(page, async () => {
        await page.waitForTimeout(100);
        const wide = await page.evaluate(() => [
          document.documentElement.scrollWidth,
          [...document.querySelectorAll("#page *")]
            .filter((one) => one.getBoundingClientRect().right > innerWidth + 0.5)
            .map((one) => `${one.tagName.toLowerCase()}.${one.getAttribute("class") ?? ""}`)
            .slice(0, 12)
            .join(", "),
        ]);
        assert.ok(wide[0] <= phone.width, `${wide[0]} px wide; beyond the screen: ${wide[1]}`);
      });
      await page.setViewportSize(before);
    },
  },
];
