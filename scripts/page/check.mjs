// Opens pages in headless Chromium and checks what a person would: nothing is loaded from elsewhere, no error is
// logged, the controls work by mouse and by key, axe-core finds no barrier in light and in dark, and nothing is wider
// than a phone. Usage: node check.mjs CHROMIUM SCREENSHOTS PAGE...
import { readFileSync, statSync } from "node:fs";
import { basename, resolve } from "node:path";
import { createRequire } from "node:module";
import puppeteer from "puppeteer-core";

const require = createRequire(import.meta.url);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const [chromium, screenshots, ...pages] = process.argv.slice(2);
const MOST_BYTES = 3e6;
const MOST_MILLISECONDS = 1000;
const WIDTHS = { phone: 360, tablet: 768, desktop: 1280 };
const failures = [];

function check(holds, what) {
  if (!holds) failures.push(what);
}

async function opened(browser, file, scheme, width) {
  const page = await browser.newPage();
  await page.setViewport({ width, height: 900 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  page.on("console", (message) => check(message.type() !== "error", `${file}: the console says: ${message.text()}`));
  page.on("pageerror", (error) => check(false, `${file}: the script fails: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    check(url.startsWith("file:") || url.startsWith("data:"), `${file}: it asks for ${url}`);
  });
  await page.goto("file://" + resolve(file), { waitUntil: "load" });
  return page;
}

async function barriers(page, file, scheme) {
  await page.evaluate(axe);
  // Everything that is folded is looked at too.
  await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
  const found = await page.evaluate(() => globalThis.axe.run());
  for (const { id, help, nodes } of found.violations)
    check(false, `${file}, ${scheme}: ${id}: ${help}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(" | ")}`);
  check(found.passes.length > 20, `${file}: axe-core applied ${found.passes.length} rules, expected more than 20`);
}

async function slider(page, file) {
  const part = () => page.$eval(".pair", (pair) => pair.style.getPropertyValue("--part"));
  check((await part()) === "50%", `${file}: the slider begins at ${await part()}, expected 50%`);
  await page.focus(".slider");
  for (let step = 0; step < 5; step++) await page.keyboard.press("ArrowRight");
  check((await part()) === "55%", `${file}: after five keys the slider is at ${await part()}, expected 55%`);
}

async function charts(page, file) {
  for (const chart of await page.$$(".chart")) {
    const points = await chart.$$(".point");
    check(points.length > 3, `${file}: a chart has ${points.length} marks, expected more than 3`);
    const readout = () => chart.$eval(".readout", (element) => element.textContent);
    for (const point of [points[0], points[points.length - 1]]) {
      // A mark that scrolls below the pointer shows its own figures.
      await page.mouse.move(0, 0);
      await point.evaluate((element) => element.focus());
      const label = await point.evaluate((element) => element.getAttribute("aria-label"));
      check((await readout()) === label, `${file}: the focus of a mark shows ${await readout()}, expected ${label}`);
    }
    await points[1].hover();
    const label = await points[1].evaluate((element) => element.getAttribute("aria-label"));
    // Another mark may lie above this one.
    check((await readout()).includes(":"), `${file}: the pointer at ${label} shows nothing`);
  }
}

// Steps through the group and back, and compares each value that is drawn with the table of all values.
async function steps(page, file) {
  const shown = () =>
    page.$$eval(".node", (nodes) => nodes.map((node) => [".v", ".s"].map((name) => node.querySelector(name).textContent)));
  const table = await page.$$eval(".stepper + details tbody tr", (rows) =>
    rows.map((row) => [...row.children].map((cell) => cell.textContent)),
  );
  const clocks = (table[0] ?? []).length - 2;
  check(clocks >= 9, `${file}: ${clocks} clocks can be stepped through, expected at least 9`);
  const expected = (clock) => {
    const value = (node, name) => table.find((row) => row[0] === `${node}, ${name}`)[clock + 1];
    return [...Array(16).keys()].map((node) => ["v", "s"].map((name) => `${name} ${value(node, name)}`));
  };
  const same = async (clock, how) =>
    check(
      JSON.stringify(await shown()) === JSON.stringify(expected(clock)),
      `${file}: after clock ${clock} ${how}, the drawing differs from the table`,
    );
  await same(0, "at first");
  for (let clock = 1; clock <= clocks; clock++) {
    await page.click('button[data-go="next"]');
    await same(clock, "by the button");
    check((await page.$$(".steps [aria-current]")).length === 1, `${file}: no step is marked after clock ${clock}`);
  }
  await page.focus('button[data-go="next"]');
  for (let clock = clocks - 1; clock >= 0; clock--) {
    await page.keyboard.press("ArrowLeft");
    await same(clock, "by the key");
  }
  await page.keyboard.press("End");
  await same(clocks, "by End");
}

// Steps through the registers of engines and compares each value that is shown with the table of all values.
async function pipelines(page, file) {
  for (const stepper of await page.$$(".stepper:has(.pipeline)")) {
    const table = await stepper.evaluate((element) =>
      [...element.nextElementSibling.querySelectorAll("tbody tr")].map((row) => [...row.children].map((cell) => cell.textContent)),
    );
    const clocks = (table[0] ?? []).length - 1;
    check(clocks > 9 && table.length > 20, `${file}: a pipeline of ${clocks} clocks and ${table.length} registers, expected more`);
    const shown = () =>
      stepper.$$eval(".pipeline tr", (rows) =>
        rows.map((row) => [...row.querySelectorAll("[data-place]")].map((cell) => cell.textContent).join(" ")),
      );
    for (let clock = 0; clock < clocks; clock++) {
      const expected = table.map((row) => row[clock + 1]);
      check(
        JSON.stringify(await shown()) === JSON.stringify(expected),
        `${file}: in clock ${clock} of a pipeline, the registers differ from the table`,
      );
      await (await stepper.$('button[data-go="next"]')).click();
    }
  }
}

const browser = await puppeteer.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"] });
for (const file of pages) {
  const bytes = statSync(file).size;
  check(bytes < MOST_BYTES, `${file}: ${bytes} bytes, expected less than ${MOST_BYTES}`);
  const page = await opened(browser, file, "light", WIDTHS.desktop);
  const { duration } = await page.evaluate(() => performance.getEntriesByType("navigation")[0].toJSON());
  console.log(`page: ${file}: ${bytes} bytes, ${Math.round(duration)} ms to open`);
  check(duration < MOST_MILLISECONDS, `${file}: ${duration} ms to open, expected less than ${MOST_MILLISECONDS}`);
  await slider(page, file);
  await charts(page, file);
  await steps(page, file);
  await pipelines(page, file);
  await barriers(page, file, "light");
  await page.close();
  const dark = await opened(browser, file, "dark", WIDTHS.desktop);
  await barriers(dark, file, "dark");
  await dark.close();
  for (const [name, width] of Object.entries(WIDTHS)) {
    for (const scheme of ["light", "dark"]) {
      const page = await opened(browser, file, scheme, width);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      check(wide <= width, `${file}: ${wide} pixels wide on a screen of ${width}`);
      const path = `${screenshots}/${basename(file, ".html")}-${name}-${scheme}.png`;
      await page.screenshot({ path, fullPage: true });
      await page.close();
    }
  }
}
await browser.close();
for (const failure of failures) console.error(`page: wrong: ${failure}`);
if (pages.length === 0) {
  console.error("page: no page was given");
  process.exit(2);
}
process.exit(failures.length > 0 ? 1 : 0);
