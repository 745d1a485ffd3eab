// What the tests of the page of a sample in space look at it by.
import { rgb } from "../run.mjs";

export const kind = ["#ffffff", "#f4d27a", "#6e9fd0"].map(rgb);

export const set = (page, changes) => page.evaluate((values) => window.arenite.volume.state.set(values), changes);

export const get = (page, key) => page.evaluate((name) => window.arenite.volume.state.get(name), key);

export const boxOf = (page, selector) => page.locator(selector).boundingBox();
