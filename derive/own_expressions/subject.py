"""A module of a user's expressions as a subject: checked, brought into form, certified."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Derivation
from gainproof.derive.own_expressions.certified_kernel import Formed
from gainproof.derive.own_expressions.checks import require_written_well
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.dimensions import require_units
from gainproof.derive.own_expressions.expressions import (
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.other_forms import Form, forms, rooted
from gainproof.derive.own_expressions.stable_kernel import rewritten
from gainproof.derive.own_expressions.written_form import as_written
from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.subject import Subject

OPENING = (
    "Expressions of the user's own, with the domains and units that their author gives them. A "
    "kernel computes them as they are written or, where a subtraction would cost digits and "
    "another form was found, in that form, which is proved equal. Digits that can be lost all the "
    "same are stated with each output."
)


def derive_expressions(given: ExpressionSet) -> Subject:
    """The subject of a set of expressions.

    ExpressionError, naming kernel and quantity, for what cannot be used; PrintingError where an
    error has no bound.
    """
    require_written_well(given)
    for kernel in given.kernels:
        require_units(kernel)
    given = replace(given, kernels=tuple(map(_sympified, given.kernels)))
    made = [_formed(kernel) for kernel in given.kernels]
    by_name = {each.kernel.name: each for each in made}
    title = given.title.removesuffix(".")
    return Subject(
        name=given.name,
        title=title,
        model=None,
        derivation=Derivation(OPENING, tuple(step for each in made for step in each.steps), ()),
        towers={},
        programs={name: program for each in made for name, program in each.programs.items()},
        module=Module(
            name=given.name.replace("-", "_"),
            title=f"{title}.",
            command=f"gainproof generate {given.name}",
            derivation=f"gainproof derive {given.name}, SymPy {sp.__version__}",
            kernels=tuple(each.kernel for each in made),
        ),
        textbook=lambda: {
            kernel.name: {each.quantity.name: each.expression for each in kernel.outputs}
            for kernel in given.kernels
        },
        settings={name: tower for each in made for name, tower in each.towers.items()},
        held=lambda kernel: by_name[kernel.name].held(kernel),
    )


def _sympified(kernel: ExpressionKernel) -> ExpressionKernel:
    """With expressions of SymPy, also where a number of Python came."""
    outputs = (replace(each, expression=sp.sympify(each.expression)) for each in kernel.outputs)
    return replace(kernel, outputs=tuple(outputs))


def _formed(given: ExpressionKernel) -> Formed:
    """As it is written if that has a bound relative to each output, else in another form if that
    has one: of positive inputs as a stable form, of all as `other_forms`; then again as it is
    written, with errors over the terms of an output.
    """
    written, refusal = _proved(as_written, given)
    formed = written
    if formed is not None and _sure(formed) == len(given.outputs):
        return formed
    if not given.conditions and not any(each.signed or each.zero for each in given.inputs):
        other, reason = _proved(rewritten, given)
        formed = other or formed
        if reason != refusal:
            refusal = f"{refusal}. No other form helps: {reason}"
        if other is not None and not other.kernel.cancellations:
            return other
    if forms := chosen_forms(given):
        other, reason = _proved(lambda kernel: as_written(kernel, forms), given)
        if other is not None and (formed is written or _sure(other) > _sure(formed)):
            formed = other
        refusal = reason or refusal
    if formed is None:
        place = "" if refusal.startswith(given.name) else f"{given.name}: "
        raise ExpressionError(place + refusal)
    return formed


def _sure(formed: Formed | None) -> int:
    """How many outputs have a bound relative to themselves."""
    outputs = () if formed is None else formed.kernel.outputs
    return sum(not (each.by_terms or each.relative_to) for each in outputs)


def _proved(
    form: Callable[[ExpressionKernel], Formed], given: ExpressionKernel
) -> tuple[Formed | None, str]:
    """The kernel in a form that has proved bounds and is what its programs say, or why there is
    none.
    """
    try:
        formed = form(given)
        prove_all([formed.kernel])
        formed.held(formed.kernel)
    except ExpressionError:
        raise
    except (ValueError, NotImplementedError) as error:
        return None, str(error)
    return formed, ""


SEED = "forms"
"""Of the points at which terms are compared with values."""

Cost = tuple[float, ...]


def chosen_forms(given: ExpressionKernel) -> dict[str, Form]:
    """The form of each output; nothing for one of which none has a bound."""
    required = [each.value for each in asked(given.conditions)]
    roots = frozenset[sp.Expr]().union(
        *map(rooted, required), *(rooted(each.expression) for each in given.outputs)
    )
    found = {}
    for output in given.outputs:
        costs = {}
        for form in forms(output.expression, roots, required):
            cost = _cost(given, output, form)
            if cost is not None:
                costs[form] = cost
        if costs:
            found[output.quantity.name] = min(costs, key=lambda form: costs[form])
    return found


def _cost(given: ExpressionKernel, output: Result, form: Form) -> Cost | None:
    """Whether terms may cancel; whether products may underflow; by how much the terms are larger
    than the value at some points; the bounds; the steps. None where there is no bound.
    """
    alone = replace(given, outputs=(output,))
    try:
        kernel = as_written(alone, {output.quantity.name: form}).kernel
        bounds = [prove(kernel, each) for each in FORMATS]
    except (ValueError, NotImplementedError):
        return None
    ends = [each.outputs[0] for each in bounds]
    (printed,) = kernel.outputs
    return (
        float(printed.by_terms),
        float(any(end.beside for end in ends)),
        _mean_loss(kernel, bounds[0]) if printed.by_terms else 0.0,
        float(sum(end.bound for end in ends)),
        float(len(kernel.program.steps)),
    )


def _mean_loss(kernel: Kernel, bound: KernelBound) -> float:
    """The mean of the logarithms of terms over value at a few points of the domain."""
    (output,) = kernel.outputs
    ratios = [
        float(Fraction(point["scales"][output.name]) / abs(value))
        for point in known_values(kernel, (bound,), SEED)["points"][bound.format.name]
        if (value := Fraction(point["values"].get(output.name, 0)))
    ]
    return round(sum(map(math.log, ratios)) / len(ratios), 3) if ratios else 0.0
