// Opens a page of a sample in space that is sheared, with void, matrix and grains, and asserts what is painted.
// Usage: node volume_page.test.mjs PAGE.html
import { runTests } from "./run.mjs";
import { tests as slices } from "./volume/slices.mjs";
import { tests as space } from "./volume/space.mjs";

await runTests(process.argv[2], [...slices, ...space]);
