// Looks at pages of results in a headless browser: node look.mjs BROWSER PAGE.html FOLDER
// Plots are drawn, answer the mouse, can be zoomed and played; nothing is asked of a server; nothing is wider than the
// paper; the numbers of a plot are those of its table.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [, , browserPath, pagePath, folder] = process.argv;
const faults = [];
const expect = (holds, what) => { if (!holds) faults.push(what); };

const browser = await chromium.launch({ executablePath: browserPath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
page.on("console", (said) => { if (said.type() === "error") faults.push(`console: ${said.text()}`); });
page.on("pageerror", (error) => faults.push(`script: ${error.message}`));
page.on("request", (request) => {
  if (!request.url().startsWith("file:") && !request.url().startsWith("data:") && !request.url().startsWith("blob:")) {
    faults.push(`a request leaves the page: ${request.url()}`);
  }
});
// The processor time of the thread that draws: a crowded machine fails no page.
const session = await page.context().newCDPSession(page);
await session.send("Performance.enable", { timeDomain: "threadTicks" });
await page.goto(`${pathToFileURL(pagePath)}#all`, { waitUntil: "load", timeout: 120000 });
const opened = 1000 * (await session.send("Performance.getMetrics")).metrics.find((m) => m.name === "TaskDuration").value;
const figures = await page.$$("figure[data-plot]");
const drawn = await page.$$("figure.drawn .js-plotly-plot .main-svg");
expect(figures.length > 0, "no figure");
expect(drawn.length >= figures.length, `${figures.length} figures, ${drawn.length} drawn`);
expect(opened > 0 && opened < 5000, `all figures drawn in ${opened} ms of processor time`);

// What a plot shows is what the file of its table holds, number by number.
const summary = JSON.parse(readFileSync(`${folder}/summary.json`, "utf8"));
const columnsOf = (file) => {
  const [head, ...rows] = readFileSync(`${folder}/${file}`, "utf8").trim().split("\n").map((row) => row.split(","));
  return Object.fromEntries(head.map((name, i) => [name, rows.map((row) => Number(row[i]))]));
};
const plots = await page.evaluate(() => JSON.parse(document.getElementById("plots").textContent));
let compared = 0;
for (const plot of plots) {
  const figure = summary.figures.find((f) => f.name === plot.name);
  if (figure.series.length > 0 || !["line", "points"].includes(figure.kind) || plot.lines.length !== 1) continue;
  const columns = columnsOf(figure.table);
  const inside = (x) => !figure.x_range || (x >= figure.x_range[0] && x <= figure.x_range[1]);
  const rows = columns[figure.x].map((x, i) => [x, columns[figure.y[0]][i]]).filter(([x]) => inside(x));
  const shown = plot.lines[0].x.map((x, i) => [x, plot.lines[0].y[i]]);
  expect(JSON.stringify(rows) === JSON.stringify(shown), `${plot.name} does not show what ${figure.table} holds`);
  const drawnY = await page.evaluate((i) => {
    const place = document.querySelector(`figure[data-plot="${i}"] .live`);
    return [...place.data[0].y];
  }, plots.indexOf(plot));
  expect(drawnY.every((y, i) => Math.abs(y * plot.y.factor - rows[i][1]) <= 1e-12 * Math.abs(rows[i][1])),
         `${plot.name} is drawn with other numbers`);
  ++compared;
}
expect(compared >= 3, `only ${compared} plots could be compared with their tables`);

// What needs no script: which wires slip where, and the cross-section.
const slip = plots.filter((plot) => ["slip_map", "wire_map"].includes(plot.name));
expect(slip.length === 2, "no map of slip");
const wires = await page.$$eval("figure:not([data-plot]) svg.plot circle", (circles) => circles.map((c) => c.getAttribute("fill")));
const section = columnsOf("cross_section.csv");
expect(wires.length === section.wire.length, `${wires.length} wires are drawn, the strand has ${section.wire.length}`);
expect(wires.every((fill, i) => (fill !== "none") === section.slipping_share[i] > 0), "a wire is drawn in another state");

// The mouse: a label, a zoom, the way back.
const first = await page.$("figure[data-plot] .live .nsewdrag");
await first.scrollIntoViewIfNeeded();
const box = await first.boundingBox();
await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.5);
for (let i = 0; i <= 40; ++i) await page.mouse.move(box.x + (box.width * i) / 40, box.y + box.height * (0.1 + 0.02 * i));
const axis = () => page.evaluate(() => [...document.querySelector("figure[data-plot] .live").layout.xaxis.range]);
const hovered = await page.evaluate(async () => {
  const place = document.querySelector("figure[data-plot] .live");
  Plotly.Fx.hover(place, [{ curveNumber: 0, pointNumber: 0 }]);
  await new Promise((done) => setTimeout(done, 200));
  return place.querySelectorAll(".hoverlayer .hovertext").length;
});
expect(hovered > 0, "no label at a point");
const before = await axis();
await page.mouse.move(box.x + box.width * 0.3, box.y + box.height * 0.3);
await page.mouse.down();
await page.mouse.move(box.x + box.width * 0.7, box.y + box.height * 0.7, { steps: 8 });
await page.mouse.up();
await new Promise((done) => setTimeout(done, 500));
const after = await axis();
expect(after[1] - after[0] < 0.8 * (before[1] - before[0]), `no zoom: ${before} to ${after}`);

// A figure that moves.
const moving = plots.findIndex((plot) => plot.moves);
if (moving >= 0) {
  const frame = () => page.evaluate((i) => document.querySelector(`figure[data-plot="${i}"] .live`).data[0].y[5], moving);
  await new Promise((done) => setTimeout(done, 300));
  const still = await frame();
  await page.evaluate((i) => document.querySelector(`figure[data-plot="${i}"] .updatemenu-button`).dispatchEvent(
    new MouseEvent("click", { bubbles: true })), moving);
  const seen = new Set([still]);
  for (let i = 0; i < 12; ++i) {
    await new Promise((done) => setTimeout(done, 80));
    seen.add(await frame());
  }
  expect(seen.size > 2, "the animation stands still");
}

// On paper: A4, the figures that need no script, nothing wider than the sheet.
await page.emulateMedia({ media: "print" });
await page.setViewportSize({ width: 718, height: 1000 });
const wide = await page.evaluate(() => document.documentElement.scrollWidth);
expect(wide <= 718, `printed ${wide} px wide where the paper has 718`);
const printed = await page.evaluate(() => [...document.querySelectorAll("figure[data-plot]")].every(
  (f) => getComputedStyle(f.querySelector("svg.plot")).display !== "none" &&
         getComputedStyle(f.querySelector(".live")).display === "none"));
expect(printed, "on paper the scripts' drawings stand where the figures belong");

await browser.close();
for (const fault of faults) console.log(`FAILED: ${fault}`);
console.log(`${figures.length} figures, ${compared} compared with their tables, all drawn in ${opened.toFixed(0)} ms of processor time`);
process.exit(faults.length > 0 ? 1 : 0);
