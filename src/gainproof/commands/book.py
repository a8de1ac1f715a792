"""`gainproof book`: derivations, sources, kernels and documentation as a site to read."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from gainproof.jobs.session import Session

HELP = "make the book: a site of all derivations, sources and kernels"
DESCRIPTION = """\
Writes a static site that works from a folder without network: a page for each derivation, step by
step with the checker's word; for each source with its claims, verdicts and errata; for each kernel;
and the documentation. Needs the extra: pip install 'gainproof[book]'.

With --exercises N the site has N sheets too: stretches of derivations, each with one planted error
that has an exact counterexample while the checker accepts every other step; the reader marks a line
and sees the witness. The same seed gives the same sheets. The key lies apart: answers.html and
answers.json in DIR. --notebooks writes sheets and key as notebooks too; that needs the extra:
pip install 'gainproof[notebook]'.

The page "Check a formula" runs the judge in the reader's browser. It needs 15 MB of WebAssembly,
which --runtime fetches from the npm and Python registries by npm and pip, once; a book without
says so there. --page check makes a folder with that page alone. Any web server serves it.

DIR is a new or empty folder, or a book made before, which is renewed. Exit status 1 where a
certificate or the proof of a claim is rejected, or a link leads nowhere."""
MOST_SHEETS = 200


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", metavar="DIR", help="default: book, or check for that page alone")
    parser.add_argument("--page", choices=["check"], help="the page that checks formulas, alone")
    parser.add_argument("--runtime", action="store_true", help="with what that page runs on")
    parser.add_argument("--open", action="store_true", help="show it in the browser")
    parser.add_argument(
        "--exercises", metavar="N", type=int, help="with N sheets that have an error each"
    )
    parser.add_argument("--seed", metavar="S", type=int, default=1, help="of the sheets; default 1")
    parser.add_argument("--notebooks", action="store_true", help="the sheets as notebooks too")
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0 if every certificate and every proof of a claim is accepted and every link leads somewhere,
    else 1.
    """
    from importlib.util import find_spec
    from pathlib import Path

    from gainproof.bad_input import BadInputError
    from gainproof.files import places
    from gainproof.jobs.session import open_session

    if options.exercises is not None and not 1 <= options.exercises <= MOST_SHEETS:
        raise BadInputError(
            f"--exercises: a number from 1 to {MOST_SHEETS} is wanted, got {options.exercises}"
        )
    if options.page and options.exercises is not None:
        raise BadInputError("--page check is that page alone: not with --exercises")
    if options.notebooks:
        from gainproof.notebook.cells import require_nbformat

        if options.exercises is None:
            raise BadInputError("--notebooks: it is the sheets of --exercises N that become them")
        require_nbformat()
    for name in ("jinja2", "latex2mathml", "markdown_it", "pygments"):
        if find_spec(name) is None:
            raise BadInputError(f"{name} is missing: pip install 'gainproof[book]'")
    from gainproof.book import check_page, check_runtime, contents, making, site

    folder = Path(options.out or options.page or "book")
    site.require_own(folder)
    places.require_writable(folder)
    runtime = check_runtime.runtime() if options.page or options.runtime else {}
    session = open_session(fresh=options.fresh)
    if options.page:
        return _written(check_page.write(runtime, folder), folder, session, show=options.open)
    found = contents.gather(session)
    more = None
    if options.exercises is not None:
        from gainproof.book.exercises.making_sheets import exercises

        more = exercises(
            found.subjects,
            options.exercises,
            options.seed,
            session,
            notebooks=options.notebooks,
        )
    made = making.build(found, folder, session.progress.say_sometimes, more, runtime)
    accepted = all(report["accepted"] for report in found.reports)
    replayed = all(good for each in found.checked for good, _ in each.values())
    status = _written(made, folder, session, show=options.open)
    return status if accepted and replayed else 1


def _written(made: Mapping[str, bytes], folder: Path, session: Session, *, show: bool) -> int:
    """Say what was written, and show it if wanted: 0 if every link leads somewhere, else 1."""
    from gainproof.book import site_links
    from gainproof.files import places

    pages = sum(path.endswith(".html") for path in made)
    size = sum(map(len, made.values())) / 1e6
    print(f"{pages} pages, {len(made)} files, {size:.1f} MB ({session.progress.elapsed():.1f} s)")
    links, wrong = site_links.broken(made)
    print(f"{links} links within it, {len(wrong)} broken")
    for link in wrong:
        print(f"  {link}")
    print(f"{places.shown(folder)}/index.html")
    if "static/check.js" in made:
        serve = f"python3 -m http.server -d {places.shown(folder)}"
        print(f"the page that checks formulas needs a web server: {serve}")
    if show:
        import webbrowser

        webbrowser.open((folder / "index.html").resolve().as_uri())
    return 1 if wrong else 0
