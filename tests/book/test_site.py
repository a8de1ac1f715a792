"""The site: whole, linked, written only into a folder of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from browser import needs_browser, of_changed_pages, opened, serious_findings
from page_faults import KEPT, empty_alike, page_faults

from gainproof.bad_input import BadInputError
from gainproof.book import making, site, site_links
from gainproof.book.contents import Contents
from gainproof.book.document_pages import slug
from gainproof.book.sampled_kernel import sampled
from gainproof.claims import judgements
from gainproof.claims.source_words import claims_said
from gainproof.jobs.session import open_session
from gainproof.subjects import derivations

SOURCE = r"""
format = "gainproof claims 1"

[source]
key = "notes"
title = "Notes on a filter"
authors = ["A. Reader"]
publication = "unpublished"
url = "https://example.org/notes"

[symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "position gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "velocity gain" }

[settings.velocity]
title = "random velocity"
kind = "steady_state"
model = "random-velocity"
gain = "filter"

[[claims]]
id = "1"
place = "equation (1)"
kind = "identity"
setting = "velocity"
latex = '\beta = \frac{\alpha^2}{2 - \alpha}'

[[claims]]
id = "2"
place = "equation (2)"
kind = "identity"
setting = "velocity"
latex = '\beta = \frac{\alpha^2}{2 + \alpha}'

[[claims]]
id = "word"
place = "page 3"
kind = "inequality"
setting = "velocity"
latex = '\alpha > 1'
text = "It follows its measurements closely."
note = "No number is given."

[[claims]]
id = "more"
place = "page 4"
origin = "ours"
kind = "inequality"
setting = "velocity"
latex = '\beta > 1'
"""
"""True and false: a source of its own takes a tenth of the time that one of the repository does."""


@pytest.fixture(scope="module")
def files(all_derived: object, tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """A site of one family and one source; the documentation is whole."""
    del all_derived
    session = open_session(quiet=True)
    subject = derivations.known("random-velocity", session)
    file = tmp_path_factory.mktemp("source") / "notes.toml"
    file.write_text(SOURCE, encoding="utf-8")
    kernel = subject.kernels[0]
    contents = Contents(
        versions={"SymPy": "1"},
        subjects=[subject],
        reports=[derivations.own_report(subject, session)],
        judgements=judgements.judge([file], session),
        said=[claims_said(judgements.read(file))],
        checked=[{}],
        sampled={"random_velocity.gains": sampled("random_velocity", kernel, kernel["graph"])},
    )
    return site.files(making.pages(contents), making.scripts(contents), lambda _: None)


def test_no_link_is_broken(files: dict[str, bytes]) -> None:
    links, wrong = site_links.broken(files)
    assert not wrong
    assert links > 500


def test_broken_links_are_found(files: dict[str, bytes]) -> None:
    page = "derivations/random-velocity.html"
    spoiled = files[page].replace(b'id="step-velocity-gain"', b'id="elsewhere"')
    assert spoiled != files[page]
    _, wrong = site_links.broken({**files, page: spoiled})
    assert f"{page}: #step-velocity-gain" in wrong
    fewer = {path: content for path, content in files.items() if path != "names.html"}
    assert any("names.html" in link for link in site_links.broken(fewer)[1])


def test_every_step_has_the_checkers_word(files: dict[str, bytes]) -> None:
    text = files["derivations/random-velocity.html"].decode()
    assert "Certificate accepted" in text
    assert "not checked" not in text


def test_source_in_both_languages(files: dict[str, bytes]) -> None:
    assert '<html lang="en">' in files["sources/notes.html"].decode()
    japanese = files["sources/notes.ja.html"].decode()
    assert '<html lang="ja">' in japanese
    assert "証明済み" in japanese
    assert "https://" not in japanese.split("<main")[0]


def test_a_source_is_blamed_only_for_what_it_prints_or_says(files: dict[str, bytes]) -> None:
    text = files["sources/notes.html"].decode()
    errata, claims = text.split('id="errata"')[1].split('id="claims"')
    words, more = claims.split('id="claim-word"')[1].split('id="claim-more"')
    assert errata.count("As printed") == 1
    assert "page 2" in errata or "equation (2)" in errata
    assert "page 4" not in errata
    for part in (errata, words):
        said = part.index("In words: It follows its measurements closely.")
        assert said < part.index("Read as", said) < part.index("No number is given.", said)
    assert "As printed" not in words
    assert "Ours, not in the source" in more


def test_page_of_a_kernel(files: dict[str, bytes]) -> None:
    text = files["kernels/random_velocity.gains.html"].decode()
    assert "accurate: bool = False" in text
    assert "Relative error at most" in text
    assert text.count('class="chart"') == 2
    # formulas as mathematics with LaTeX to copy; the docstring once, not in the source again
    assert r"\kappa = \sqrt{4/\Lambda^{2} + 1/4}, \rho = \sqrt{\kappa + 1/2}" in text
    assert "<code>tracking_index</code>: " in text
    assert "2<sup>-52</sup>" in text
    assert text.count("Steady-state filter gain.") == 1
    # a sentence that has a colon after a word at the start of a line is not cut there
    assert "<p>number: it comes as 0" not in text


def test_nothing_is_loaded_from_elsewhere(files: dict[str, bytes]) -> None:
    for path, content in files.items():
        if path.endswith((".html", ".css", ".js")):
            assert b'src="http' not in content, path
            assert b"url(http" not in content, path
            assert b"@import" not in content, path


@needs_browser
@of_changed_pages
@pytest.mark.parametrize(
    "findings",
    [
        pytest.param(lambda _: (), id="console-and-width"),
        pytest.param(serious_findings, id="axe", marks=pytest.mark.thorough),
    ],
)
def test_a_page_of_each_kind_is_without_fault(
    files: dict[str, bytes], tmp_path: Path, findings: Callable[[object], Sequence[str]]
) -> None:
    """A small `tests/campaigns/book_pages.py`."""
    folder = tmp_path / "book"
    site.write(files, folder)
    kinds = {str(Path(path).parent): path for path in sorted(files) if path.endswith(".html")}
    assert len(kinds) >= 5
    paths = [*kinds.values(), "derivations/random-velocity.html", "bibliography.html"]
    with opened() as browser:
        seen = dict(page_faults(browser, [folder / path for path in paths], findings))
    assert seen == {folder / path: [] for path in paths}


@needs_browser
@of_changed_pages
def test_faults_of_a_page_are_found(files: dict[str, bytes], tmp_path: Path) -> None:
    folder = tmp_path / "book"
    site.write(files, folder)
    page = folder / "bibliography.html"
    spoiled = """<main id="content" style="width: 500px"><img src="none.png">
        <p style="color: #ccc; background: #fff">faint where it is light</p>
        <p style="color: #333; background: #12161c">faint where it is dark</p>
        <script>console.error("planted")</script>"""
    text = page.read_text(encoding="utf-8")
    assert text.count('<main id="content" tabindex="-1">') == 1
    page.write_text(text.replace('<main id="content" tabindex="-1">', spoiled), encoding="utf-8")
    with opened() as browser:
        ((_, faults),) = page_faults(browser, [page])
    told = "\n".join(faults)
    for wanted in ("light: image-alt", "dark: color-contrast", "console: planted", "pixels wide"):
        assert wanted in told


@needs_browser
@of_changed_pages
def test_a_formula_of_another_colour_is_seen_after_many(tmp_path: Path) -> None:
    """Of formulas that look alike the first are seen, and each that does not."""
    formula = "<math><mi>sin</mi><mo>+</mo><mi>y</mi></math>"
    page = tmp_path / "page.html"
    with opened() as browser:
        for style, faults in (("color: #222", 0), ("color: #ccc", 2)):
            page.write_text(
                '<!doctype html><html lang="en"><head><title>t</title></head><body><main><h1>h</h1>'
                f'<p style="background: #fff; color: #000">{formula * 9} and</p>'
                f'<p style="background: #fff; {style}">{formula}</p></main></body></html>',
                encoding="utf-8",
            )
            ((_, found),) = page_faults(browser, [page])
            tab = browser.new_page()
            tab.goto(page.as_uri())
            assert empty_alike(tab) == 9 - KEPT
            assert len([each for each in found if "color-contrast" in each]) == faults, found


@needs_browser
@of_changed_pages
def test_the_search_finds(files: dict[str, bytes], tmp_path: Path) -> None:
    """From the field of any page: the form leads to the page that searches."""
    folder = tmp_path / "book"
    site.write(files, folder)
    with opened() as browser:
        tab = browser.new_page()
        tab.goto((folder / "derivations/random-velocity.html").as_uri())
        tab.fill(".search input", "gains_with_derivatives")
        tab.press(".search input", "Enter")
        tab.wait_for_selector("#results a")
        assert tab.input_value(".search input") == "gains_with_derivatives"
        found = tab.locator("#results a").first
        assert found.text_content() == "random_velocity.gains_with_derivatives"
        found.click()
        tab.wait_for_selector("article.kernel")
        tab.goto(f"{(folder / 'search.html').as_uri()}?q=no-such-word-anywhere")
        assert tab.text_content("#found") == "0 found"


def test_written_twice_it_is_the_same(files: dict[str, bytes], tmp_path: Path) -> None:
    folder = tmp_path / "book"
    site.write(files, folder)
    times = {path: (folder / path).stat().st_mtime_ns for path in files if path != site.MARK}
    fewer = {path: content for path, content in files.items() if path != "search.html"}
    site.write(fewer, folder)
    assert not (folder / "search.html").exists()
    left = {path: (folder / path).stat().st_mtime_ns for path in fewer if path != site.MARK}
    assert left == {path: times[path] for path in left}


def test_a_folder_of_others_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(BadInputError, match="holds other things"):
        site.write({"index.html": b""}, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
    with pytest.raises(BadInputError, match="a folder is wanted"):
        site.require_own(tmp_path / "mine.txt")


def test_an_altered_list_removes_nothing_outside(tmp_path: Path) -> None:
    (tmp_path / "precious").write_text("mine")
    folder = tmp_path / "book"
    site.write({site.MARK: b"", "index.html": b"a"}, folder)
    with (folder / site.MARK).open("a") as stream:
        stream.write("../precious\n")
    for write in (site.require_own, lambda found: site.write({"index.html": b"b"}, found)):
        with pytest.raises(BadInputError, match="would lie outside of it"):
            write(folder)
    assert (tmp_path / "precious").read_text() == "mine"
    assert (folder / "index.html").read_bytes() == b"a"


@pytest.mark.parametrize("path", ["../x.html", "sources/../../x.html", "/tmp/x.html"])
def test_a_page_elsewhere_is_not_written(path: str, tmp_path: Path) -> None:
    folder = tmp_path / "book"
    with pytest.raises(BadInputError, match="would lie outside of it"):
        site.write({site.MARK: b"", "index.html": b"a", path: b"b"}, folder)
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("link", ["sources", "sources/s.html", site.MARK])
def test_links_in_an_old_book_are_not_followed(link: str, tmp_path: Path) -> None:
    """Not by what is renewed, nor by what is removed."""
    folder, other = tmp_path / "book", tmp_path / "other"
    site.write({site.MARK: b"", "index.html": b"a", "sources/s.html": b"a"}, folder)
    (folder / link).rename(other)
    (folder / link).symlink_to(other)
    before = other.read_bytes() if other.is_file() else (other / "s.html").read_bytes()
    for files in ({"index.html": b"b"}, {"index.html": b"b", "sources/s.html": b"b"}):
        with pytest.raises(BadInputError, match=f"{link} in it is a link"):
            site.write({site.MARK: b"", **files}, folder)
        with pytest.raises(BadInputError, match=f"{link} in it is a link"):
            site.require_own(folder)
    after = other.read_bytes() if other.is_file() else (other / "s.html").read_bytes()
    assert after == before
    assert (folder / "index.html").read_bytes() == b"a"


@pytest.mark.parametrize(
    ("title", "anchor"),
    [("[settings.NAME]", "settingsname"), ("What it answers", "what-it-answers")],
)
def test_anchors_of_headings(title: str, anchor: str) -> None:
    assert slug(title) == anchor
