"""Play: sliders on the pages of the filter families, which move gains, poles and responses.

`derive/printer/javascript` prints the kernels, `book/static/play.*` moves and draws.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from gainproof.book.play.fragment import fragment
from gainproof.book.play.subjects import subject_of
from gainproof.files import places
from gainproof.subjects.derived import Derived

OWN = ("filter", "families", "drawing", "panels")
STYLE = "play.css"
"""The style sheet in `book/static` that a page with a play links."""


@dataclass(frozen=True)
class Play:
    """What a page needs for its play.

    `html` is a fragment, one `section`. `scripts` are names and texts of the classic scripts that
    the page loads, in this order; those of one name are the same on every page.
    """

    html: str
    scripts: tuple[tuple[str, str], ...]


def section(derived: Derived) -> Play | None:
    """The play of a derived subject; None for one that has nothing to be moved.

    OSError where a script that comes with the package cannot be read.
    """
    subject = subject_of(derived.name)
    if subject is None:
        return None
    static = Path(__file__).resolve().parents[1] / "static"
    printed = [("_runtime.js", "kernels.js"), *((name, name) for name in subject.scripts)]
    own = [*(f"play.{name}.js" for name in OWN), "play.js"]
    scripts = [(shown, _text(places.generated_folder() / name)) for name, shown in printed]
    scripts += [(name, _text(static / name)) for name in own]
    return Play(fragment(subject), tuple(scripts))


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8")
