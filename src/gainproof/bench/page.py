"""The page of `gainproof bench`: one HTML file, without script and without network."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape
from itertools import groupby
from statistics import median
from typing import Any

from gainproof.bench import plots
from gainproof.bench.columns import ERRORS, RATIOS, Column, Row, ratio_text, worst_output
from gainproof.bench.results import Results

ULPS = "worst, ulps"
HEADINGS = (
    *("proved, 2^-52", "worst, 2^-52", ULPS, "ns a point"),
    *(column.title for column in RATIOS),
    *("subtractions left", "domain"),
)
FURTHER = (
    ("ns a point", "nanoseconds of the kernel, outputs given, best of the runs"),
    *((f"{title}, 2^-52", meaning) for title, _, meaning in ERRORS),
    (
        ULPS,
        (
            "the greatest error met in units in the last place of the scale, each of which is "
            "between 2^-53 and 2^-52 of it"
        ),
    ),
    (
        "subtractions left",
        (
            "differences of computed values that may cancel, with the number by which errors of "
            "their sides may enter an output; or outputs of signed terms, bounded over their sum"
        ),
    ),
    ("domain", "the numbers that the kernel takes, in double precision, and what is asked of all"),
)


def page(results: Results) -> str:
    """The whole page. Nothing in it is taken from outside unescaped."""
    rows = results.rows
    return "\n".join(
        [
            "<!doctype html>",
            '<html lang="en">',
            '<head><meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>Kernels of gainproof, measured</title><style>{_STYLE}</style></head>",
            "<body><main>",
            "<h1>Kernels of gainproof, measured</h1>",
            *_alarm(results),
            *_opening(results),
            *_plots(rows),
            *_table(results),
            *_meanings(results),
            *_conditions(results),
            "</main></body></html>",
            "",
        ]
    )


def _alarm(results: Results) -> Iterator[str]:
    if results.outside:
        named = ", ".join(f"{kernel} ({output})" for kernel, output in results.outside)
        yield (
            '<p class="alarm" role="alert"><strong>Outside the proved bound:</strong> '
            f"{escape(named)}. The kernel, its bound or this measurement is wrong.</p>"
        )


def _opening(results: Results) -> Iterator[str]:
    rows, found = results.rows, results.conditions
    part = "" if results.complete else " so far; the run is not finished"
    kept = "" if results.outside else "; at no point was an error greater than is proved"
    errors = sum(len(row["errors"]) for row in rows)
    yield (
        f"<p>{len(rows)} kernels with {errors} outputs{part}{kept}. Every ratio is of two times "
        f"of one run, each the best of up to {found['rounds']} in turn for "
        f"{found['points']:,} points; of fewer where they take more than "
        f"{found['seconds a call']:g} s. Of what threads share (threads, JAX) it is the time that "
        "passes, of all else the processor time of the one thread, so that what else the machine "
        "does counts little.</p>"
    )
    speeds = ", ".join(f"{escape(name)} {value:.1f}" for name, value in results.bandwidth.items())
    yield f"<p>Memory, one thread, 128 MB: {speeds} GB/s.</p>"


def _plots(rows: Sequence[Row]) -> Iterator[str]:
    drawn = (
        ("Ratios of times", plots.ratios(rows), "A dot a kernel, bars are medians."),
        (
            "Errors and bounds",
            plots.errors(rows),
            "A dot a kernel; on the dashed line the greatest error met would be what is proved.",
        ),
    )
    if any(drawing for _, drawing, _ in drawn):
        yield '<h2>Plots</h2><div class="plots">'
        for title, drawing, caption in drawn:
            if drawing:
                yield (
                    f'<figure><div class="box" role="region" tabindex="0" aria-label="{title}">'
                    f"{drawing}</div><figcaption>{title}. {caption}</figcaption></figure>"
                )
        yield "</div>"


def _table(results: Results) -> Iterator[str]:
    yield '<h2>Every kernel</h2><div class="box tall" role="region" tabindex="0"'
    yield ' aria-label="Table of every kernel"><table>'
    yield "<caption>Kernel over C and memory: less is better. Others over kernel: more is better."
    yield "</caption>"
    titles = [escape(each).replace(" /", "&nbsp;/") for each in ("kernel", *HEADINGS)]
    heads = "".join(f'<th scope="col">{each}</th>' for each in titles)
    yield f"<thead><tr>{heads}</tr></thead>"
    if results.rows:
        yield f"<tbody>{_medians(results.rows)}</tbody>"
    for subject, rows in groupby(results.rows, key=lambda row: str(row["subject"])):
        yield '<tbody><tr class="subject">'
        columns = len(HEADINGS) + 1
        yield f'<th scope="rowgroup" colspan="{columns}"><span>{escape(subject)}</span></th>'
        yield "</tr>"
        yield from map(_row, rows)
        yield "</tbody>"
    yield "</table></div>"


def _medians(rows: Sequence[Row]) -> str:
    cells = []
    for column in RATIOS:
        values = [value for row in rows if (value := column.value(row)) is not None]
        cells.append(f"<td>{ratio_text(median(values)) if values else '–'}</td>")
    return (
        f'<tr><th scope="row">median of all</th><td colspan="4"></td>{"".join(cells)}'
        '<td colspan="2"></td></tr>'
    )


def _row(row: Row) -> str:
    worst = worst_output(row)
    kind = ' class="alarm"' if worst["outside"] else ""
    nanoseconds = float(row["seconds"]["kernel"]) * 1e3
    left = "<br>".join(map(escape, row["cancellations"])) or "none"
    domain = "<br>".join(map(escape, row["domain"]))
    return (
        f'<tr{kind}><th scope="row">{_broken(str(row["kernel"]))}</th>'
        f"<td>{float(worst['proved']):.2f}</td><td>{float(worst['worst']):.2f}</td>"
        f"<td>{float(worst['ulps']):.2f}</td><td>{nanoseconds:.1f}</td>"
        + "".join(_ratio(column, row) for column in RATIOS)
        + f'<td class="words left">{left}</td><td class="words domain">{domain}</td></tr>'
    )


def _broken(name: str) -> str:
    """A name that may break after its underscores, for narrow screens."""
    return escape(name).replace("_", "_<wbr>")


def _ratio(column: Column, row: Row) -> str:
    value = column.value(row)
    if value is not None:
        return f"<td>{ratio_text(value)}</td>"
    reasons = [
        row["missing"][name] for name in (column.over, column.under) if name in row["missing"]
    ]
    told = f' title="{escape(reasons[0])}"' if reasons else ""
    return f"<td{told}>–</td>"


def _meanings(results: Results) -> Iterator[str]:
    yield "<h2>Columns</h2><dl>"
    for title, meaning in (*((each.title, each.meaning) for each in RATIOS), *FURTHER):
        yield f"<dt>{escape(title)}</dt><dd>{escape(meaning)}</dd>"
    yield "</dl>"
    yield (
        "<p>lambdify, numexpr, Numba and JAX compute the textbook form, which loses digits where "
        "it cancels; where there is a dash a kernel has no such form, or it is missing:</p>"
    )
    missing = sorted(
        {(tool, reason) for row in results.rows for tool, reason in row["missing"].items()}
    )
    if missing:
        counted = [
            (tool, reason, sum(row["missing"].get(tool) == reason for row in results.rows))
            for tool, reason in missing
        ]
        yield "<ul>"
        for tool, reason, count in counted:
            yield f"<li>{escape(tool)}, {count} kernels: {escape(str(reason))}</li>"
        yield "</ul>"


def _conditions(results: Results) -> Iterator[str]:
    found: dict[str, Any] = dict(results.conditions)
    yield "<h2>Machine and versions</h2><dl>"
    for name, value in found["machine"].items():
        yield f"<dt>{escape(str(name))}</dt><dd><code>{escape(str(value))}</code></dd>"
    settings = found["settings"]
    constant = settings["constant"]
    yield f"<dt>threads where said</dt><dd>{settings['workers']}</dd>"
    if constant is not None:
        each = "one number" if settings["numbers"] == 1 else f"{settings['numbers']} numbers"
        yield f"<dt>{each} each</dt><dd>inputs named {escape(constant)}…</dd>"
    yield f"<dt>processes that wanted to run at the beginning</dt><dd>{results.load}</dd></dl>"


_STYLE = """\
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
