"""The script of the sheets marks as Python does, where a JavaScript program is there to run it."""

from __future__ import annotations

import json
import shutil
import subprocess
from hashlib import sha256
from pathlib import Path

import pytest

import gainproof.book
from gainproof.book.exercises.sealed import sealed

SCRIPT = Path(gainproof.book.__file__).parent / "static" / "exercises.js"
NODE = shutil.which("node")
TEXTS = ["", "abc", *("é" * n for n in (27, 28, 31, 32, 100))]
ANSWER = "Line 7 is wrong (the sign of a term). At r = 1/2 the left side is √2, the right −1. " * 3
PROGRAM = """
const script = require(process.argv[1]);
const given = JSON.parse(require("fs").readFileSync(0, "utf8"));
const hex = (bytes) => Buffer.from(bytes).toString("hex");
process.stdout.write(JSON.stringify({
  digests: given.texts.map((text) => hex(script.sha256(text))),
  points: given.lines.map((line) => script.halfPoints(given.sealed, line)),
  answer: script.answerOf(given.sealed, 7),
}));
"""


@pytest.mark.skipif(NODE is None, reason="no node to run JavaScript with")
def test_script_marks_as_python_does() -> None:
    hidden = sealed("salt", 7, range(5, 10), ANSWER)
    given = {"texts": TEXTS, "lines": [*range(1, 12)], "sealed": hidden.plain()}
    assert NODE is not None
    done = subprocess.run(
        [NODE, "-e", PROGRAM, str(SCRIPT)],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=True,
        timeout=60,
    )
    found = json.loads(done.stdout)
    assert found["digests"] == [sha256(text.encode()).hexdigest() for text in TEXTS]
    assert found["points"] == [hidden.points(line) for line in range(1, 12)]
    assert found["points"] == [0, 0, 0, 0, 1, 1, 2, 1, 1, 0, 0]
    assert found["answer"] == hidden.answer(7) == ANSWER
