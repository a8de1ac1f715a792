"""Results kept between runs, in the user's cache folder.

An entry is used only if it names the key asked for and its checksum is that of its content;
whatever else is found there is treated as absent. A key is a digest of everything the result
depends on.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gainproof.files import atomic_file

FOLDER_VARIABLE = "GAINPROOF_CACHE"
KEPT_DAYS = 30
_FORMAT = "gainproof cache 1"


@dataclass(frozen=True)
class Cache:
    """Entries under `folder`, one file a key. `fresh`: nothing is read, results are still kept."""

    folder: Path
    fresh: bool = False

    def load(self, key: str) -> Any | None:
        """The plain data stored under `key`, or None: absent, damaged, or of another key."""
        if self.fresh:
            return None
        try:
            header, _, body = self._path(key).read_bytes().partition(b"\n")
            expected = _header(key, body)
            return json.loads(body) if header == expected else None
        except (OSError, ValueError, RecursionError):
            return None

    def store(self, key: str, value: Any) -> None:
        """Keep plain data under `key`. A folder that cannot be written costs only time."""
        body = json.dumps(value, ensure_ascii=False, separators=(",", ":")).encode("utf-8")
        with contextlib.suppress(OSError):
            atomic_file.write_bytes(self._path(key), _header(key, body) + b"\n" + body)

    def drop_old(self) -> None:
        """Remove what nobody stored anew for `KEPT_DAYS`; looks at every entry, so not for each."""
        oldest = time.time() - KEPT_DAYS * 86400
        with contextlib.suppress(OSError):
            for path in self.folder.glob("*.json"):
                if path.stat().st_mtime < oldest:
                    path.unlink(missing_ok=True)

    def _path(self, key: str) -> Path:
        return self.folder / f"{key}.json"


def key_of(kind: str, *parts: str | bytes) -> str:
    """A digest of all parts, each with its length, so that no two lists of parts agree."""
    digest = hashlib.sha256()
    for part in (kind, *parts):
        data = part.encode("utf-8") if isinstance(part, str) else part
        digest.update(str(len(data)).encode() + b":" + data)
    return f"{kind}-{digest.hexdigest()}"


def default_folder() -> Path:
    """`GAINPROOF_CACHE`, else the system's folder for caches of this user."""
    chosen = os.environ.get(FOLDER_VARIABLE)
    if chosen:
        return Path(chosen)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")) / "gainproof"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "gainproof"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "gainproof"


def _header(key: str, body: bytes) -> bytes:
    return f"{_FORMAT} {key} {hashlib.sha256(body).hexdigest()}".encode()
