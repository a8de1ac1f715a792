"""The files of generated as bytes, and the layout of their JSON."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from graph_kernels import kernel_of
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.derive.printer.canonical_json import WIDTH, canonical_json
from gainproof.derive.printer.generated_files import module_files
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Module
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.package import CODE, code_source
from gainproof.subjects.generated_files import together


def module(name: str) -> Module:
    b = GraphBuilder()
    graph = b.graph({"y": b.sqrt(b.symbol("x"))})
    return Module(name, f"The module {name}", "made so", "from this", (kernel_of(graph),))


def files_of(*modules: Module) -> dict[str, bytes]:
    """Of modules whose certificates are empty."""
    return together(
        [
            {
                "module": each.name,
                "title": each.title,
                "files": module_files(each, {}, prove_all(each.kernels)),
            }
            for each in modules
        ]
    )


def test_all_files() -> None:
    files = files_of(module("b"), module("a"))
    assert sorted(files) == sorted(["__init__.py", *CODE, "a.py", "a.json", "b.py", "b.json"])
    assert all(files[name] == code_source(name).encode("utf-8") for name in CODE)
    assert b"shipped" not in b"".join(files.values())
    assert files["a.json"] == b"{}\n"
    assert b"`a`: The module a\n- `b`" in files["__init__.py"]
    assert all(b"\r" not in content and content.endswith(b"\n") for content in files.values())
    assert files == files_of(module("a"), module("b"))


def test_results_of_several_modules_stand_in_one_file() -> None:
    one, other = (replace(module(name), results="_results") for name in "ab")
    files = files_of(one, other)
    assert b"class Result(NamedTuple)" in files["_results.py"]
    assert b"class " not in files["a.py"]
    assert b"from gainproof.generated._results import (\n    Result,\n)" in files["a.py"]
    (kernel,) = other.kernels
    different = replace(other, kernels=(replace(kernel, result="Other"),))
    with pytest.raises(ValueError, match=r"b: its _results\.py differs from that of another"):
        files_of(one, different)


PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text(max_size=30),
    lambda inner: st.lists(inner, max_size=30) | st.dictionaries(st.text(max_size=9), inner),
    max_leaves=80,
)


@settings(max_examples=samples(10))
@given(PLAIN)
def test_json_comes_back(value: object) -> None:
    text = canonical_json(value)
    assert json.loads(text) == value
    assert text.endswith("\n")


def test_json_is_neither_one_line_nor_one_number_a_line() -> None:
    value = {"rows": [[str(n), [n, n]] for n in range(100)], "short": {"a": 1}}
    lines = canonical_json(value).splitlines()
    assert 10 < len(lines) < 40
    assert max(map(len, lines)) <= WIDTH
    assert lines[-2:] == ['  "short": {"a": 1}', "}"]
    with pytest.raises(ValueError, match="not JSON compliant"):
        canonical_json([float("nan")])
