"""A test of all printed kernels of one input: a test for each module, in place of thousands."""

from __future__ import annotations

from collections.abc import Callable
from inspect import Parameter, signature
from typing import Any

import pytest
from printed_kernels import PrintedKernel, printed_kernels

KERNELS = printed_kernels()


def every_kernel(test: Callable[..., None]) -> Callable[..., None]:
    """The test of one `kernel` as a test of the kernels of one `module`; what fails names each."""

    def of_a_module(module: str, **others: Any) -> None:
        failed = [
            (kernel, error)
            for kernel in KERNELS
            if kernel.family == module and (error := _failure(test, kernel, others)) is not None
        ]
        for kernel, error in failed:
            error.add_note(f"of {kernel.id}")
        if failed:
            raise ExceptionGroup(f"{test.__name__}: {len(failed)} kernels", [e for _, e in failed])

    of_a_module.__name__ = test.__name__
    of_a_module.__doc__ = test.__doc__
    of_a_module.__module__ = test.__module__
    vars(of_a_module).update(vars(test))  # with the marks that are below this one
    own = signature(test)
    rest = [parameter for name, parameter in own.parameters.items() if name != "kernel"]
    given = Parameter("module", Parameter.POSITIONAL_OR_KEYWORD)
    vars(of_a_module)["__signature__"] = own.replace(parameters=[given, *rest])
    families = list(dict.fromkeys(kernel.family for kernel in KERNELS))
    parametrized: Callable[..., None] = pytest.mark.parametrize("module", families)(of_a_module)
    return parametrized


def _failure(
    test: Callable[..., None], kernel: PrintedKernel, others: dict[str, Any]
) -> Exception | None:
    try:
        test(kernel=kernel, **others)
    except Exception as error:  # noqa: BLE001 (of whatever kind, it is the test's answer)
        return error
    except pytest.fail.Exception as error:  # what `pytest.raises` ends with; no Exception
        error.add_note(f"of {kernel.id}")
        raise
    return None
