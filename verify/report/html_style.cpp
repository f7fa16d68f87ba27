#include "verify/report/html.hpp"

namespace goishi::verify::page {

namespace {

// No "<" and no "&": in XHTML the sheet is text like any other.
constexpr std::string_view sheet = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c2026; --soft: #5c6570; --line: #dde1e6;
  --tint: #f5f6f8; --good: #14733f; --bad: #b3211f; --good-tint: #e9f5ee; --bad-tint: #fcebea;
  --link: #1d55b0; --track: #dfe3e8; --fill: #6b7f99; }
@media screen and (prefers-color-scheme: dark) { :root { --paper: #14171c; --ink: #e4e7eb;
  --soft: #9aa4b0; --line: #2c323a; --tint: #1c2027; --good: #5fc98f; --bad: #ff8a80;
  --good-tint: #16281f; --bad-tint: #351b1b; --link: #8ab4f8; --track: #2e343d; --fill: #8b9bb0; } }
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body { margin: 0 auto; padding: 2rem 1.5rem 5rem; max-width: 70rem; background: var(--paper);
  color: var(--ink); font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue",
  Arial, sans-serif; overflow-wrap: break-word; }
a { color: var(--link); text-decoration: none; }
a:hover, a:focus { text-decoration: underline; }
code { font: 0.875em/1.45 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace;
  white-space: pre-wrap; overflow-wrap: anywhere; }
sup { font-size: 0.72em; line-height: 0; }
h1 { margin: 0; font-size: 1.75rem; line-height: 1.2; letter-spacing: -0.01em; }
h1 span { display: block; color: var(--soft); font-size: 1rem; font-weight: 400; letter-spacing: 0; }
h2 { margin: 2.75rem 0 0.75rem; font-size: 1.25rem; line-height: 1.3; }
h3 { margin: 0; font-size: 1rem; }
h4 { margin: 1rem 0 0.3rem; font-size: 0.9375rem; }
.emblem { float: left; margin: 0.1rem 1rem 0 0; }
.shell { fill: #ffffff; }
.slate { fill: #101216; }
.heard { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.good { color: var(--good); }
.bad { color: var(--bad); }
.mark { font-weight: 700; }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.unit, .family, .reason { color: var(--soft); }
.verdict { clear: both; margin: 1.5rem 0 0; padding: 0.8rem 1.1rem; border-radius: 0.5rem;
  font-size: 1.375rem; font-weight: 600; line-height: 1.3; }
.verdict.good { background: var(--good-tint); }
.verdict.bad { background: var(--bad-tint); }
.failures { margin: 0.75rem 0 0; padding: 0 0 0 1.1rem; list-style: none; }
.failures a { font-weight: 600; margin-right: 0.5em; }
.stamp { display: flex; flex-wrap: wrap; gap: 0.6rem 2.25rem; margin: 1.25rem 0 0; padding: 0;
  font-size: 0.875rem; list-style: none; overflow-wrap: anywhere; }
.stamp span { display: block; color: var(--soft); }
.how p { margin: 0 0 0.5rem; max-width: 52rem; color: var(--soft); }
.how b { color: var(--ink); font-weight: 600; }

.overview { width: 100%; border-collapse: collapse; font-size: 0.9375rem; line-height: 1.4; }
.overview td, .overview th { padding: 0.45rem 0.6rem; border-bottom: 1px solid var(--line);
  text-align: left; vertical-align: baseline; }
.overview .number { text-align: right; }
.overview thead th { color: var(--soft); font-size: 0.8125rem; font-weight: 500; }
.overview .group th { padding-top: 1.4rem; font-weight: 600; border-bottom: 1px solid var(--soft); }
.overview .group span { float: right; color: var(--soft); font-size: 0.8125rem; font-weight: 400; }
.overview tbody th { font-weight: 500; white-space: nowrap; }
.overview .verdict-mark { width: 1.5rem; padding-right: 0; }
.overview .unit { display: block; font-size: 0.8125rem; white-space: normal; }
.overview .bar { display: block; margin: 0.2rem 0 0 auto; }
.overview .time, .overview .check { color: var(--soft); }
.overview tr.failed { background: var(--bad-tint); }
.bar { vertical-align: middle; margin-left: 0.5em; }
.bar .track { fill: var(--track); }
.bar .fill { fill: var(--fill); }
.bar.bad .fill { fill: var(--bad); }

.claim { margin: 0 0 1.25rem; padding: 1rem 1.25rem 1.15rem; border: 1px solid var(--line);
  border-radius: 0.5rem; }
.claim:target { border-color: var(--link); box-shadow: 0 0 0 1px var(--link); }
.claim .up { float: right; font-size: 0.8125rem; font-weight: 400; }
.claim .statement { margin: 0.25rem 0 0.9rem; font-size: 1.0625rem; line-height: 1.45; }
.facts { display: grid; grid-template-columns: 7.5rem minmax(0, 1fr); gap: 0.3rem 1rem; margin: 0;
  font-size: 0.9375rem; }
.facts dt { color: var(--soft); }
.facts dd { margin: 0; }
.facts .unit { color: inherit; }
.family { margin-left: 0.4em; padding: 0.05em 0.55em; border: 1px solid var(--line);
  border-radius: 1em; font-size: 0.8125rem; white-space: nowrap; }
.claim table { margin: 1rem 0 0; border-collapse: collapse; font-size: 0.9375rem; }
.claim caption { padding-bottom: 0.2rem; color: var(--soft); text-align: left; }
.claim td, .claim tbody th { padding: 0.25rem 0; border-top: 1px solid var(--line); text-align: left;
  vertical-align: baseline; font-weight: 400; }
.claim tbody th { padding-right: 1.5rem; }
.figures td { font-variant-numeric: tabular-nums; }
.plots { display: flex; flex-wrap: wrap; gap: 1rem; margin-top: 1rem; }
figure { margin: 0 0 0 -10px; max-width: 100%; }
.plot { display: block; max-width: 100%; height: auto; }
.study h3 { margin: 2rem 0 0.5rem; }
.study p { margin: 0 0 0.75rem; max-width: 52rem; color: var(--soft); }
.study figure { margin-top: 1rem; }
.scroll { overflow-x: auto; }
.plain { border-collapse: collapse; font-size: 0.875rem; line-height: 1.4; }
.plain caption { padding-bottom: 0.2rem; color: var(--soft); text-align: left; }
.plain th, .plain td { padding: 0.2rem 1.25rem 0.2rem 0; border-top: 1px solid var(--line); text-align: left;
  vertical-align: baseline; font-weight: 400; font-variant-numeric: tabular-nums; }
.plain thead th { border: 0; color: var(--soft); font-size: 0.8125rem; }

@media screen and (max-width: 54rem) {
  body { padding: 1.25rem 0.9rem 3rem; }
  .overview thead { display: none; }
  .overview, .overview tbody { display: block; }
  .overview tr { display: grid; grid-template-columns: 1.4rem repeat(4, minmax(0, 1fr)); padding: 0.5rem 0;
    border-bottom: 1px solid var(--line); gap: 0.2rem 0.5rem; }
  .overview td, .overview tbody th { padding: 0; border: 0; text-align: left; }
  .overview tbody th { grid-column: 2 / -1; }
  .overview .group th { grid-column: 1 / -1; padding-top: 1rem; border: 0; white-space: normal; }
  .overview .statement { grid-column: 2 / -1; }
  .overview td.number { text-align: left; font-size: 0.8125rem; white-space: normal; }
  .overview td.number::before { content: attr(data-label); display: block; color: var(--soft); }
  .overview td.number:nth-of-type(3) { grid-column: 2; }
  .overview .unit { display: inline; }
  .overview .bar { margin-left: 0; max-width: 100%; }
  .facts { grid-template-columns: minmax(0, 1fr); gap: 0; }
  .facts dd { margin-bottom: 0.45rem; }
}
@media print {
  html { font-size: 11px; }
  body { max-width: none; padding: 0; }
  h2 { margin-top: 1.75rem; }
  .plot { width: 34rem; }
  .up { display: none; }
  .claim, figure, tr { break-inside: avoid; }
  h2, h3, .group { break-after: avoid; }
  .bar, .verdict, tr.failed { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace

std::string_view style() {
  return sheet.substr(1);
}

}  // namespace goishi::verify::page
