"""A module of kernels as a crate of Rust without its standard library."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.derive.printer.bound import Bounds, KernelBound
from gainproof.derive.printer.cube_root_start import added_bits
from gainproof.derive.printer.docstring import described
from gainproof.derive.printer.emitter import Body, Language, body, named, required, unlike
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.program import FUNCTIONS
from gainproof.derive.printer.test_program_points import points

TYPES = {FLOAT64: ("double", "f64", ""), FLOAT32: ("single", "f32", "f")}
"""Of a format: the module, the type, and the last letter of the functions of C's library."""
LIBRARY = ("sqrt", "fabs", "floor", *FUNCTIONS)
# fmt: off
TAKEN = frozenset((
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum",
    "extern", "false", "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move",
    "mut", "pub", "ref", "return", "self", "Self", "static", "struct", "super", "trait", "true",
    "type", "unsafe", "use", "where", "while", "abstract", "become", "box", "do", "final", "gen",
    "macro", "override", "priv", "try", "typeof", "unsized", "virtual", "yield", "library",
    "refuse", "near_cbrt",
    *LIBRARY, *(f"{name}f" for name in LIBRARY),
))
# fmt: on
"""What no variable is called: words of Rust, and what the functions call."""
ABOUT = """\
//! `Err` names the first input that lies outside of its domain, NaN included. Nothing is allocated;
//! square roots and other functions are those of the C library that the program is linked with.
#![no_std]
#![allow(non_snake_case)]

/// What is refused: an input, or what inputs are together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused(pub &'static str);

/// A result, or what is refused.
pub type Checked<T> = core::result::Result<T, Refused>;

fn refuse(fine: bool, what: &'static str) -> Checked<()> {
    if fine { Ok(()) } else { Err(Refused(what)) }
}"""


@dataclass(frozen=True)
class _Rust(Language):
    def number(self, value: float) -> str:
        return f"{super().number(value)}_{TYPES[self.form][1]}"

    def call(self, name: str, parts: Sequence[str]) -> str:
        return super().call("fabs" if name == "abs" else name, parts)

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        return f"if {less} < {more} {{ {yes} }} else {{ {no} }}"

    def statement(self, name: str, text: str) -> str:
        return f"let {name} = {text};"

    def remark(self, label: str) -> str:
        return f" /* {label} */"


def rust_files(
    module: Module, bounds: Sequence[Bounds], values: Mapping[str, Any]
) -> dict[str, str]:
    """Manifest, source and test by file name, from bounds already proved."""
    manifest = f'[package]\nname = "{module.name}"\nversion = "0.0.0"\nedition = "2021"\n'
    texts = {"Cargo.toml": [manifest.rstrip()], "src/lib.rs": _source(module, bounds)}
    texts["tests/values.rs"] = _trial(module, values)
    return {f"{module.name}/{name}": "\n".join(text) + "\n" for name, text in texts.items()}


def _source(module: Module, bounds: Sequence[Bounds]) -> Iterator[str]:
    yield from (f"//! Made by: {module.command} --target rust", f"//! From: {module.derivation}")
    forms = [bound.format for bound in bounds[0]]
    told = " and in ".join(f"`{TYPES[form][0]}`" for form in forms)
    yield from (f"//! {module.title}", "//!", f"//! Functions of numbers, in {told}.", ABOUT)
    for row, form in enumerate(forms):
        name, kind, letter = TYPES[form]
        pairs = zip(module.kernels, bounds, strict=True)
        made = [_kernel(kernel, pair, row) for kernel, pair in pairs]
        used = sorted({each for _, calls in made for each in calls} & {*LIBRARY})
        yield from ("", f"/// Numbers of type {kind}.", f"pub mod {name} {{")
        yield "    use crate::{refuse, Checked};"
        if used:
            yield '    mod library {\n        extern "C" {'
            for each in used:
                pair_of = ", ".join(f"{x}: {kind}" for x in ("x", "y")[: _count(each)])
                yield f"            pub fn {each}{letter}({pair_of}) -> {kind};"
            yield "        }\n    }"
        for each in used:
            given = ("x", "y")[: _count(each)]
            heads = ", ".join(f"{x}: {kind}" for x in given)
            yield f"    fn {each}({heads}) -> {kind} {{"
            yield "        // SAFETY: a function of numbers without state"
            yield f"        unsafe {{ library::{each}{letter}({', '.join(given)}) }}\n    }}"
        if any("near_cbrt" in calls for _, calls in made):
            yield f"    fn near_cbrt(x: {kind}) -> {kind} {{"
            yield f"        {kind}::from_bits(x.to_bits() / 3 + {added_bits(form)})\n    }}"
        for lines, _ in made:
            yield from (f"    {line}".rstrip() for line in lines)
        yield "}"


def _count(function: str) -> int:
    return 2 if function in ("atan2", "hypot") else 1


def _kernel(kernel: Kernel, pair: Sequence[KernelBound], row: int) -> tuple[list[str], set[str]]:
    """Lines of a kernel's result and function, and what they call."""
    bound = pair[row]
    language, kind = _Rust(bound.format), TYPES[bound.format][1]
    inputs = unlike([each.name for each in kernel.inputs], TAKEN)
    outputs = unlike([each.name for each in kernel.outputs], TAKEN)
    names = {given.name: name for given, name in zip(kernel.inputs, inputs, strict=True)}
    made = body(kernel, language, named(names))
    conditions: list[tuple[Body | None, str, str]] = [
        (None, language.within(given, names[given.name], ends), given.name)
        for given, ends in zip(kernel.inputs, bound.inputs, strict=True)
    ]
    for each, (wanted, least) in zip(
        kernel.requirements, required(kernel, language, named(names)), strict=True
    ):
        conditions.append((wanted, f"{wanted.outputs[0]} >= {least}", each.name))
    lines = ["", f"/// Of `{kernel.name}`.", "#[derive(Clone, Copy, Debug, PartialEq)]"]
    lines += [f"pub struct {kernel.result} {{", *(f"    pub {x}: {kind}," for x in outputs), "}"]
    told = (f"/// {line}".rstrip() for line in described(kernel, pair))
    lines += ["", "/// ```text", *told, "/// ```"]
    arguments = ", ".join(f"{name}: {kind}" for name in inputs)
    lines.append(f"pub fn {kernel.name}({arguments}) -> Checked<{kernel.result}> {{")
    for before, condition, what in conditions:
        inner = f"{{ {' '.join(before.lines)} {condition} }}" if before else condition
        lines.append(f'    refuse({inner}, "{what}")?;')
    lines += [f"    {line}" for line in made.lines]
    pairs = ", ".join(f"{name}: {text}" for name, text in zip(outputs, made.outputs, strict=True))
    lines += [f"    Ok({kernel.result} {{ {pairs} }})", "}"]
    calls = made.operations.union(*(each.operations for each, _, _ in conditions if each))
    calls |= {"floor"} if any(each.integer for each in kernel.inputs) else set()
    signed = any(each.signed for each in kernel.inputs)
    return lines, {*calls, *(("fabs",) if signed or "abs" in calls else ())}


def _trial(module: Module, values: Mapping[str, Any]) -> Iterator[str]:
    """A test of each kernel and type: every value within its bound, NaN refused."""
    yield f"// Made by: {module.command} --target rust"
    yield f"use {module.name}::*;"
    for kernel in module.kernels:
        known = values[kernel.name]
        for form in (each for each in FORMATS if each.name in known["points"]):
            yield from ("", "#[test]", *_test(kernel, form, known))


def _test(kernel: Kernel, form: Format, known: Mapping[str, Any]) -> Iterator[str]:
    name, kind, _ = TYPES[form]
    outputs = unlike([each.name for each in kernel.outputs], TAKEN)
    width = len(kernel.inputs)
    yield f"fn {name}_{kernel.name}() {{"
    yield f"    let points: &[([{kind}; {width}], [{kind}; {2 * len(outputs)}])] = &["
    for at, ends in points(known, form):
        texts = [", ".join(_number(x, kind) for x in row) for row in (at, ends)]
        yield f"        ([{texts[0]}], [{texts[1]}]),"
    yield "    ];\n    for (at, ends) in points {"
    arguments = ", ".join(f"at[{i}]" for i in range(width))
    yield f"        let found = {name}::{kernel.name}({arguments}).unwrap();"
    for i, output in enumerate(outputs):
        limits = f"ends[{2 * i}], ends[{2 * i + 1}]"
        yield f"        let (value, low, high) = (found.{output}, {limits});"
        yield f'        assert!(value >= low && value <= high, "{output}: {{value}} at {{at:?}}");'
    yield "    }"
    for i, given in enumerate(kernel.inputs):
        row = ", ".join(f"{kind}::NAN" if j == i else f"points[0].0[{j}]" for j in range(width))
        yield f'    assert_eq!({name}::{kernel.name}({row}), Err(Refused("{given.name}")));'
    yield "}"


def _number(value: float, kind: str) -> str:
    infinite = {float("inf"): f"{kind}::INFINITY", -float("inf"): f"{kind}::NEG_INFINITY"}
    return infinite.get(value) or f"{value!r}"
