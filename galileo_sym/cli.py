"""The command line: exit 0 if all held, 1 if anything failed, 2 on bad usage."""

from __future__ import annotations

import argparse
import difflib
import os
import re
import sys

from galileo_sym import __version__

OK, FAILED, USAGE = 0, 1, 2

EXAMPLES = """\
examples:
  galileo-sym derive chord.eq21 --show      tell one derivation step by step
  galileo-sym derive projectile --json      the verdicts of a paper, as JSON
  galileo-sym derive --graph -o build       draw what is derived from what
  galileo-sym emit --check                  say what in generated/ differs from what would be emitted now
  galileo-sym verify chord.distance --points 5000
  galileo-sym bench --quick                 run time against error, roughly
  galileo-sym scene chord --over t,theta --outputs x,y --set g=9.81 mu=0.36 --lengths t=1000,theta=1000
  galileo-sym all                           derive, emit, verify
"""


class Parser(argparse.ArgumentParser):
    """An argument parser that names the nearest options and commands when it does not know one."""

    def error(self, message):
        words = [w for w in re.findall(r"[\w-]+", message.split("(choose")[0]) if len(w) > 2]
        near = [m for w in words for m in difflib.get_close_matches(w, _words(self), n=2, cutoff=0.6) if m != w]
        hint = f"; nearest: {', '.join(dict.fromkeys(near))}" if near else ""
        self.print_usage(sys.stderr)
        self.exit(USAGE, f"{self.prog}: {message}{hint}\n")


def _words(grammar):
    """Options and commands of a parser and of those below it."""
    found = []
    for action in grammar._actions:
        found += action.option_strings
        for name, below in (action.choices or {}).items():
            found += [name, *_words(below)]
    return found


def _positive(text):
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a positive number")
    return number


def _listed(text):
    return [word for word in text.split(",") if word]


def _named_number(text):
    name, _, value = text.partition("=")
    try:
        return name, float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a name, '=' and a number") from None


def _settle_output():
    """Write what is left; if that fails let it go nowhere, so that the interpreter does not try again when it ends."""
    try:
        sys.stdout.flush()
    except OSError:
        with open(os.devnull, "w") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())


def parser() -> argparse.ArgumentParser:
    """The grammar of the command line."""
    top = Parser(
        prog="galileo-sym",
        description="Re-derive two papers on motion with resistance, emit NumPy and C code, and check its accuracy.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    top.add_argument("--version", action="version", version=f"galileo-sym {__version__}")
    commands = top.add_subparsers(dest="command", metavar="COMMAND", required=True, parser_class=Parser)

    derive = commands.add_parser("derive", help="rerun derivations, and say what is proved", allow_abbrev=False)
    derive.add_argument("names", nargs="*", metavar="ID|CHAPTER", help="entries or chapters; all if none is given")
    derive.add_argument("--show", action="store_true", help="tell each derivation step by step")
    derive.add_argument("--coverage", action="store_true", help="tables: what of the papers is proved; the errata")
    derive.add_argument("--graph", action="store_true", help="draw what is derived from what: derivations.dot and .svg")
    derive.add_argument("-o", "--output", metavar="DIR", help="write the drawing there instead of here")

    emit = commands.add_parser("emit", help="write generated/, or hold it against its sources", allow_abbrev=False)
    emit.add_argument("--check", action="store_true", help="write nothing; say what differs, exit 1 if anything does")
    emit.add_argument("-o", "--output", metavar="DIR", help="write there instead of generated/")

    verify = commands.add_parser("verify", help="measure errors in ulp against certain references", allow_abbrev=False)
    verify.add_argument("names", nargs="*", metavar="FUNCTION", help="functions, papers, scenes; all if none is given")
    verify.add_argument("--points", type=_positive, metavar="N", help="points to sample in each stratum")
    verify.add_argument("--seed", type=int, metavar="S", help="of the sample")
    verify.add_argument("--stratum", action="append", default=[], metavar="NAME", help="only these strata")
    verify.add_argument("--update", action="store_true", help="renew the certificates")
    verify.add_argument("--typed-in", action="store_true", help="beside it, the printed formulas by lambdify and SciPy")

    bench = commands.add_parser(
        "bench", help="measure run time against error, beside what else there is", allow_abbrev=False
    )
    bench.add_argument("--peers", action="store_true", help="beside it, the printed formulas with other libraries' W")
    bench.add_argument("--functions", nargs="+", default=[], metavar="NAME", help="functions, papers, special; or all")
    bench.add_argument("--rounds", type=_positive, metavar="N", help="interleaved rounds")
    bench.add_argument("--points", type=_positive, metavar="N", help="elements of an array")
    bench.add_argument("--quick", action="store_true", help="fewer rounds, shorter arrays, fewer sampled points")
    bench.add_argument("--growth", action="store_true", help="time arrays from 1 to 1e8 elements")
    bench.add_argument("--strict", action="store_true", help="exit 1 if a target is not held, too")
    bench.add_argument("--publish", action="store_true", help="renew docs/benchmark.md and its plot")
    bench.add_argument("-o", "--output", metavar="DIR", help="write JSON and plot there instead of build/bench")

    scene = commands.add_parser("scene", help="say what a scene computes, or write it as a file", allow_abbrev=False)
    scene.add_argument("system", metavar="SYSTEM", help="chord or projectile")
    scene.add_argument("--over", type=_listed, required=True, metavar="AXIS,...", help="arguments that vary, in order")
    scene.add_argument("--outputs", type=_listed, required=True, metavar="NAME,...", help="what is wanted, in order")
    scene.add_argument(
        "--set", nargs="+", action="extend", type=_named_number, default=[], metavar="NAME=VALUE", help="constants"
    )
    scene.add_argument("--until", metavar="END", help="arrival, landing or forever")
    scene.add_argument("--emit", metavar="LANGUAGE", help="write it as a self-contained file, c or numpy, to PATH")
    scene.add_argument("-o", "--output", metavar="PATH", help="of that file; its name is the function's")
    scene.add_argument("--lengths", type=_listed, metavar="AXIS=N,...", help="of the axes: counts are for all elements")

    everything = commands.add_parser("all", help="derive, emit, verify", allow_abbrev=False)
    for command in (derive, everything):
        command.add_argument(
            "--fresh", action="store_true", help="derive all anew, also what an earlier run has proved"
        )
    for command in (derive, emit, verify, bench, scene, everything):
        command.add_argument("--json", action="store_true", help="print JSON")
    return top


def main(argv: list[str] | None = None) -> int:
    """Run a command.

    Parameters
    ----------
    argv : list of str, optional
        Arguments; by default those of the process.

    Returns
    -------
    int
        0 if all held, 1 if anything failed, 2 on bad usage.
    """
    options = parser().parse_args(argv)
    from galileo_sym import commands  # here: --help and --version load neither SymPy nor mpmath

    try:
        code = commands.COMMANDS[options.command](options)
        sys.stdout.flush()  # here, where a full disk can still be told
        return code
    except commands.UsageError as problem:
        print(f"galileo-sym {options.command}: {problem}", file=sys.stderr)
        return USAGE
    except BrokenPipeError:  # the reader (head, less) has seen enough
        _settle_output()
        return OK
    except OSError as problem:
        _settle_output()
        print(f"galileo-sym {options.command}: {problem}; make room or check permissions, then repeat", file=sys.stderr)
        return FAILED
    except KeyboardInterrupt:
        print(f"galileo-sym {options.command}: interrupted; files are as they were", file=sys.stderr)
        return FAILED
