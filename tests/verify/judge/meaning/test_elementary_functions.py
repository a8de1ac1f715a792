"""Arc sines, secants, the greater of several numbers; false claims beside those that hold."""

from __future__ import annotations

import pytest
from small_claims import check, judged

CASES = [
    ("identity", r"\arcsin\frac{1}{2} = \frac{\pi}{6}", None, "proved"),
    ("identity", r"\arccos\frac{1}{2} = \frac{\pi}{6}", None, "refuted"),
    ("identity", r"\arctan(2 - \sqrt{3}) = \frac{\pi}{12}", None, "proved"),
    ("identity", r"\arctan(2 - \sqrt{3.0000001}) = \frac{\pi}{12}", None, "refuted"),
    ("identity", r"\arcsin x + \arccos x = \frac{\pi}{2}", r"-1 \leq x \leq 1", "proved"),
    ("identity", r"\sin(\arcsin x) = x", r"-1 \leq x \leq 1", "proved"),
    ("identity", r"\cos(\arcsin x) = \sqrt{1 - x^2}", r"-1 \leq x \leq 1", "proved"),
    ("identity", r"\cos(\arcsin x) = \sqrt{1 + x^2}", r"-1 \leq x \leq 1", "refuted"),
    ("identity", r"\sin(-2\arctan x) = -\frac{2 x}{1 + x^2}", None, "proved"),
    ("identity", r"\tan(2\arctan x) = \frac{2 x}{1 - x^2}", "0 < x < 1", "proved"),
    ("identity", r"\cos(2\arctan x) = \frac{2 x}{1 + x^2}", None, "refuted"),
    ("inequality", r"\arcsin x > x", "0 < x < 1", "proved"),
    ("inequality", r"\arcsin x \leq \frac{\pi}{2}", r"-1 \leq x \leq 1", "proved"),
    ("identity", r"\sec^2 x = 1 + \tan^2 x", None, "proved"),
    ("identity", r"\csc^2 x - \cot^2 x = 1", None, "proved"),
    ("identity", r"\csc x = \frac{1}{\cos x}", None, "refuted"),
    ("identity", r"\max(x, y) + \min(x, y) = x + y", None, "proved"),
    ("identity", r"\max(x, y) = x", r"x \geq y", "proved"),
    ("identity", r"\max(x, y) = x", "x < y", "refuted"),
    ("inequality", r"\min(x, y, z) \leq z", None, "proved"),
]


@pytest.mark.alike
@pytest.mark.parametrize(("kind", "latex", "domain", "wanted"), CASES)
def test_elementary_functions(kind: str, latex: str, domain: str | None, wanted: str) -> None:
    fields = f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")
    check(judged(kind, fields), wanted)


def test_an_arc_sine_has_no_value_beyond_1() -> None:
    found = judged("identity", "latex = '\\arcsin x = \\arcsin x'\ndomain = '-2 < x < 2'")
    assert found.verdict != "proved"
