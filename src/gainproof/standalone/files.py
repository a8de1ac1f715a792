"""What lies in a package of its own, by file name, and the page that it opens with: nothing is
written here.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.derive.printer.package import CODE, beside
from gainproof.standalone.licence import LICENCE
from gainproof.standalone.record import RECORD
from gainproof.subjects.generated_files import together
from gainproof.version import VERSION

SHIPPED = Path(__file__).with_name("shipped")
IN_C = Path(__file__).with_name("in_c")
COMPILING = ("_compiled.py", "compile.py")
IN_ARRAYS = Path(__file__).with_name("in_arrays")
TARGETS = ("array-api", "c", "fpcore", "jax", "octave", "rust")
"""What there may be besides NumPy modules."""
ARRAYS = {"array-api": ("_arrays.py",), "jax": ("_arrays.py", "_jax.py")}
"""What kernels over other arrays share, by target."""
HERE = "from gainproof.standalone."
IMPORTED = re.compile(r"from gainproof\.generated\.(\w+) import")
EVALUATES = "from gainproof.generated._runtime import evaluate\n"


def package_files(
    parts: Sequence[Mapping[str, Any]], name: str, command: str, *, needed_only: bool = False
) -> dict[str, bytes]:
    """Everything but the record, from what each subject gives; `name` is the package's.
    `needed_only`: of the code that kernels share what these kernels import.

    Raises ValueError for a file of several subjects who do not agree on it.
    """
    titles = {str(part["module"]): str(part["title"]) for part in parts}
    in_c = any(name.startswith("c/") for part in parts for name in part["files"])
    texts = {name: content.decode("utf-8") for name, content in together(parts).items()}
    if in_c:
        texts |= {f"{title}.py": _computing_in_c(texts[f"{title}.py"]) for title in titles}
        texts |= {name: shipped(IN_C / name) for name in COMPILING}
    texts = _needed(texts) if needed_only else texts
    for target, shared in ARRAYS.items():
        if any(name.startswith(f"{folder_of(target)}/") for name in texts):
            about = f'"""Kernels over other arrays than NumPy\'s: {target}."""\n'
            texts |= {f"{folder_of(target)}/{name}": _over_arrays(name) for name in shared}
            texts[f"{folder_of(target)}/__init__.py"] = about
    texts |= {
        **{f"tests/{path.name}": shipped(path) for path in _tests(parts)},
        "README.md": _readme(
            name, titles, command, in_c=in_c, in_jax=f"{folder_of('jax')}/__init__.py" in texts
        ),
        "LICENSE": LICENCE,
        "py.typed": "",
    }
    placed = {n: beside(text) if n.endswith(".py") else text for n, text in texts.items()}
    return {name: text.encode("utf-8") for name, text in placed.items()}


def folder_of(target: str) -> str:
    """Where the files of a target lie, a name that Python can import."""
    return target.replace("-", "_")


def _over_arrays(name: str) -> str:
    """What kernels over other arrays share; what it imports of NumPy's lies a folder above."""
    return shipped(IN_ARRAYS / name).replace("from gainproof.generated.", "from ..")


def _needed(texts: Mapping[str, str]) -> dict[str, str]:
    """Without shared code that is imported nowhere, not by other code that is imported either."""
    found = {name for name in texts if name not in CODE}
    while more := {f"{each}.py" for n in found for each in IMPORTED.findall(texts[n])} - found:
        found |= more
    return {name: text for name, text in texts.items() if name in found}


def _tests(parts: Sequence[Mapping[str, Any]]) -> list[Path]:
    """The tests of what there is: those called after a target only where the target is wanted."""
    folders = {name.partition("/")[0] for part in parts for name in part["files"]}
    left_out = {f"test_{each}.py" for each in map(folder_of, TARGETS) if each not in folders}
    return [path for path in sorted(SHIPPED.glob("*.py")) if path.name not in left_out]


def _computing_in_c(text: str) -> str:
    """A module whose kernels compute in C where that is compiled."""
    if EVALUATES not in text:
        raise ValueError("a module that does not evaluate its kernels by the shared runtime")
    return text.replace(EVALUATES, EVALUATES.replace("_runtime", "_compiled"))


def shipped(path: Path) -> str:
    """A file as it lies in a package, the same whatever the platform's newline."""
    text = path.read_text(encoding="utf-8")
    return text.replace(f"{HERE}{path.parent.name}.", "from .")


def _readme(name: str, titles: Mapping[str, str], command: str, *, in_c: bool, in_jax: bool) -> str:
    """What is here, how it is used, tested and checked again; `titles` are by module. `in_c`,
    `in_jax`: whether there are C sources, kernels of JAX besides.
    """
    modules = "\n".join(
        f"| [`{module}`]({module}.md) | {title} |" for module, title in sorted(titles.items())
    )
    first = min(titles)
    return f"""\
# {name}

Functions of NumPy arrays whose rounding errors are proved, written by gainproof {VERSION}:

    {command}

They need Python 3.11 and NumPy; nothing here imports gainproof.

| module | what it is |
|---|---|
{modules}

The page of each module has its formulas, domains, units and proved bounds.

## Use

The folder is a package: put it where your code imports from, under this or any other name.

```python
from {name} import {first}
```

It has no `pyproject.toml`: there is nothing to build, and it has the version of the code that it
is part of. Imports inside it are relative.
{_compiling(name) if in_c else ""}{_jax(name, first) if in_jax else ""}
## Test

    python -m pytest {name}

needs pytest and mpmath. Every kernel is held against exact values within its proved bound, in
every format, and its guards against what they must refuse. Gains and covariances of a
steady state are held against the Riccati equation, solved from the matrices of the model alone;
an expression against itself as it was written, in intervals.

## Check again

`NAME.json` is the certificate of `NAME.py`: every statement with the evidence that decides it.
Where gainproof is installed,

    {command} --check

derives all anew, has the certificates checked and compares every file byte for byte. The checker
alone says whether a certificate is right, not whether it speaks of this code:

```python
import json
from gainproof.verify.certificate import check

report = check(json.load(open("{name}/{first}.json")))
report.accepted, report.reason
```

## Files

`{RECORD}` names what the command has written: it replaces and deletes nothing else. What you add
is left alone. The licence of these files is in `LICENSE`.
"""


def _jax(name: str, first: str) -> str:
    """How kernels are called in JAX."""
    return f"""
## In JAX

```python
import jax
jax.config.update("jax_enable_x64", True)  # else float32 alone
from {name}.jax import {first}
```

needs JAX (`pip install jax`). The functions take its arrays, traced by `jit`, `vmap` and `grad` or
not. Where a value is known, an input outside of its domain is refused; where it is traced all
results are NaN. Numbers below the least normal one are outside, since JAX computes with 0 for them.
"""


def _compiling(name: str) -> str:
    """How kernels are made to compute in C."""
    return f"""
## Compile

    python -m {name}.compile

takes a C compiler (`$CC`, cc, gcc or clang) and puts a library beside each source in `c`. From then
on the same functions compute in C: same arguments, guards and messages, and the same numbers bit
for bit, which the command compares before it puts anything in place. Kernels that call functions
of `math.h` stay NumPy's, and it names them. A library serves its own source and platform alone;
everywhere else NumPy computes, as it does where `c` is not shipped: a wheel has that folder only as
package data, `c/*`. On x86-64 it has loops for AVX2 and for AVX-512, and the better ones that the
processor has are taken; without AVX2 NumPy computes. `GAINPROOF_INSTRUCTIONS=avx2` or `none` in the
environment takes no better ones. `--show` only says which kernels compute in C now and by which
instructions, `--remove` deletes the libraries.
"""
