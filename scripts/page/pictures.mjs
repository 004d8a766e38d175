// Writes the first screen of a page as WebP files: pictures.mjs CHROMIUM PAGE FOLDER.
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const [executablePath, page, folder] = process.argv.slice(2);
const SCREENS = [
  { name: "page-desktop", scheme: "light", width: 1000, height: 1500 },
  { name: "page-phone", scheme: "dark", width: 360, height: 780 },
];

const browser = await puppeteer.launch({ executablePath, args: ["--no-sandbox"] });
for (const { name, scheme, width, height } of SCREENS) {
  const tab = await browser.newPage();
  await tab.setViewport({ width, height });
  await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  await tab.goto(pathToFileURL(page).href);
  await tab.screenshot({ path: `${folder}/${name}.webp`, type: "webp", quality: 75 });
}
await browser.close();
