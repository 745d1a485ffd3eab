// Opens the page of a small triaxial test of spheres between walls, and asserts what is painted.
// Usage: node sphere_page.test.mjs PAGE.html
import { runTests } from "./run.mjs";
import { tests as fields } from "./sphere/fields.mjs";
import { tests as figures } from "./sphere/figures.mjs";
import { tests as picture } from "./sphere/picture.mjs";
import { tests as selection } from "./sphere/selection.mjs";

await runTests(process.argv[2], [...figures, ...picture, ...selection, ...fields]);
