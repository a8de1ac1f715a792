"""What a sheet knows of its answer: enough to check a mark, nothing that can be read in passing.

This is no secret. A sheet has a few dozen lines, and whoever tries them all in a program has the
answer at once; it only keeps the answer from being read by accident. The numbers of right lines
stand as salted SHA-256 digests, and the answer's text is mixed with digests that the right line
gives. `static/exercises.js` does the same in the browser.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from hashlib import sha256
from itertools import count

RIGHT, NEAR, WRONG = 2, 1, 0
"""Half points of a mark: the line itself; the right region; anything else."""


@dataclass(frozen=True)
class Sealed:
    """`line`: digest of the wrong line; `near`: digests of the lines of its region; `text`: the
    answer, mixed.
    """

    salt: str
    line: str
    near: tuple[str, ...]
    text: str

    def points(self, marked: int) -> int:
        """Half points for a marked line."""
        if digest(self.salt, "line", marked) == self.line:
            return RIGHT
        return NEAR if digest(self.salt, "near", marked) in self.near else WRONG

    def answer(self, marked: int) -> str:
        """The answer, for whoever marks the right line. Raises ValueError for another line."""
        if self.points(marked) != RIGHT:
            raise ValueError(f"line {marked} is not the wrong one")
        return _mixed(b64decode(self.text), self.salt, marked).decode()

    def told(self, marked: int | None) -> str:
        """What a mark is worth, in words, and the answer for the right one."""
        if marked is None:
            return "No line is marked."
        points = self.points(marked)
        if points == RIGHT:
            return f"{self.answer(marked)} 1 point."
        if points == NEAR:
            return f"Line {marked} holds; the error is near: in the same part, or next to it."
        return f"Line {marked} holds, and the error is not near it."

    def plain(self) -> dict[str, object]:
        """As plain data, for a page or a notebook."""
        return {"salt": self.salt, "line": self.line, "near": [*self.near], "text": self.text}


def sealed(salt: str, line: int, near: Iterable[int], answer: str) -> Sealed:
    """The answer sealed. `near`: the lines of the region, the wrong one among them or not."""
    region: Sequence[str] = sorted(digest(salt, "near", each) for each in near)
    text = b64encode(_mixed(answer.encode(), salt, line)).decode()
    return Sealed(salt, digest(salt, "line", line), tuple(region), text)


def digest(salt: str, use: str, line: int) -> str:
    """The salted digest of a line's number."""
    return sha256(f"{salt}:{use}:{line}".encode()).hexdigest()


def _mixed(text: bytes, salt: str, line: int) -> bytes:
    """Exclusive or with digests: twice gives the text again."""
    blocks = (sha256(f"{salt}:text:{line}:{k}".encode()).digest() for k in count())
    stream = (byte for block in blocks for byte in block)
    return bytes(a ^ b for a, b in zip(text, stream, strict=False))
