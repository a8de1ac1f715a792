"""Pages as text files: printed back as they are, made derivations, and mistakes told by line."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.derivation import PageError, Step
from gainproof.derive.expression import real
from gainproof.derive.pages import reflow
from gainproof.derive.pages.derivation import FOLDER, Given, page_of, written
from gainproof.derive.pages.page import read_page
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.relation import Relation, described
from gainproof.jobs.code_digest import modules_below

A, B = real("a"), real("b")
PAGES = sorted(FOLDER.glob("*.md"))


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_a_page_is_printed_back_as_it_is_written(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert str(read_page(text, path.name, frozenset())) == text


def test_lines_of_a_page_are_filled_anew(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A page whose lines end elsewhere; one with a mistake stays, which is told."""
    right = (FOLDER / "one-state.md").read_text(encoding="utf-8")
    page, other = tmp_path / "page.md", tmp_path / "other.md"
    page.write_text(
        right.replace("One state is", "One state\nis").replace(
            "s + {near}) (", "s + {near})\n      ("
        )
    )
    other.write_text(right.replace("because Collect", "because `Collect", 1))
    wrong = other.read_text()
    assert reflow.main([str(page), str(other), str(tmp_path / "none.md")]) == 2
    assert page.read_text(encoding="utf-8") == right
    assert other.read_text() == wrong
    said = capsys.readouterr()
    assert said.out == f"{page}: filled anew\n"
    assert "other.md, line " in said.err
    assert "none.md: " in said.err
    assert reflow.main([str(page)]) == 0
    assert capsys.readouterr().out == f"{page}: as it was\n"


WRITTEN = [
    entry.name
    for entry in CATALOGUE
    if "gainproof.derive.pages.derivation" in modules_below(entry.module)
]


@pytest.mark.parametrize("name", WRITTEN)
def test_a_page_that_was_edited_is_derived_anew(name: str) -> None:
    """What is kept of a subject depends on the files in the folder of `gainproof.derive.pages`."""
    (module,) = (entry.module for entry in CATALOGUE if entry.name == name)
    assert modules_below(module)["gainproof.derive.pages"].parent.resolve() == FOLDER.resolve()


SHARED = {
    *("one-state", "least-squares"),
    *("measured-position-two-states", "first-measured-two-states"),
    *("measured-position-three-states", "first-measured-three-states"),
}
"""Pages of several families, or of models of a user's own."""


def test_a_page_is_that_of_a_subject() -> None:
    titles = {path.stem for path in PAGES if path.read_text(encoding="utf-8").startswith("# ")}
    assert titles - SHARED <= set(WRITTEN)
    fits = {"least-squares-mean", "least-squares-line", "least-squares-parabola"}
    noises = {"random-velocity", "random-acceleration", "continuous-white-acceleration"}
    assert fits | noises <= set(WRITTEN)


def test_a_page_of_too_many_lines_is_refused() -> None:
    with pytest.raises(PageError, match="at most 5000 lines"):
        read_page("# Title\n" + "x\n" * 6000, "page.md")


PAGE = """\
# A filter
What it is about.

names
    a
    b
    P_ij = entry_ij for ij in 11, 12

let
    double(x) = 2 x

setting main
    a > 0, b >= 0
    P_11 = double(a)

## A heading

### first (essential)
A sentence.

    P_11 = 2 a
    second (hidden): a > 0

because Reason.

include part (one)

include part (other)
"""
PART = """\
### {key}-third
Of {word}.

    double({value}) = {value} 2
    {key}-fourth: {value} + a > 0
"""


def on_disk(folder: Path, page: str = PAGE, part: str = PART) -> Path:
    """A folder with a page and its part."""
    (folder / "page.md").write_text(page, encoding="utf-8")
    (folder / "part.md").write_text(part, encoding="utf-8")
    return folder


GIVEN = Given(
    towers=(Tower("given", (Parameter("b"),), (), {}),),
    steps={"more": (Step("from-program", "Made.", described(""), "", "given"),)},
    slots={
        "one": {"key": "one", "word": "the first", "value": A + 1},
        "other": {"key": "two", "word": "the second", "value": B + 3},
    },
)


def _double() -> Graph:
    builder = GraphBuilder()
    a = builder.symbol("a")
    return builder.graph({"twice": a * 2, "thrice": a * 3})


PROGRAMS = {"double": _double()}


def test_a_page_with_parts_becomes_steps(tmp_path: Path) -> None:
    made = written("page", GIVEN, on_disk(tmp_path))
    assert (made.title, made.opening) == ("A filter", "What it is about.")
    assert [step.id for step in made.steps] == [
        "first",
        "second",
        "one-third",
        "one-fourth",
        "two-third",
        "two-fourth",
    ]
    first, second, third, _, other, last = made.steps
    assert (first.heading, first.essential, first.reason) == ("A heading", True, "Reason.")
    assert (second.joins, second.shown, second.sentence) == (True, False, "")
    assert (third.sentence, third.heading, third.essential) == ("Of the first.", "", False)
    assert other.relation.parts["left"] == 2 * B + 6
    assert last.relation.parts["expression"] == A + B + 3
    assert made.latex == {"a": "a", "b": "b", "entry_11": "P_{11}", "entry_12": "P_{12}"}
    assert made.towers["main"].expressions == {"entry_11": 2 * A}


def test_steps_and_settings_of_the_program_are_where_the_page_has_them(tmp_path: Path) -> None:
    page = PAGE.replace("setting main", "setting given\n\nsetting main", 1)
    page = page.replace("    second (hidden):", "    second (in given): b > 0\n    third (hidden):")
    made = written("page", GIVEN, on_disk(tmp_path, f"{page}\nsteps more\n"))
    assert list(made.towers) == ["given", "main"]
    assert [(step.id, step.tower) for step in made.steps][1:3] == [
        ("second", "given"),
        ("third", "main"),
    ]
    assert made.steps[-1].sentence == "Made."


@pytest.mark.parametrize(
    ("lines", "shown"),
    [
        ("    steps more", ["from-program"]),
        ("    steps none\n    steps more", ["from-program"]),
        ("    steps none\n    own: b + 1 > 0", ["own"]),
        ("    steps more\n    own: b + 1 > 0", ["from-program", "own"]),
        ("    steps none", []),
    ],
)
def test_the_first_statement_that_is_there_has_the_sentence(
    tmp_path: Path, lines: str, shown: list[str]
) -> None:
    lines = lines.replace("b + 1 > 0", "b + 1 > 0")
    page = f"# A filter\n\nnames\n    b\n\n## Made\n\n### some (in given)\nOf these.\n\n{lines}\n"
    page += "\nbecause Reason.\n\n### last (in given)\nAlone.\n\n    b + 1 > 0\n"
    steps = {**GIVEN.steps, "none": ()}
    made = written("page", Given(towers=GIVEN.towers, steps=steps), on_disk(tmp_path, page))
    assert [step.id for step in made.steps] == [*shown, "last"]
    first, *others = made.steps
    assert (first.heading, first.joins, first.tower) == ("Made", False, "given")
    wanted = ("Of these.", "Reason.") if shown else ("Alone.", "")
    assert (first.sentence, first.reason) == wanted
    assert [step.joins for step in others] == [step.id != "last" for step in others]
    assert not any(step.heading for step in others)


def test_a_setting_of_numbers_has_no_parameters(tmp_path: Path) -> None:
    page = PAGE.replace("    a > 0, b >= 0\n    P_11 = double(a)", "    a = 1/2\n    P_11 = 1")
    page = page.split("include")[0].rstrip().replace("## A", "let\n    K = [a; P_11]\n\n## A")
    page = page.replace(
        "    P_11 = 2 a", "    [a; P_11] = K\n    Stable-one: gain [a; P_11] is stable in m"
    )
    model = {
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": [["0", "0"], ["0", "0"]],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
    made = written("page", Given(models={"m": model}), on_disk(tmp_path, f"{page}\n"))
    step = next(step for step in made.steps if step.id == "Stable-one")
    values = evidence(step, made.towers["main"])["values"]
    # det(z I - F (I - K H)) = z^2 - z/2 + 1/2, and of the next degree 3 z/4 - 1/4
    assert [value["num"][0][0] for value in values] == ["1/2", "3/2", "1", "1/2"]


def test_what_a_part_defines_stays_in_it(tmp_path: Path) -> None:
    part = "let\n    own = a + 1\n\n### {key}\nA sentence.\n\n    own = a + 1\n"
    made = written("page", GIVEN, on_disk(tmp_path, part=part))
    assert [step.id for step in made.steps][2:] == ["one", "two"]


def test_an_empty_page_and_one_of_other_signs_are_refused(tmp_path: Path) -> None:
    (tmp_path / "page.md").write_bytes(b"")
    with pytest.raises(PageError, match="a page starts with '# Title'"):
        written("page", GIVEN, tmp_path)
    (tmp_path / "page.md").write_bytes(b"# \xff\n")
    with pytest.raises(PageError, match="UTF-8 text is wanted"):
        written("page", GIVEN, tmp_path)


def test_a_missing_page_says_so(tmp_path: Path) -> None:
    with pytest.raises(OSError, match=r"none\.md"):
        page_of("none", tmp_path)


MISTAKES = [
    ("# A filter", "A filter", 1, "a block is wanted that starts with #, ##, ###"),
    ("    a\n", "    a b\n", 5, "'name, name', 'name = quantity' or"),
    ("    a\n", "    in\n", 5, "'in' is a word of statements"),
    ("    b\n", "    a\n", 6, "'a' has a meaning already"),
    ("double(x) = 2 x", "double(x) = 2 y", 10, "'y' is neither a quantity nor a definition"),
    ("double(x) = 2 x", "double(x) : 2 x", 10, "'name = formula' is wanted"),
    ("a > 0, b >= 0", "a > b, b >= 0", 13, "parameters are wanted as in 'x > 0, y >= 0'"),
    ("P_11 = double(a)", "Q_11 = double(a)", 14, "'Q_11' is no quantity"),
    ("P_11 = double(a)", "P_11 = duoble(a)", 14, "'duoble' is no function"),
    ("P_11 = double(a)", "P_11 = double(a, b)", 14, "double(x) is wanted, 2 arguments came"),
    ("(essential)", "(important)", 18, "'id (in NAME, if SLOT, hidden, essential)' is wanted"),
    ("(essential)", "(essential, hidden)", 18, "is wanted, in this order, 'first (essential,"),
    ("(essential)", "(in other)", 18, "no setting 'other' above; known: given, main"),
    ("    P_11 = 2 a\n", "    P_11 = 2 (a\n", 21, "wanted ')' after '2 ( a'"),
    ("    P_11 = 2 a\n", "    P_11 = 2 a)\n", 21, "')' without '(' after '= 2 a'"),
    ("    P_11 = 2 a\n", "    P_11 = 2 (a)\n", 21, "read as 'P_11 = 2 a', written"),
    ("    P_11 = 2 a\n", "    P_11 = 2*a\n", 21, "'*' is no part of a formula"),
    ("    P_11 = 2 a\n", "    P_12 = 2 a\n", 21, "'P_12' has no value in setting main"),
    ("    P_11 = 2 a\n", "    P_11 = 2 a for any a\n", 21, "'a' has a value in setting main"),
    ("P_11 = double(a)", "P_11 = double(P_12)", 14, "'P_12' has no value in setting main"),
    ("P_11 = double(a)", "P_11 = sqrt(a) + 1", 12, "no value in tower main for sqrt(a)"),
    ("    P_11 = 2 a\n", "    P_11 falls with P_12\n", 21, "'P_12' has no value in setting"),
    ("    P_11 = 2 a\n", "    [P_12] is positive definite\n", 21, "'P_12' has no value in"),
    ("    P_11 = 2 a\n", "    [2] is positive definite\n", 21, "a matrix of quantities is wanted"),
    ("    P_11 = 2 a\n", "    gain [a] is stable in model\n", 21, "a model is wanted"),
    (
        "    P_11 = 2 a\n",
        "    sum of a over a from 0 to b is 2\n",
        21,
        "'a' has a value in setting",
    ),
    ("    P_11 = 2 a\n", "    sum of b over P_13 from 0 to b is 1\n", 21, "'P_13' is no quantity"),
    ("    P_11 = 2 a\n", "    sum of 1 over P_12 from 1 to b is b\n", 21, "wanted '0' after"),
    ("    P_11 = 2 a\n", "    P_11 = a/2 b\n", 21, "parentheses around the quotient"),
    (
        "    P_11 = 2 a\n",
        "    P_11 is 2 a\n",
        21,
        "wanted 'positive' or 'symmetric' or 'invertible' after",
    ),
    ("    P_11 = 2 a\n", "    P_11 2 a\n", 21, "wanted '=' or '>'"),
    ("    P_11 = 2 a\n", "    P_11 = 1/0\n", 21, "'1/0' divides by 0"),
    ("    P_11 = 2 a\n", "    P_11 = derivative(a, a + 1)\n", 21, "'a + 1' is no quantity"),
    ("    P_11 = 2 a\n", "    P_11 = derivative(a, a, b)\n", 21, "wanted: sqrt(x), "),
    ("    P_11 = 2 a\n", "    P_11 = [1, a] + [1; a]\n", 21, "has no value"),
    ("    P_11 = 2 a\n", "P_11 = 2 a\n", 20, "an indented statement is wanted, after a blank line"),
    ("    second (hidden): a > 0", "    a > 0", 22, "'id: statement' is wanted"),
    ("    second (hidden)", "    first", 22, "there is a step 'first' already"),
    ("    second (hidden)", "  second (hidden)", 22, "4 blanks are wanted"),
    ("because Reason.", "Reason.", 24, "a block is wanted"),
    ("Reason.", "Step @fist.", 18, "no step 'fist' is shown on this page; near it: first"),
    (
        "A sentence.",
        "A sentence, unlike step @second.",
        18,
        "no step 'second' is shown on this page",
    ),
    ("Reason.", "Reason {why}.", 18, "'{why}' is no slot of words here"),
    ("include part (one)", "include parts (one)", 26, "no file parts.md beside this page"),
    ("include part (one)", "steps part", 26, "no steps 'part' of the program; known: more"),
    ("    P_11 = 2 a\n", "    steps part\n", 21, "no steps 'part' of the program; known: more"),
    ("include part (one)", "include part one", 26, "include NAME is wanted, alone"),
    (
        "    second (hidden)",
        "    second (in no, hidden)",
        22,
        "no setting 'no' above; known: given, main",
    ),
    (
        "setting main\n    a > 0, b >= 0\n    P_11",
        "setting main\n\nlet\n    P",
        12,
        "no setting 'main'",
    ),
    ("    second (hidden)", "    second (if no)", 22, "no slot 'no'; known: "),
    ("### first (essential)", "### first (if no)", 18, "no slot 'no'; known: "),
    ("## A heading", "## A heading (if no)", 16, "no slot 'no'; known: "),
    ("    P_11 = 2 a\n", "    P_11 = {no} a\n", 21, "no slot 'no'; known: "),
    ("include part (one)", "include part (two)", 26, "no slots 'two'; known: one, other"),
    ("A sentence.", "A sentence. ", 19, "blanks at the end of the line"),
    ("A sentence.", "A `a sentence.", 19, "a formula stands between two backticks"),
    ("because Reason.", "because `a` and `b.", 24, "a formula stands between two backticks"),
    ("A sentence.", "A\tsentence.", 19, "a sign that is not printed"),
]


@pytest.mark.parametrize(("right", "wrong", "line", "said"), MISTAKES)
def test_a_mistake_is_told_with_its_line(
    tmp_path: Path, right: str, wrong: str, line: int, said: str
) -> None:
    assert right in PAGE
    with pytest.raises(PageError) as caught:
        written("page", GIVEN, on_disk(tmp_path, PAGE.replace(right, wrong, 1)))
    assert f"page.md, line {line}: " in str(caught.value)
    assert said in str(caught.value)


KERNEL = f"{PAGE}\nkernel double\n    twice = 2 a\n    thrice = 3 a\n"
OF_KERNELS = [
    ("kernel double", "kernel dubble", 30, "no kernel 'dubble'; known: double"),
    (
        "kernel double",
        "kernel double (in other)",
        30,
        "no setting 'other' above; known: given, main",
    ),
    ("twice = 2 a", "twise = 2 a", 31, "no output or root 'twise'; known: twice, thrice"),
    ("    twice = 2 a\n", "", 30, "'twice' has no value in setting main"),
    ("thrice = 3 a", "thrice = 3 x", 32, "'x' is neither a quantity nor a definition"),
    ("thrice = 3 a", "thrice = P_12", 32, "'P_12' has no value in setting main"),
]


def test_a_kernel_is_claimed_to_compute_what_its_block_says(tmp_path: Path) -> None:
    made = written("page", replace(GIVEN, programs=PROGRAMS), on_disk(tmp_path, KERNEL)).steps[-1]
    assert (made.id, made.tower, made.shown) == ("kernel-double", "main", False)
    claim = {"program": "double", "outputs": {"twice": 2 * A, "thrice": 3 * A}}
    assert made.relation.parts == claim


def test_an_output_is_the_quantity_of_its_name_and_roots_are_named(tmp_path: Path) -> None:
    builder = GraphBuilder()
    a = builder.symbol("a")
    root = builder.sqrt(a * a)
    graph = builder.graph({"entry_11": root * 2}, {"root": root})
    made = written(
        "page",
        replace(GIVEN, programs={"plain": graph}),
        on_disk(tmp_path, f"{PAGE}\nkernel plain\n    root = a\n"),
    ).steps[-1]
    assert made.relation.parts == {"program": "plain", "outputs": {"entry_11": real("entry_11")}}
    assert made.hint == {"graph": graph, "roots": {"root": A}}


@pytest.mark.parametrize(("right", "wrong", "line", "said"), OF_KERNELS)
def test_a_mistake_in_what_a_kernel_computes_is_told_with_its_line(
    tmp_path: Path, right: str, wrong: str, line: int, said: str
) -> None:
    page = on_disk(tmp_path, KERNEL.replace(right, wrong, 1))
    with pytest.raises(PageError) as caught:
        written("page", replace(GIVEN, programs=PROGRAMS), page)
    assert f"page.md, line {line}: " in str(caught.value)
    assert said in str(caught.value)


def test_a_mistake_in_a_part_names_the_part(tmp_path: Path) -> None:
    part = PART.replace("{value} + a > 0", "{amount} + a > 0")
    with pytest.raises(PageError, match=r"part\.md, line 5: no slot 'amount'; known: key, word"):
        written("page", GIVEN, on_disk(tmp_path, part=part))


SLOTTED = """\
# A filter
What it is about.

names
    a, b, area

setting main
    a > 0, b > 0

### first
Of {root} and {number}.

    {root}^2 + {number} a > 0
    made: area stands for {own}^2
    free: {own} + b = b + {own} for any {names}

include {chosen}
""".replace("    a, b\n", "    a, b, area\n")


@pytest.mark.parametrize(("root", "chosen", "ids"), [("3", "", []), ("a b", "part", ["last"])])
def test_slots_are_formulas_numbers_names_and_parts(
    tmp_path: Path, root: str, chosen: str, ids: list[str]
) -> None:
    own = real("own")
    slots = {"root": root, "number": sp.Rational(2, 3), "chosen": chosen}
    given = Given(slots={"": {**slots, "own": own, "names": (own,)}})
    part = "### last\nA sentence.\n\n    a > 0\n"
    made = written("page", given, on_disk(tmp_path, SLOTTED, part))
    first, definition, free, *more = made.steps
    assert [step.id for step in more] == ids
    assert first.sentence == f"Of {root} and 2/3."
    square = {"3": 9, "a b": A**2 * B**2}[root]
    assert first.relation.parts["expression"] == square + 2 * A / 3
    assert definition.relation == Relation("definition", {"left": real("area"), "right": own**2})
    assert free.relation.parts["free"] == ("own",)


@pytest.mark.parametrize(
    ("changed", "line", "said"),
    [
        ({"root": "c"}, 13, "'c' is neither a quantity nor a definition of this page"),
        ({"root": "2*a"}, 13, "'*' is no part of a formula"),
        ({"number": A}, 10, "'{number}' is no slot of words here"),
        ({"chosen": "other"}, 17, "no file other.md beside this page"),
        ({"names": ()}, 15, "'own' has no value in setting main"),
    ],
)
def test_a_mistake_in_a_slot_is_told_with_the_line_where_it_stands(
    tmp_path: Path, changed: dict[str, object], line: int, said: str
) -> None:
    own = real("own")
    slots = {"root": "a", "number": sp.Integer(2), "chosen": "", "own": own, "names": (own,)}
    with pytest.raises(PageError) as caught:
        written("page", Given(slots={"": {**slots, **changed}}), on_disk(tmp_path, SLOTTED))
    assert f"page.md, line {line}: " in str(caught.value)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    "said", ["of {own} over area from 0 to b is a", "of 1 over area from 0 to b is {own}"]
)
def test_each_part_of_a_sum_has_a_value(tmp_path: Path, said: str) -> None:
    page = SLOTTED.replace("    {root}^2 + {number} a > 0\n", f"    sum {said}\n")
    slots = {"root": "a", "number": "2", "own": real("own")}
    with pytest.raises(PageError, match="line 13: 'own' has no value in setting main"):
        written("page", Given(slots={"": slots}), on_disk(tmp_path, page))


CONDITIONS = [
    ("### first (essential)", "### first (if there, essential)", ["first", "second"], "A heading"),
    ("### first (essential)", "### first (if missing, essential)", [], ""),
    ("    second (hidden)", "    second (if there, hidden)", ["first", "second"], "A heading"),
    ("    second (hidden)", "    second (if missing, hidden)", ["first"], "A heading"),
    ("## A heading", "## A heading (if there)", ["first", "second"], "A heading"),
    ("## A heading", "## A heading (if missing)", ["first", "second"], ""),
]


@pytest.mark.parametrize(("always", "sometimes", "ids", "heading"), CONDITIONS)
def test_what_has_a_condition_is_there_where_its_slot_has_a_value(
    tmp_path: Path, always: str, sometimes: str, ids: list[str], heading: str
) -> None:
    given = Given(slots={**GIVEN.slots, "": {"there": "0", "missing": ""}})
    assert always in PAGE
    made = written("page", given, on_disk(tmp_path, PAGE.replace(always, sometimes, 1)))
    own = [step for step in made.steps if step.id in ("first", "second")]
    assert [step.id for step in own] == ids
    assert "".join(step.heading for step in own) == heading


def test_a_heading_stands_over_the_first_step_that_is_there(tmp_path: Path) -> None:
    given = Given(slots={**GIVEN.slots, "": {"missing": ""}})
    page = PAGE.replace(
        "## A heading", "## A heading\n\n### left (if missing)\nIt.\n\n    a = 2", 1
    )
    made = written("page", given, on_disk(tmp_path, page))
    assert (made.steps[0].id, made.steps[0].heading) == ("first", "A heading")


def test_hints_may_be_lists_of_formulas(tmp_path: Path) -> None:
    given = Given(slots=GIVEN.slots, hints={"first": {"values": ["2 a", B]}})
    made = written("page", given, on_disk(tmp_path))
    assert made.steps[0].hint == {"values": [2 * A, B]}


def test_a_part_that_includes_itself_is_refused(tmp_path: Path) -> None:
    part = f"{PART}\ninclude part (one)\n"
    with pytest.raises(PageError, match="a part has no title and includes no other"):
        written("page", GIVEN, on_disk(tmp_path, part=part))


def test_a_hint_for_a_step_that_is_gone_is_told(tmp_path: Path) -> None:
    given = Given(slots=GIVEN.slots, hints={"third": {"form": "a"}})
    with pytest.raises(PageError, match=r"hints for steps that are not there: \['third'\]"):
        written("page", given, on_disk(tmp_path))
