"""The style sheet of the page of `gainproof bench`: light and dark, phones, print."""

STYLE = """\
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #ffffff; --soft: #57606a;
  --rule: #d0d7de; --band: #f3f5f7; --dot: #0b5cad; --median: #b35900; --alarm: #b00020;
  --alarm-paper: #fdecee; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ec; --paper: #14181c; --soft: #a3adb8;
  --rule: #3a424b; --band: #1e242a; --dot: #6cb2ff; --median: #ffb45e; --alarm: #ff9aa5;
  --alarm-paper: #3d1418; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 90rem; background: var(--paper);
  color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: .5rem 0; }
h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
p, dl { max-width: 46rem; }
p.alarm { border: 2px solid var(--alarm); background: var(--alarm-paper); color: var(--ink);
  padding: .75rem 1rem; max-width: none; overflow-wrap: anywhere; }
p.alarm strong { color: var(--alarm); }
.box { overflow: auto; border: 1px solid var(--rule); border-radius: 6px; }
.box:focus-visible { outline: 3px solid var(--dot); outline-offset: 2px; }
.tall { max-height: 90vh; }
.plots { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 34rem), 1fr)); }
figure { margin: 0; min-width: 0; }
figcaption { color: var(--soft); margin-top: .4rem; }
svg { display: block; width: 100%; min-width: 34rem; height: auto;
  font: 14px system-ui, sans-serif; }
svg text { fill: var(--ink); }
.grid { stroke: var(--rule); stroke-width: 1; }
.one { stroke: var(--soft); stroke-width: 1.5; stroke-dasharray: 5 4; }
.dot { fill: var(--dot); fill-opacity: .45; }
.outside { fill: var(--alarm); }
.median { stroke: var(--median); stroke-width: 3; }
table { border-collapse: separate; border-spacing: 0; width: 100%; font-size: .875rem;
  font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: .5rem .6rem; color: var(--soft); }
th, td { padding: .3rem .6rem; text-align: right; vertical-align: top; white-space: nowrap;
  border-top: 1px solid var(--rule); }
thead th { position: sticky; top: 0; background: var(--band); z-index: 2; border-top: 0;
  vertical-align: bottom; white-space: normal; min-width: 4.6rem; }
th[scope=row], thead th:first-child { position: sticky; left: 0; text-align: left;
  background: var(--paper); z-index: 1; font-weight: 500; }
thead th:first-child { z-index: 3; background: var(--band); }
tr.subject th { background: var(--band); text-align: left; }
tr.subject span { position: sticky; left: .6rem; }
td.words { text-align: left; }
td.domain { min-width: 27rem; white-space: normal; }
td.left { min-width: 20rem; white-space: normal; }
tr.alarm td, tr.alarm th[scope=row] { background: var(--alarm-paper); color: var(--alarm); }
dt { font-weight: 600; margin-top: .6rem; }
dd { margin: 0; color: var(--ink); }
code { font: .92em ui-monospace, monospace; overflow-wrap: anywhere; }
@media (max-width: 40rem) { body { padding: .75rem; } th[scope=row] { max-width: 9.5rem;
  min-width: 8rem; white-space: normal; } .tall { max-height: 80vh; } }
@media print { @page { size: A3 landscape; margin: 10mm; }
  :root { --ink: #000; --paper: #fff; --soft: #444; --rule: #bbb; --band: #eee; --dot: #0b5cad;
    --median: #b35900; --alarm: #b00020; --alarm-paper: #fff; }
  body { font-size: 9pt; max-width: none; padding: 0; } .box { overflow: visible; border: 0; }
  .tall { max-height: none; } table { font-size: 6.5pt; } th, td { padding: 1pt 3pt; }
  thead th { min-width: 0; } thead { display: table-header-group; }
  thead th, th[scope=row], thead th:first-child, tr.subject span { position: static; }
  td.domain, td.left { min-width: 0; } tr { break-inside: avoid; } svg { min-width: 0; } }
"""
