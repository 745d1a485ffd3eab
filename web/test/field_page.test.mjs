// Opens a page of a cemented sample, its load and its test to failure, and asserts what is painted.
// Usage: node field_page.test.mjs PAGE.html
import { runTests } from "./run.mjs";
import { tests as picture } from "./field/picture.mjs";
import { tests as figures } from "./field/figures.mjs";

await runTests(process.argv[2], [...picture, ...figures]);
