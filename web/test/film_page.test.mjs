// Opens a page of a film (and of another one's maps alone), and asserts what is painted.
// Usage: node film_page.test.mjs PAGE.html
import { runTests } from "./run.mjs";
import { tests as picture } from "./film/picture.mjs";
import { tests as figures } from "./film/figures.mjs";

await runTests(process.argv[2], [...picture, ...figures]);
