"""Octave and Rust: what is printed runs, has the bits of the kernel, and refuses what it must."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of, simple
from numpy.typing import NDArray

from gainproof.derive.printer.bound import Bounds
from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel, Module, Output, Requirement, closed, signed
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.octave import octave_files
from gainproof.derive.printer.rust import TYPES, rust_files

KINDS = {"float64": ("double", np.uint64), "float32": ("single", np.uint32)}


def chosen() -> Kernel:
    """Choices, sizes, sums in two parts, a constant and an input among the outputs."""
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.absolute(x / 2 - b.sqrt("2/3"))
    scaled = b.select(2, x, gap * 3, -b.sqrt(x)) * "1/3"
    graph = b.graph({"y": scaled, "same": x, "one": gap + 1, "end": b.number("1/3")})
    return kernel_of(graph, upper=10**9)


def cube_root() -> Kernel:
    b = GraphBuilder()
    x = b.symbol("x")
    root = fixed_point(near_cbrt(x), lambda y: b.sqrt(b.sqrt(x * y)), within="1/25")
    return kernel_of(b.graph({"y": root}), lower="1e-3", upper="1e3")


def words() -> Kernel:
    """Inputs and outputs that are called like words of the languages, and like steps."""
    b = GraphBuilder()
    names = ("end", "fn", "t2")
    x, y, z = (b.symbol(name) for name in names)
    made = kernel_of(b.graph({"function": b.sqrt(x + 1) * b.sqrt(y + z), "fn": x * y * z}))
    return replace(made, inputs=tuple(closed(name, "it's", "1e-3", "1e3") for name in names))


def together() -> Kernel:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    return replace(
        kernel_of(b.graph({"y": x / size, "root": size})),
        inputs=(signed("x", "an argument", 0, 10**6), signed("z", "an argument", 0, 10**6)),
        outputs=(Output("y", "a value"),),
        requirements=(Requirement("root", "the root", "1e-6", "1e-3"),),
    )


def whole() -> Kernel:
    ends = {"lower_open": False, "upper_open": False}
    return simple(lambda _, n: 1 / (n + 1), upper=1000, integer=True, **ends)


KERNELS = {f.__name__: f for f in (chosen, cube_root, words, together, whole)}


def printed(name: str) -> tuple[Kernel, Module, dict[str, Any], list[Bounds]]:
    kernel = KERNELS[name]()
    module = Module("trial", "A trial", "gainproof generate trial", "by hand", (kernel,))
    bounds = prove_all([kernel])
    return kernel, module, {"kernel": known_values(kernel, bounds[0], "trial")}, bounds


def points(kernel: Kernel, form: str) -> list[NDArray[Any]]:
    """Seeded points over the domain, whole where they have to be, of either sign where they may."""
    random = np.random.default_rng(5)
    found = []
    for given in kernel.inputs:
        low, high = max(float(str(given.lower)), 1e-3), float(str(given.upper or 1e6))
        x = np.exp(random.uniform(np.log(low), np.log(high), 200))
        x = np.round(x) if given.integer else x
        found.append((x * random.choice([-1, 1], 200) if given.signed else x).astype(form))
    return found


def bits(kernel: Kernel, form: str, given: list[NDArray[Any]]) -> list[int]:
    whole = KINDS[form][1]
    found = function_of(kernel)(*given)
    return [int(x) for y in found for x in np.broadcast_to(y, (200,)).copy().view(whole)]


def run(*command: str | Path, folder: Path) -> str:
    """What a program prints; the test is skipped where it is not installed."""
    if shutil.which(str(command[0])) is None:
        pytest.skip(f"needs {command[0]}")
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def write(files: Mapping[str, str], folder: Path) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


@pytest.mark.alike
@pytest.mark.parametrize("name", KERNELS)
def test_octave(name: str, tmp_path: Path) -> None:
    kernel, module, values, bounds = printed(name)
    write(octave_files(module, bounds, values), tmp_path)
    outputs = ", ".join(f"y{i}" for i in range(len(kernel.outputs)))
    lines, wanted = ["test_trial"], []
    for form, (kind, _) in KINDS.items():
        given = points(kernel, form)
        texts = [f"{kind}([{'; '.join(map(repr, x.tolist()))}])" for x in given]
        lines.append(f"[{outputs}] = trial.kernel({', '.join(texts)});")
        lines += [f"disp(num2hex({y}))" for y in outputs.split(", ")]
        wanted += bits(kernel, form, given)
    for bad in ("NaN", "-1e9", "int8(1)", "1i"):
        call = f"trial.kernel({', '.join([bad] * len(kernel.inputs))})"
        lines.append(f"try, {call}; catch e, disp(e.identifier), end")
    (tmp_path / "bits.m").write_text("\n".join(lines), encoding="utf-8")
    first, *found = run("octave-cli", "--no-init-file", "bits.m", folder=tmp_path).splitlines()
    assert first.startswith("0 of ")
    assert found[-4:] == ["gainproof:domain"] * 2 + ["gainproof:type"] * 2
    assert [int(line, 16) for line in found[:-4]] == wanted


@pytest.mark.alike
@pytest.mark.parametrize("name", KERNELS)
def test_rust(name: str, tmp_path: Path) -> None:
    kernel, module, values, bounds = printed(name)
    write(rust_files(module, bounds, values), tmp_path)
    source = tmp_path / "trial" / "src" / "lib.rs"
    build = ("rustc", "--edition", "2021", "-O", "-D", "warnings")
    run(*build, "--crate-type", "lib", "--crate-name", "trial", source, folder=tmp_path)
    test = tmp_path / "trial" / "tests" / "values.rs"
    linked = ("--extern", "trial=libtrial.rlib", "-L", ".")
    run(*build, "--test", test, *linked, "-o", "values", folder=tmp_path)
    assert "0 failed" in run(tmp_path / "values", folder=tmp_path)
    names = rust_names(source.read_text(encoding="utf-8"))
    lines, wanted = ["fn main() {"], []
    for form, (kind, letters, _) in zip(KINDS, TYPES.values(), strict=True):
        given = points(kernel, form)
        for output in names:
            for row in zip(*(x.tolist() for x in given), strict=True):
                numbers = ", ".join(f"{x!r}_{letters}" for x in row)
                call = f"trial::{kind}::kernel({numbers}).unwrap().{output}"
                lines.append(f'    println!("{{:x}}", {call}.to_bits());')
        wanted += bits(kernel, form, given)
    (tmp_path / "main.rs").write_text("\n".join([*lines, "}"]), encoding="utf-8")
    run("rustc", "--edition", "2021", "main.rs", *linked, "-o", "main", folder=tmp_path)
    found = [int(line, 16) for line in run(tmp_path / "main", folder=tmp_path).split()]
    assert found == wanted


@pytest.mark.alike
@pytest.mark.parametrize("form", KINDS)
@pytest.mark.parametrize("name", KERNELS)
def test_one_format_is_that_part_of_both(name: str, form: str, tmp_path: Path) -> None:
    kernel, module, values, both = printed(name)
    bounds = [tuple(bound for bound in both[0] if bound.format.name == form)]
    known = {"kernel": known_values(kernel, bounds[0], "trial")}
    assert known["kernel"]["points"] == {form: values["kernel"]["points"][form]}
    octave, rust = octave_files(module, bounds, known), rust_files(module, bounds, known)
    pairs = [
        (octave["+trial/kernel.m"], octave_files(module, both, values)["+trial/kernel.m"], "%"),
        (rust["trial/src/lib.rs"], rust_files(module, both, values)["trial/src/lib.rs"], "//"),
        (c_files(module, bounds)["trial.c"], c_files(module, both)["trial.c"], "/*"),
    ]
    other = "single" if form == "float64" else "double"
    for text, whole, comment in pairs:
        more = [each for each in text.splitlines() if each not in whole.splitlines()]
        told = ("isa(", "all inputs must be", comment)
        assert all(any(word in line for word in told) for line in more), more
        assert f"of_{other}" not in text
        assert f"near_cbrt_{other}" not in text
        assert f"mod {other}" not in text
    write(octave, tmp_path)
    assert run("octave-cli", "--no-init-file", "test_trial.m", folder=tmp_path).startswith("0 of ")


def rust_names(text: str) -> list[str]:
    """The fields of the first result."""
    inner = text.partition("pub struct Result {")[2].partition("}")[0]
    return [line.split()[1].rstrip(":") for line in inner.splitlines() if "pub " in line]
