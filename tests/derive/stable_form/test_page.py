"""docs/stable-forms.md: its programs print what is shown below them."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

PAGE = Path(__file__).resolve().parents[3] / "docs" / "stable-forms.md"
SHOWN = re.compile(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def test_the_page_prints_what_it_shows() -> None:
    text = PAGE.read_text("utf-8")
    shown = SHOWN.findall(text)
    # a file of expressions stands there besides, which tests of `gainproof generate` run
    assert len(shown) == text.count("```python") - text.count("```console") == 2
    for program, output in shown:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(program, "page.py", "exec"), {})  # noqa: S102  # of our own documentation
        assert printed.getvalue() == output
    assert max(map(len, text.splitlines())) <= 130
