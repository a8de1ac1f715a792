"""Files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.derive.formulas import formulas_source
from gainproof.derive.formulas_tried import require_values
from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.c_language.trial import c_trial
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.fpcore import fpcore
from gainproof.derive.printer.javascript.script import scripts
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.together import prove_all
from gainproof.derive.printer.write import module_files
from gainproof.derive.subject import Subject
from gainproof.derive.subject_page import subject_page


def printed(subject: Subject, certificate: Mapping[str, Any]) -> dict[str, Any]:
    """{"module", "title", "files"}: what one subject gives to the folder. The files are texts by
    name; a file of results, or of what scripts share, may come from other subjects too, and is then
    the same.
    """
    module = subject.module
    files = {**module_files(module, certificate, prove_all(module.kernels)), **scripts(module)}
    return {"module": module.name, "title": module.title, "files": files}


def packaged(subject: Subject, certificate: Mapping[str, Any]) -> dict[str, Any]:
    """The same for a package of its own: with a page, values that its tests read, and what the
    other targets have, in folders called after them. Raises BadInputError where a test against
    formulas could compare nothing.
    """
    module = subject.module
    bounds = prove_all(module.kernels)
    values = {
        kernel.name: known_values(kernel, pair, module.name)
        for kernel, pair in zip(module.kernels, bounds, strict=True)
    }
    files = {
        **module_files(module, certificate, bounds),
        f"{module.name}.md": subject_page(subject, bounds),
        f"tests/values_{module.name}.json": canonical_json(values),
    }
    files |= {f"c/{name}": text for name, text in c_files(module, bounds).items()}
    files[f"c/test_{module.name}.c"] = c_trial(module, values)
    files[f"fpcore/{module.name}.fpcore"] = fpcore(module, bounds)
    formulas = formulas_source(subject)
    if formulas:
        try:
            require_values(formulas, values)
        except ValueError as error:
            raise BadInputError(f"{subject.name}: {error}") from None
        files[f"tests/formulas_{module.name}.py"] = formulas
    return {"module": module.name, "title": module.title, "files": files}
