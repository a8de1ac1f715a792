"""Kernels over arrays of JAX, for jit, vmap and differentiation.

What is outside of a domain is refused as everywhere where its value is known. Where it is traced,
which has no value yet, all outputs are NaN there, and so are their derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer
from jax.custom_derivatives import SymbolicZero

from gainproof.standalone.in_arrays._arrays import (
    NUMBERS,
    Form,
    Kernel,
    Slope,
    admitted,
    refusal,
    require_only,
    require_type,
    shape_of,
)

Values = tuple[Any, ...]


def evaluate(kernel: Kernel, given: Sequence[Any]) -> Any:
    """The result of a kernel, arrays of the inputs' common shape.

    TypeError for what is no array of JAX or NumPy, of real numbers, or a number; ValueError for
    inputs outside their domain if none is traced, and for shapes that do not broadcast.
    """
    inputs = _arrays(kernel, given)
    shape_of(kernel, inputs)
    fine, values, outputs = _compiled(kernel)(*inputs)
    if not any(isinstance(x, Tracer) for x in (fine, *inputs)) and not fine:
        raise ValueError(refusal(kernel, inputs, values, _form(inputs)))
    return kernel.result(*outputs)


def _arrays(kernel: Kernel, given: Sequence[Any]) -> list[Any]:
    """The inputs as arrays of one type, by JAX's own rules: numbers take that of the arrays."""
    for domain, x in zip(kernel.inputs, given, strict=True):
        known = isinstance(x, (jax.Array, *NUMBERS)) or type(x) is np.ndarray
        if not known or isinstance(x, bool):
            raise TypeError(
                f"{kernel.name}: {domain.name} must be an array of JAX or NumPy, or a number, got "
                f"{type(x).__name__} of {type(x).__module__.partition('.')[0]}"
            )
        kind = jnp.result_type(x)
        if kind.kind not in "iu":
            require_type(kernel, domain.name, str(kind))
    kind = jnp.result_type(*given, 1.0)
    require_only(kernel, str(kind))
    return [jnp.asarray(x, kind) for x in given]


class _Form(Form):
    kept = staticmethod(jax.lax.optimization_barrier)
    """A result behind which XLA does not look, so that it is rounded as it is written."""


def _form(inputs: Sequence[Any]) -> Form:
    return _Form(jnp, inputs[0].dtype == jnp.float32)


@cache
def _compiled(kernel: Kernel) -> Callable[..., tuple[Any, Values, Values]]:
    """Whether all inputs are admitted, what is required of them together, and the outputs."""
    compiled: Callable[..., tuple[Any, Values, Values]] = jax.jit(partial(_checked, kernel))
    return compiled


def _checked(kernel: Kernel, *given: Any) -> tuple[Any, Values, Values]:
    inputs = jnp.broadcast_arrays(*given)
    form, count = _form(inputs), len(kernel.required)
    values = _differentiable(kernel)(*inputs)
    fine = admitted(kernel, inputs, values, form)
    # a factor: what it makes NaN is so in derivatives of every kind
    unit = jnp.where(fine, form.of(1.0), form.of(jnp.nan))
    return jnp.all(fine), values[:count], tuple(y * unit for y in values[count:])


@cache
def _differentiable(kernel: Kernel) -> Callable[..., Values]:
    """What a kernel computes; derivatives that kernels have are theirs, others are JAX's own."""

    def plain(*inputs: Any) -> Values:
        form, shape = _form(inputs), inputs[0].shape
        return tuple(jnp.broadcast_to(form.of(y), shape) for y in kernel.compute(*inputs, form))

    slopes = kernel.slopes()
    if not slopes:
        return plain
    names = [domain.name for domain in kernel.inputs]
    function = jax.custom_jvp(plain)

    def rule(inputs: Values, tangents: Values) -> tuple[Values, Values]:
        values = function(*inputs)
        moved = [i for i, each in enumerate(tangents) if not isinstance(each, SymbolicZero)]
        known: dict[Kernel, Values] = {}
        rates = [jnp.zeros_like(y) for y in values[: len(kernel.required)]]
        outputs = zip(kernel.result._fields, values[len(kernel.required) :], strict=True)
        for row, (name, y) in enumerate(outputs, len(kernel.required)):
            by = {names.index(each.given): each for each in slopes if each.output == name}
            rate = jnp.zeros_like(y)
            for place in moved:
                if place in by:
                    rate = rate + _slope(by[place], inputs, known) * tangents[place]
            others = [place for place in moved if place not in by]
            if others:

                def alone(*moving: Any, others: Any = others, row: int = row) -> Any:
                    own = dict(zip(others, moving, strict=True))
                    return plain(*(own.get(i, x) for i, x in enumerate(inputs)))[row]

                at, along = ([each[i] for i in others] for each in (inputs, tangents))
                rate = rate + jax.jvp(alone, at, along)[1]
            rates.append(rate)
        return values, tuple(rates)

    function.defjvp(rule, symbolic_zeros=True)
    differentiable: Callable[..., tuple[Any, ...]] = function
    return differentiable


def _slope(each: Slope, inputs: Values, known: dict[Kernel, Values]) -> Any:
    """A derivative by the kernel that has it, which is computed once."""
    if each.kernel not in known:
        known[each.kernel] = _checked(each.kernel, *inputs)[2]
    return each.sign * known[each.kernel][each.kernel.result._fields.index(each.slope)]
