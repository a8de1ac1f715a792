"""A module of kernels as a package of functions for MATLAB and Octave."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from gainproof.derive.printer.bound import Bounds, KernelBound
from gainproof.derive.printer.cube_root_start import added_bits
from gainproof.derive.printer.docstring import described, wanted_text
from gainproof.derive.printer.emitter import Language, body, named, required, unlike
from gainproof.derive.printer.formats import FLOAT64, FORMATS, Format
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.program import FUNCTIONS
from gainproof.derive.printer.test_program_points import points

# fmt: off
TAKEN = frozenset((
    "break", "case", "catch", "classdef", "continue", "else", "elseif", "end", "for", "function",
    "global", "if", "otherwise", "parfor", "persistent", "return", "spmd", "switch", "try", "while",
    "do", "until", "endif", "unwind_protect", "pi", "i", "j", "e", "Inf", "NaN", "eps", "ans",
    "sqrt", "abs", "floor", "single", "double", "size", "ones", "all", "find", "isa", "isreal",
    "error", "numel", "repmat", "choose", "near_cbrt_double", "near_cbrt_single", "require",
    "of_double", "of_single", "shape", "typecast", "bitshift", "idivide", "uint32", "uint64",
    *FUNCTIONS,
))
# fmt: on
"""What no variable is called: words of MATLAB and Octave, and what the functions call."""
NAMES = {"float64": "double", "float32": "single"}
CHOOSE = """\
function r = choose(mask, yes, no)
    r = no;
    if isscalar(r), r = repmat(r, size(mask)); end
    if isscalar(yes), yes = repmat(yes, size(mask)); end
    r(mask) = yes(mask);
end
"""
REQUIRE = """\
function require(fine, name, value, wanted)
    if ~all(fine(:))
        place = find(~fine(:), 1);
        error('gainproof:domain', '%s must be %s, got %.17g at element %d', name, wanted, ...
              double(value(min(place, numel(value)))), place);
    end
end
"""
NEAR_CBRT = {
    "double": """\
function x = near_cbrt_double(x)
    shape = size(x);
    b = typecast(x(:).', 'uint64');
    q = bitshift(b, -2) + bitshift(b, -4);
    for k = [4, 8, 16, 32], q = q + bitshift(q, -k); end
    b = b - (q + bitshift(q, 1));
    q = q + bitshift(b + bitshift(b, 1) + bitshift(b, 3), -5) + uint64({});
    x = reshape(typecast(q, 'double'), shape);
end
""",
    "single": """\
function x = near_cbrt_single(x)
    q = idivide(typecast(x(:).', 'uint32'), uint32(3), 'floor') + uint32({});
    x = reshape(typecast(q, 'single'), size(x));
end
""",
}


@dataclass(frozen=True)
class _Octave(Language):
    words: ClassVar[tuple[str, str]] = ("&", "|")

    def number(self, value: float) -> str:
        text = super().number(value)
        return text if self.form is FLOAT64 else f"single({text})"

    def operation(self, sign: str, first: str, second: str) -> str:
        return super().operation(f".{sign}" if sign in "*/" else sign, first, second)

    def call(self, name: str, parts: Sequence[str]) -> str:
        ending = f"_{NAMES[self.form.name]}" if name == "near_cbrt" else ""
        return super().call(f"{name}{ending}", parts)

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        return f"choose({less} < {more}, {yes}, {no})"

    def statement(self, name: str, text: str) -> str:
        return f"{name} = {text};"

    def remark(self, label: str) -> str:
        return f"  % {label}"


def octave_files(
    module: Module, bounds: Sequence[Bounds], values: Mapping[str, Any]
) -> dict[str, str]:
    """A file for each kernel in a package folder, and a test script, by file name."""
    texts = {
        f"+{module.name}/{kernel.name}.m": _function(module, kernel, pair)
        for kernel, pair in zip(module.kernels, bounds, strict=True)
    }
    texts[f"test_{module.name}.m"] = _trial(module, values)
    return {name: "\n".join(lines) + "\n" for name, lines in texts.items()}


def _function(module: Module, kernel: Kernel, pair: Sequence[KernelBound]) -> Iterator[str]:
    inputs = unlike([each.name for each in kernel.inputs], TAKEN)
    outputs = unlike([each.name for each in kernel.outputs], {*TAKEN, *inputs})
    heads = f"[{', '.join(outputs)}]", ", ".join(inputs)
    yield f"function {heads[0]} = {kernel.name}({heads[1]})"
    yield from (f"% {line}".rstrip() for line in described(kernel, pair))
    yield from ("%", f"% Made by: {module.command} --target octave", f"% From: {module.derivation}")
    kinds = [NAMES[bound.format.name] for bound in pair]
    yield f"% Arrays have one size or are scalars; all inputs are {', or all are '.join(kinds)}."
    for kind in reversed(kinds):
        fine = " && ".join(f"isa({name}, '{kind}') && isreal({name})" for name in inputs)
        yield f"    {'if' if kind == kinds[-1] else 'elseif'} {fine}"
        yield f"        {heads[0]} = of_{kind}({heads[1]});"
    told = ", or all ".join(kinds)
    yield f"    else\n        error('gainproof:type', 'all inputs must be {told}');"
    yield "    end\nend"
    operations: set[str] = set()
    for bound in pair:
        kind, language = NAMES[bound.format.name], _Octave(bound.format)
        texts = named(dict(zip([each.name for each in kernel.inputs], inputs, strict=True)))
        made = body(kernel, language, texts)
        wanted = required(kernel, language, texts)
        yield from ("", f"function {heads[0]} = of_{kind}({heads[1]})")
        if len(inputs) > 1:
            yield f"    shape = ones(size({' + '.join(inputs)}), '{kind}');"
            yield from (f"    {name} = {name} .* shape;" for name in inputs)
        for given, name, ends in zip(kernel.inputs, inputs, bound.inputs, strict=True):
            told = wanted_text(given).replace("'", "''")
            text = f"{language.within(given, name, ends)}, '{given.name}', {name}"
            yield f"    require({text}, '{told}');"
        for each, (before, least) in zip(kernel.requirements, wanted, strict=True):
            yield from (f"    {line}" for line in before.lines)
            value = before.outputs[0]
            yield f"    require({value} >= {least}, '{each.name}', {value}, 'at least {least}');"
        yield from (f"    {line}" for line in made.lines)
        for name, text in zip(outputs, made.outputs, strict=True):
            constant = not text.startswith("t") and text not in inputs
            yield f"    {name} = {text}{f' + 0 .* {inputs[0]}' if constant else ''};"
        yield "end"
        operations |= made.operations.union(*(before.operations for before, _ in wanted))
    yield from ("", REQUIRE.rstrip())
    yield from ("", CHOOSE.rstrip()) if "select" in operations else ()
    if "near_cbrt" in operations:
        for kind, bound in zip(kinds, pair, strict=True):
            yield from ("", NEAR_CBRT[kind].rstrip().format(added_bits(bound.format)))


def _trial(module: Module, values: Mapping[str, Any]) -> Iterator[str]:
    """A script that says how many values are not as proved, with status 1 if one is not."""
    yield f"% Made by: {module.command} --target octave"
    yield f"% octave-cli test_{module.name}.m"
    yield "numbers = 0; wrong = 0;"
    for kernel in module.kernels:
        known = values[kernel.name]
        for form in (each for each in FORMATS if each.name in known["points"]):
            yield from _tries(module.name, kernel, form, known)
    yield "printf('%d of %d values are not as proved\\n', wrong, numbers);"
    yield "if wrong, exit(1); end"


def _tries(module: str, kernel: Kernel, form: Format, known: Mapping[str, Any]) -> Iterator[str]:
    kind, found = NAMES[form.name], list(points(known, form))
    for name, rows in (("at", [at for at, _ in found]), ("ends", [ends for _, ends in found])):
        yield f"{name} = {kind}(["
        yield from (f"    {', '.join(map(_number, row))};" for row in rows)
        yield "]);"
    inputs = ", ".join(f"at(:, {i + 1})" for i in range(len(kernel.inputs)))
    outputs = ", ".join(f"found{i}" for i in range(len(kernel.outputs)))
    yield f"[{outputs}] = {module}.{kernel.name}({inputs});"
    for i in range(len(kernel.outputs)):
        fine = f"found{i} >= ends(:, {2 * i + 1}) & found{i} <= ends(:, {2 * i + 2})"
        yield f"fine = isa(found{i}, '{kind}') & {fine};"
        yield "numbers = numbers + numel(fine); wrong = wrong + sum(~fine);"
        told = f"{kernel.name}, {kind}, output {i + 1}: points"
        yield f"if ~all(fine), printf('{told} %s\\n', mat2str(find(~fine)')); end"


def _number(value: float) -> str:
    return {float("inf"): "Inf", -float("inf"): "-Inf"}.get(value) or repr(value)
