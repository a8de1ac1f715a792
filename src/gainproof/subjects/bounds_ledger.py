"""The ledger of proved bounds, generated/bounds.json: by module and kernel, in each format, the
domain and what is proved of each output.

A bound is taken from it where what it rests on, the code that proves it and the versions are the
same; it is also what a later proof is measured by: a bound may only fall, a domain only grow.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.jobs.code_digest import versions

Plain = Mapping[str, Any]

NAME = "bounds.json"
PACKAGES = ("python", "numpy", "python-flint", "sympy")
"""A bound that was proved with others of these is proved anew."""
EXCEPTIONS: Mapping[str, str] = {}
"""The reason why a bound grew or a domain shrank, by the sentence that the command says of it."""
CURE = (
    "a bound may only fall and a domain only grow; where there is a reason, put the sentence with "
    "it into EXCEPTIONS of src/gainproof/subjects/bounds_ledger.py"
)


def own_versions() -> dict[str, str]:
    """The versions that bounds rest on, as they are here."""
    return {name: versions()[name] for name in PACKAGES}


def text(modules: Plain) -> str:
    """The whole file."""
    return canonical_json({"versions": own_versions(), "modules": dict(sorted(modules.items()))})


def committed(folder: Path) -> Plain:
    """The entries by module; none where there is no such file or nobody can read it."""
    return _modules(_read(folder / NAME))


def usable(folder: Path, fresh: bool = False) -> Plain:
    """The entries that may be taken: none if all are to be proved afresh, or were proved with other
    versions.
    """
    found = _read(folder / NAME)
    if fresh or found.get("versions") != own_versions():
        return {}
    return _modules(found)


def joined(parts: Sequence[Plain], folder: Path, *, whole: bool) -> str:
    """The file with what subjects have brought, {"module", "bounds"} each: the `whole` of it, or
    with the entries that others have in the folder. Of these what was proved with other versions
    keeps its bounds without its keys: it is proved anew when somebody wants it.
    """
    others: Plain = {}
    if not whole:
        others = usable(folder)
        if not others:
            others = {module: _unsealed(kernels) for module, kernels in committed(folder).items()}
    return text({**others, **{part["module"]: part["bounds"] for part in parts if part["bounds"]}})


def sealed(rests_on: str, entry: Plain) -> dict[str, Any]:
    """An entry with the digest of all that it rests on and of what it holds itself."""
    return {"key": _seal(rests_on, entry), **entry}


def opened(rests_on: str, entry: Any) -> Plain | None:
    """The entry without its digest; None unless it is the right one."""
    if not isinstance(entry, dict):
        return None
    inner = {name: value for name, value in entry.items() if name != "key"}
    return inner if entry.get("key") == _seal(rests_on, inner) else None


def _seal(rests_on: str, entry: Plain) -> str:
    content = json.dumps([rests_on, entry], sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()[:32]


def without_versions(content: bytes) -> bytes:
    """The file without its versions: what two machines must agree on."""
    return re.sub(rb'"versions": \{[^}]*\}', b'"versions": {}', content, count=1)


def worse(folder: Path, content: bytes) -> list[str]:
    """What the new content of the file has lost beside the one in the folder, a sentence each:
    bounds that grew, domains that shrank, kernels and outputs that are gone. Not what has a reason
    among the `EXCEPTIONS`.
    """
    before, after = committed(folder), _modules(json.loads(content))
    found = [f"{place}: {what}" for place, what in _lost(before, after)]
    return [sentence for sentence in found if sentence not in EXCEPTIONS]


def _lost(before: Plain, after: Plain) -> Iterator[tuple[str, str]]:
    for module, kernels in before.items():
        for kernel, entry in kernels.items():
            place = f"{module}.{kernel}"
            new = after.get(module, {}).get(kernel)
            if new is None:
                yield place, "the kernel is gone"
                continue
            try:
                yield from _of_kernel(place, entry, new)
            except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
                yield place, "what was committed cannot be read"


def _of_kernel(place: str, entry: Plain, new: Plain) -> Iterator[tuple[str, str]]:
    for form in (name for name in entry if name != "key"):
        for output, old in entry[form]["outputs"].items():
            named = f"{place}, {output} ({form})"
            yield from ((named, what) for what in _less(entry, new, form, output, old))


def _less(entry: Plain, new: Plain, form: str, output: str, old: Plain) -> Iterator[str]:
    found = new.get(form, {"outputs": {}})["outputs"].get(output)
    if found is None:
        yield "the output is gone"
        return
    if _number(found["bound"]) > _number(old["bound"]):
        yield f"its bound grew from {old['bound']} to {found['bound']}"
    for name, more in found.get("amplification", {}).items():
        if more > old.get("amplification", {}).get(name, 0.0):
            yield f"its amplification of {name} grew to {more:.6g}"
    if found.get("beside", 0.0) > old.get("beside", 0.0):
        yield f"what an underflow adds grew to {found['beside']!r}"
    before, after = (
        old.get("domain", entry[form]["inputs"]),
        found.get("domain", new[form]["inputs"]),
    )
    if len(before) != len(after) or any(
        now[0] > then[0] or now[1] < then[1] for then, now in zip(before, after, strict=True)
    ):
        yield f"its domain shrank from {_ranges(before)} to {_ranges(after)}"


def _number(bound: str) -> Fraction:
    """A bound as it is written. ValueError for what is written otherwise: a Fraction of 1e999999999
    would take all memory.
    """
    if re.fullmatch(r"[0-9]{1,99}([./][0-9]{1,99})?", bound) is None:
        raise ValueError(bound[:99])
    return Fraction(bound)


def _ranges(domain: Sequence[Sequence[float]]) -> str:
    return " x ".join(f"{low!r}..{high!r}" for low, high in domain)


def _unsealed(kernels: Plain) -> dict[str, Any]:
    return {
        kernel: {name: value for name, value in entry.items() if name != "key"}
        for kernel, entry in kernels.items()
    }


def _read(path: Path) -> Plain:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def _modules(found: Plain) -> Plain:
    modules = found.get("modules")
    if not isinstance(modules, dict):
        return {}
    return {name: kernels for name, kernels in modules.items() if isinstance(kernels, dict)}
