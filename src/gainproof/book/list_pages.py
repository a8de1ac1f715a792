"""Pages that lead to others: the front page, lists, bibliography, names, search."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.book import derivation_pages, kernel_pages, source_pages
from gainproof.book.page import Page
from gainproof.subjects.derived import Derived
from gainproof.verdicts.verdict_snapshot import Judgement, tally


def list_pages(
    subjects: Sequence[Derived], judgements: Sequence[Judgement], versions: Mapping[str, str]
) -> list[Page]:
    """All of them. `versions`: what the site is made with."""
    return [
        front(subjects, judgements, versions),
        derivations(subjects),
        sources(judgements),
        kernels(subjects),
        bibliography(subjects, judgements),
        names(subjects),
        Page("search.html", "Search", "list", "search.html", {}),
    ]


def front(
    subjects: Sequence[Derived], judgements: Sequence[Judgement], versions: Mapping[str, str]
) -> Page:
    """The first page: what there is, and how much of it is proved."""
    return Page(
        path="index.html",
        title="gainproof",
        kind="list",
        template="front.html",
        data={
            "subjects": len(subjects),
            "steps": sum(len(subject.steps) for subject in subjects),
            "kernels": sum(len(subject.kernels) for subject in subjects),
            "sources": len(judgements),
            "tally": tally(list(judgements)),
            "versions": versions,
        },
    )


def derivations(subjects: Sequence[Derived]) -> Page:
    """The list of derivations."""
    rows = [(d.title, derivation_pages.address(d.name), len(d.steps)) for d in subjects]
    return Page("derivations/index.html", "Derivations", "list", "derivations.html", {"rows": rows})


def sources(judgements: Sequence[Judgement]) -> Page:
    """The list of judged sources with their verdicts."""
    rows = [
        (each["source"], source_pages.address(each["source"]["key"]), tally([each]))
        for each in judgements
    ]
    return Page("sources/index.html", "Sources", "list", "sources.html", {"rows": rows})


def kernels(subjects: Sequence[Derived]) -> Page:
    """The list of kernels by subject."""
    rows = [(d.title, kernel_pages.links(d)) for d in subjects if d.kernels]
    return Page("kernels/index.html", "Kernels", "list", "kernels.html", {"rows": rows})


def bibliography(subjects: Sequence[Derived], judgements: Sequence[Judgement]) -> Page:
    """Works that derivations rest on, and the sources that are judged."""
    works: dict[str, dict[str, Any]] = {}
    for subject in subjects:
        for work in subject.sources:
            entry = works.setdefault(work["key"], {**work, "users": []})
            entry["users"].append((subject.title, derivation_pages.address(subject.name)))
    judged = [(each["source"], source_pages.address(each["source"]["key"])) for each in judgements]
    return Page(
        "bibliography.html",
        "Bibliography",
        "list",
        "bibliography.html",
        {"works": [works[key] for key in sorted(works)], "judged": judged},
    )


def names(subjects: Sequence[Derived]) -> Page:
    """Derivations, symbols and kernels by the alphabet."""
    entries: dict[str, set[tuple[str, str]]] = defaultdict(set)
    for subject in subjects:
        page = derivation_pages.address(subject.name)
        entries[subject.title].add((subject.name, page))
        for symbol in subject.symbols:
            entries[symbol.replace("_", " ")].add((subject.name, page))
        for kernel in subject.kernels:
            where = kernel_pages.address(kernel["module"], kernel["name"])
            entries[kernel["name"].replace("_", " ")].add((kernel["module"], where))
    letters: dict[str, list[tuple[str, list[tuple[str, str]]]]] = defaultdict(list)
    for name in sorted(entries, key=str.casefold):
        letters[name[0].upper()].append((name, sorted(entries[name])))
    return Page("names.html", "Index", "list", "names.html", {"letters": dict(letters)})
