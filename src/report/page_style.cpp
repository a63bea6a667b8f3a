#include "strandyn/report/html.hpp"

namespace strandyn::report {

std::string_view page_style() {
  return R"css(:root {
  --paper: #fbfbfa; --card: #ffffff; --ink: #1b1f24; --muted: #616a75; --line: #e3e5e8; --accent: #1f6fc4;
  --good: #1a7f4b; --good-paper: #e4f4ea; --warn: #8a5a00; --warn-paper: #fff6e0; --warn-line: #e8b94a;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #121518; --card: #191d21; --ink: #e6e8eb; --muted: #98a1ac; --line: #2c3238; --accent: #6cb0f5;
    --good: #6fd39b; --good-paper: #16301f; --warn: #f0c463; --warn-paper: #2a2314; --warn-line: #8a6a1f;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", sans-serif;
}
main { max-width: 1120px; margin: 0 auto; padding: 48px 28px 72px; }
header { border-bottom: 1px solid var(--line); padding-bottom: 22px; }
.eyebrow { margin: 0 0 6px; color: var(--muted); font-size: 13px; letter-spacing: .02em; }
h1 { margin: 0; font-size: 30px; line-height: 1.2; font-weight: 650; letter-spacing: -.015em; text-wrap: balance; }
h2 { margin: 0 0 14px; font-size: 18px; font-weight: 650; letter-spacing: -.005em; }
h2::first-letter { text-transform: uppercase; }
h3 { margin: 0 0 8px; font-size: 14.5px; font-weight: 600; }
h4 { margin: 14px 0 6px; font-size: 13.5px; font-weight: 600; }
section { margin-top: 40px; }
.facts { list-style: none; margin: 12px 0 0; padding: 0; display: flex; flex-wrap: wrap; color: var(--muted); }
.facts li + li::before { content: "·"; margin: 0 9px; }
.status { margin-left: 8px; padding: 1px 9px; border-radius: 99px; font-weight: 600; font-size: 12px;
  color: var(--warn); background: var(--warn-paper); }
.status.good { color: var(--good); background: var(--good-paper); }
.unit { color: var(--muted); font-weight: 400; }
.note { margin: 8px 0 0; color: var(--muted); font-size: 13px; }
dl { margin: 0; } dt { color: var(--muted); }
dd { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
section > dl:not(.cards) { columns: 2; column-gap: 48px; font-size: 14px; orphans: 1; widows: 1; }
dl:not(.cards) > div {
  display: flex; justify-content: space-between; gap: 20px; padding: 5px 0; border-bottom: 1px solid var(--line);
  break-inside: avoid;
}
dl:not(.cards) dd { text-align: right; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(165px, 1fr)); gap: 12px; }
.cards > div, figure, .card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.cards > div { display: flex; flex-direction: column; justify-content: space-between; padding: 12px 14px 11px; break-inside: avoid; }
.cards dt { font-size: 13px; }
.cards dd { margin-top: 2px; white-space: nowrap; font-size: 21px; line-height: 1.3; font-weight: 600; letter-spacing: -.01em; }
.cards .unit { font-size: 14px; letter-spacing: 0; }
.findings p { margin: 0 0 8px; max-width: 80ch; font-size: 16px; }
.warnings { background: var(--warn-paper); border: 1px solid var(--warn-line); border-radius: 10px; padding: 15px 20px; }
.warnings h2 { font-size: 15px; margin-bottom: 6px; color: var(--warn); }
.warnings ul { margin: 0; padding-left: 18px; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 480px), 1fr)); gap: 16px; }
figure { margin: 0; padding: 18px 20px 14px; break-inside: avoid; }
figcaption { margin-top: 8px; color: var(--muted); font-size: 13px; line-height: 1.45; }
.plot { display: block; width: 100%; height: auto; }
.drawn .plot { display: none; }
.plot text { fill: var(--muted); font-family: inherit; font-size: 12.5px; }
.plot .tick { font-size: 12px; font-variant-numeric: tabular-nums; }
.plot .grid { stroke: var(--line); }
.plot .axis { stroke: var(--muted); stroke-opacity: .65; }
.plot .ink { stroke: var(--ink); }
.plot .ink-fill { fill: var(--ink); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
.narrow { width: auto; min-width: 300px; }
th, td { padding: 5px 0 5px 18px; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { padding-left: 0; }
th { font-weight: 600; vertical-align: bottom; border-bottom-color: var(--muted); }
th .unit { display: block; }
.words { text-align: left; white-space: normal; }
.cards-of-case { columns: 2; column-gap: 16px; margin-top: 16px; font-size: 13.5px; }
.card { padding: 14px 18px; margin-bottom: 16px; break-inside: avoid; }
.card dl > div:last-child { border-bottom: 0; }
.card h3, .card h4, .card dt { font-family: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.card h3 { color: var(--accent); font-size: 13.5px; }
.card dt, .card h4, .card th { font-size: 12.5px; }
@media (max-width: 720px) {
  main { padding: 28px 16px 48px; }
  h1 { font-size: 25px; }
  section > dl:not(.cards), .cards-of-case { columns: 1; }
}
@media print {
  .drawn .plot { display: block; }
  .live { display: none; }
  body { font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  section { margin-top: 22pt; }
  h2 { break-after: avoid; }
  .figures { grid-template-columns: 1fr 1fr; }
  .scroll { overflow: visible; }
  table { font-size: 7.5pt; table-layout: auto; }
  th, td { white-space: normal; overflow-wrap: anywhere; padding-left: 5px; }
  .narrow { min-width: 0; }
  tr { break-inside: avoid; }
}
)css";
}

}  // namespace strandyn::report
