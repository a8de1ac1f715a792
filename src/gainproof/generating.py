"""Files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.derive.printer.package import CODE, LIST
from gainproof.derive.printer.write import all_files
from gainproof.derive.subject import Subject


def printed(subject: Subject, certificate: Mapping[str, Any]) -> dict[str, Any]:
    """{"module", "title", "files"}: what one subject gives to the folder. The files are texts by
    name; a file of results may come from other subjects too, and is then the same.
    """
    module = subject.module
    made = all_files((module,), {module.name: certificate})
    files = {name: made[name].decode("utf-8") for name in made if name not in {CODE, LIST}}
    return {"module": module.name, "title": module.title, "files": files}
