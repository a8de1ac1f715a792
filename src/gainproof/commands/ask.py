"""`gainproof ask`: the verdict on a formula."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from gainproof.claims import time_limit

if TYPE_CHECKING:
    from gainproof.answers.answer import Answer
    from gainproof.answers.possible_filters import Options

HELP = "say whether a formula is right"
DESCRIPTION = """\
Says of each FORMULA, in LaTeX or as plain text, whether it is right: proved, refuted with a point
where it fails and the nearest true formula, or true on a part only. Letters are understood as the
field uses them (alpha, beta, gamma, K_1, P_{11}, T, Lambda, sigma_v, sigma_w and more); a formula
with other letters is about real numbers, wherever all of its parts have a value. Whatever was
guessed is said, and can be said otherwise. A formula that begins with a minus sign stands behind
--.

Nothing of a formula is executed. Exit status 0 if every formula is settled, whatever the verdict; 1
if one is not; 2 for one that cannot be read, after the others were answered."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "formulas", metavar="FORMULA", nargs="+", help="a formula; - reads one from each line"
    )
    parser.add_argument(
        "--symbol",
        metavar="'NAME: MEANING'",
        action="append",
        default=[],
        help=r"'\alpha: filter_gain.1', 'x: m > 0', 'n: integer > 0', 'r: = a/b', "
        "'P: n x n, symmetric'; may be repeated",
    )
    parser.add_argument(
        "--model",
        metavar="NAME",
        default="",
        help="a model of `gainproof list`, a file of your own model (FILE.py, which is executed), "
        "search (the one that fits), fixed (any gains), none, or matrices (of any size)",
    )
    parser.add_argument("--domain", metavar="CONDITION", default="", help="where it is claimed")
    parser.add_argument(
        "--given",
        metavar="RELATION",
        action="append",
        default=[],
        help="a hypothesis; may be repeated",
    )
    parser.add_argument(
        "--convention",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        help="such as gain=predictor, third_gain=1/2, covariance=updated; may be repeated",
    )
    parser.add_argument("--json", action="store_true", help="answers as data")
    parser.add_argument("--explain", action="store_true", help="the whole proof or witness too")
    parser.add_argument("--save", metavar="NEW.toml", help="write the formula as a claim file")
    parser.add_argument(
        "--certificate",
        metavar="NEW.json",
        help="write the proof or counterexample as data that one file without gainproof decides",
    )
    time_limit.configure(parser)
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0 if every formula is settled, else 1; 2 if one cannot be read."""
    import json
    import sys

    from gainproof.answers.answer import FORMAT
    from gainproof.answers.judge import Judge
    from gainproof.bad_input import BadInputError, harmless

    models = []
    if options.model.endswith(".py"):
        models = [_own_model(options.model)]
        options.model = str(models[0]["name"])
        if options.save is not None:
            raise BadInputError("--save: a claim file cannot name a model in Python")
    asked = _options(options)
    formulas = list(_formulas(options.formulas))
    for option in ("save", "certificate"):
        if getattr(options, option) is not None and len(formulas) != 1:
            raise BadInputError(f"--{option} writes one formula, got {len(formulas)}")
    answers: list[Answer] = []
    errors: list[str] = []
    with Judge(seconds=options.seconds, fresh=options.fresh, models=models) as judge:
        for formula in formulas:
            try:
                answer = judge.answer(judge.question(formula, asked))
                if options.save is not None:
                    _save(options.save, answer.text)
            except BadInputError as error:
                errors.append(f"{formula}: {error}")
                if not options.json:
                    sys.stdout.flush()
                    print(f"gainproof: {harmless(str(error))}", file=sys.stderr)
                continue
            if not options.json:
                _print(answer, explain=options.explain, first=not answers)
            answers.append(answer)
    if options.certificate is not None and answers:
        from gainproof.claims import certificate_files

        try:
            told = certificate_files.write_one(
                options.certificate, answers[0].claim, answers[0].formula
            )
        except BadInputError as error:
            errors.append(f"{answers[0].formula}: {error}")
            told = str(error)
        sys.stdout.flush()
        print(f"gainproof: {harmless(told)}", file=sys.stderr)
    if options.json:
        plain = [a.plain() | a.certified() for a in answers]
        data = {"format": FORMAT, "answers": plain, "errors": errors}
        print(json.dumps(data, indent=2))
    if errors:
        return 2
    return 1 if any(answer.verdict in ("held", "undecided") for answer in answers) else 0


def _own_model(file: str) -> dict[str, Any]:
    """The model of a user's own file, which is executed. Raises BadInputError."""
    from gainproof.bad_input import BadInputError
    from gainproof.claims.judgements import shipped_models
    from gainproof.jobs.session import open_session
    from gainproof.subjects import derivations

    model = derivations.one(file, open_session(quiet=True)).model
    if model is None:
        raise BadInputError(f"--model {file}: it defines expressions, no model")
    rows = [row for name in ("transition", "process_noise") for row in model[name]]
    if not all(isinstance(entry, str) for row in rows for entry in row):
        raise BadInputError(
            f"--model {file}: it has parameters, and the judge takes models in numbers: give the "
            "parameters values, or write its matrices into a claim file"
        )
    if model["name"] in [each["name"] for each in shipped_models()]:
        raise BadInputError(f"--model {file}: its name {model['name']} is one of `gainproof list`")
    return dict(model)


def _print(answer: Answer, *, explain: bool, first: bool) -> None:
    from gainproof import terminal_text

    columns = terminal_text.width()
    shown = answer.shown(columns) + (f"\n{answer.explain(columns)}" if explain else "")
    print(shown if first else f"\n{shown}", end="")


def _formulas(words: list[str]) -> Iterator[str]:
    """Those named, and for `-` the lines of standard input, empty ones left out."""
    import sys

    for word in words:
        if word == "-":
            yield from (line.strip() for line in sys.stdin if line.strip())
        else:
            yield word


def _options(options: argparse.Namespace) -> Options:
    """What the options say. Raises BadInputError."""
    from gainproof.answers.possible_filters import Options
    from gainproof.bad_input import BadInputError

    def pairs(option: str, words: list[str], sign: str) -> dict[str, str]:
        found = {}
        for word in words:
            name, there, value = word.partition(sign)
            if not there or not name.strip() or not value.strip():
                raise BadInputError(f"--{option} {word!r}: wanted is NAME{sign} and what it is")
            if name.strip() in found:
                raise BadInputError(f"--{option} {name.strip()} is said twice")
            found[name.strip()] = value.strip()
        return found

    symbols = pairs("symbol", options.symbol, ":")
    conventions = pairs("convention", options.convention, "=")
    return Options(symbols, options.model, options.domain, tuple(options.given), conventions)


def _save(name: str, text: str) -> None:
    from gainproof.claims.new_file import new_file, write_new

    write_new(new_file(name), text)
