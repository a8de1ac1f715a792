"""The page that checks formulas: what it may do, what it runs on, links of others."""

from __future__ import annotations

import hashlib
import io
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlencode

import pytest
from browser import needs_browser, of_changed_pages, opened
from node import needs_node
from page_judge import judged, served

from gainproof.book import check_page, check_runtime, site, site_links
from gainproof.book.check_runtime import NPM, PARTS, PIP, Part, judge_archive, runtime
from gainproof.cli import main
from gainproof.jobs.cache import FOLDER_VARIABLE

STUB = {
    "pyodide.js": b"export const loadPyodide = async () => { throw new Error('a stub'); };",
    "pyodide.asm.js": b"export default null;",
    "python-flint.whl": b"stub",
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A page that runs on nothing."""
    check_page.write(STUB, tmp_path / "page")
    return tmp_path / "page"


def test_the_page_alone_lets_nothing_in_or_out(folder: Path) -> None:
    text = (folder / "index.html").read_text(encoding="utf-8")
    policy = text.split('http-equiv="Content-Security-Policy" content="')[1].split('"')[0]
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["connect-src"] == "'self'"
    assert rules["script-src"] == "'self' 'wasm-unsafe-eval'"
    assert "http" not in policy
    assert text.index("http-equiv") < text.index("<script")
    assert "<script>" not in text
    assert not [word for word in text.split() if word.startswith(("onclick=", "style="))]
    for part in PARTS:
        assert f"<td>{part.name}</td><td>{part.version}</td>" in text
    made = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert {f"runtime/{name}" for name in STUB} < made
    contents = {path: (folder / path).read_bytes() for path in made}
    assert site_links.broken(contents)[1] == []


def test_without_what_it_runs_on_it_says_how_to_get_it() -> None:
    page = check_page.check_page({})
    text = site.files([page], {}, lambda _: None)[page.path].decode()
    assert "gainproof book --page check --out DIR" in text
    assert "check.js" not in text
    assert check_page.check_files({}) == {}


def test_no_script_makes_html_of_words() -> None:
    for name in check_page.SCRIPTS:
        text = (Path(check_page.__file__).parent / "static" / name).read_text(encoding="utf-8")
        for word in ("innerHTML", "outerHTML", "insertAdjacent", "eval(", "document.write"):
            assert word not in text


def test_the_judge_goes_along_whole_and_alone(tmp_path: Path) -> None:
    """With python-flint, lark and the setter of formulas it answers, and knows no other package."""
    archive = tmp_path / "judge.zip"
    archive.write_bytes(judge_archive())
    assert judge_archive() == archive.read_bytes()
    zipfile.ZipFile(archive).extractall(tmp_path / "judge")
    program = f"""
import sys
sys.path.insert(0, {str(tmp_path / "judge")!r})
for name in ("sympy", "numpy", "mpmath", "markupsafe", "jinja2"):
    sys.modules[name] = None
import json, gainproof
from gainproof.answers.in_page import InPage
request = dict(do="ask", formula="beta = alpha^2/(2 - alpha)", said={{}}, seconds=20, columns=80)
answer = InPage(lambda _: None).answered(json.dumps(request))
print(gainproof.__file__, json.loads(answer)["verdict"])
"""
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.stdout.split() == [str(tmp_path / "judge/gainproof/__init__.py"), "proved"], done


def tarball() -> bytes:
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w:gz") as archive:
        for name in check_runtime.PYODIDE:
            archive.addfile(tarfile.TarInfo(f"package/{name}"))
    return made.getvalue()


CONTENT = tarball()
FETCHES = """
import pathlib, sys
*_, log, there, folder, wanted = sys.argv
with open(log, "a") as file:
    print(wanted, file=file)
(pathlib.Path(folder) / "file").write_bytes(pathlib.Path(there).read_bytes())
"""


def parts(tmp_path: Path, client: Sequence[str] = (), content: bytes = CONTENT) -> tuple[Part, ...]:
    """One part, fetched by a client of ours from a file."""
    (tmp_path / "there").write_bytes(content)
    ours = (sys.executable, "-c", FETCHES, str(tmp_path / "log"), str(tmp_path / "there"))
    digest = hashlib.sha256(CONTENT).hexdigest()
    return (Part("thing", "1.2", "MIT", "file", digest, client or ours),)


def test_what_is_fetched_is_fetched_once(monkeypatch: Any, tmp_path: Path) -> None:
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "cache"))
    monkeypatch.setattr(check_runtime, "PARTS", parts(tmp_path))
    found = runtime()
    assert {"pyodide.js", "pyodide.asm.js", "pyodide.asm.wasm", "gainproof.whl"} < {*found}
    assert runtime().keys() == found.keys()
    assert (tmp_path / "log").read_text().split() == ["thing==1.2"]
    # damaged where it is kept, it is fetched anew
    (kept,) = (tmp_path / "cache").rglob("file")
    kept.write_bytes(b"damaged")
    runtime()
    assert (tmp_path / "log").read_text().split() == ["thing==1.2"] * 2


FAILS = "import sys; print('notice: x\\nERROR: no such version', file=sys.stderr); sys.exit(1)"


@pytest.mark.parametrize(
    ("client", "content", "why"),
    [
        (("no-such-client",), CONTENT, "there is no no-such-client on the path"),
        ((sys.executable, "-c", FAILS), CONTENT, "ERROR: no such version"),
        ((sys.executable, "-c", ""), CONTENT, "the registry has no file"),
        ((), CONTENT[:-1] + b"x", "file has another content than before"),
    ],
)
def test_what_cannot_be_fetched_is_told(
    monkeypatch: Any, tmp_path: Path, capsys: Any, client: Sequence[str], content: bytes, why: str
) -> None:
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "cache"))
    monkeypatch.setattr(check_runtime, "PARTS", parts(tmp_path, client, content))
    assert main(["book", "--page", "check", "--out", str(tmp_path / "page")]) == 2
    told = capsys.readouterr().err
    assert f"thing 1.2, which the page runs on, cannot be fetched: {why}" in told
    assert "npm, pip and the network" in told
    assert not (tmp_path / "page").exists()
    assert not (tmp_path / "cache").exists()


def test_the_clients_fetch_one_version_and_run_nothing_of_it() -> None:
    assert {part.client for part in PARTS} == {NPM, PIP}
    assert "--ignore-scripts" in NPM
    assert "--only-binary=:all:" in PIP
    assert all(part.version in part.file and len(part.sha256) == 64 for part in PARTS)


WORKER = """\
// Tasks "long" never end; others say which texts came with the request.
self.onmessage = ({ data }) => {
  for (const key of ["short", "long"]) {
    if (key in data.lost || key in data.texts) continue;
    self.postMessage({ begins: key, seconds: data.breaks ? 60 : 0.2 });
    if (key === "long") {
      if (data.breaks) throw new Error("broken");
      return;
    }
    self.postMessage({ ends: key, text: "known" });
  }
  self.postMessage({ answer: { lost: data.lost, texts: data.texts }, memory: data.memory ?? 0 });
};
self.postMessage(FIRST);
"""


@needs_node
@pytest.mark.parametrize(("breaks", "why"), [(False, "late"), (True, "Error: broken")])
def test_a_task_that_takes_too_long_ends_the_worker_and_not_the_page(
    folder: Path, breaks: bool, why: str
) -> None:
    (folder / "worker.js").write_text(WORKER.replace("FIRST", "{ ready: true }"))
    done = judged(folder, [{"breaks": breaks}, {"breaks": breaks}], "worker.js")
    assert done["started"] == 3
    # the new worker is told what is known; what was lost once is tried again when asked again
    first, second = (each["answer"] for each in done["answers"])
    assert first == {"lost": {"long": why}, "texts": {"short": "known"}}
    assert second["lost"] == {"long": why}


@needs_node
def test_a_worker_that_took_much_memory_is_replaced(folder: Path) -> None:
    (folder / "worker.js").write_text(
        WORKER.replace("FIRST", "{ ready: true }").replace('"long"]', "]")
    )
    done = judged(folder, [{"memory": memory} for memory in (1, 2**31, 1)], "worker.js")
    assert done["started"] == 2
    assert done["answers"][2]["answer"]["texts"] == {"short": "known"}


@needs_node
@pytest.mark.parametrize(
    ("script", "why"),
    [
        (WORKER.replace("FIRST", '{ failed: "no wheel: 404" }'), "no wheel: 404"),
        ("throw new Error('no such thing');", "Error: no such thing"),
    ],
)
def test_a_judge_that_cannot_be_loaded_says_why(folder: Path, script: str, why: str) -> None:
    (folder / "worker.js").write_text(script)
    assert judged(folder, [{}], "worker.js")["answers"] == [{"failed": why}]


HARM = "<img src=x onerror=alert(1)><script>alert(2)</script>"


@needs_browser
@of_changed_pages
def test_links_of_others_are_text_and_judge_nothing(folder: Path) -> None:
    long = "x" * 4001
    links = {
        urlencode({"f": HARM, "domain": HARM, "given": HARM, "model": HARM, "gain": HARM}): HARM,
        urlencode({"f": "x = 1", "s": f"{HARM}: {HARM}", "seconds": "1e99"}): "x = 1",
        f"f={long}": "",
        urlencode([("f", "x")] + [("s", "x: 1")] * 51): "",
        f"f=x&domain={quote('y' * 12000)}": "",
        "f=%zz%C0&s=:&s=__proto__: 1": "%zz\N{REPLACEMENT CHARACTER}",
        "%": "",
        f"content&f={quote(HARM)}": "",
    }
    faults: list[str] = []
    with served(folder) as (address, asked), opened() as browser:
        tab = browser.new_page()
        tab.on("dialog", lambda dialog: faults.append(dialog.message))
        tab.on("pageerror", lambda error: faults.append(str(error)))
        tab.on("console", lambda message: faults.append(message.text))
        for link, formula in links.items():
            tab.goto("about:blank")
            tab.goto(f"{address}#{link}")
            tab.wait_for_selector("#ask:not([hidden])")
            assert tab.input_value("#formula") == formula, link
            assert tab.locator("main img, main script, main svg").count() == 0
            assert tab.input_value("#model") in ("", "search")
            assert 1 <= int(tab.input_value("#seconds")) <= 3600
            if formula:
                assert "nothing is judged" in tab.text_content("#told")
            elif "f=" in link[:2]:
                assert "too long" in tab.text_content("#told")
    assert not faults
    assert not [path for path in asked if "runtime" in path]


@needs_browser
@of_changed_pages
def test_a_page_without_its_judge_says_so_and_stays(folder: Path) -> None:
    with served(folder) as (address, _), opened() as browser:
        tab = browser.new_page()
        tab.goto(address)
        tab.wait_for_selector("#ask:not([hidden])")
        assert tab.is_hidden("#idle")
        tab.fill("#formula", "x = 1")
        tab.press("#formula", "Tab")
        tab.click("#check")
        tab.locator("#told", has_text="The judge does not run here").wait_for()
        assert tab.is_enabled("#check")
        # opened from a folder its scripts do not run, which the page says
        tab.goto((folder / "index.html").as_uri())
        assert tab.is_visible("#idle")
        assert "http.server" in tab.text_content("#idle")
