"""What the table of public functions holds: arguments, outputs, variants by the forces that act."""

from dataclasses import dataclass, field, replace

WITHIN_1 = "within 1 ulp at every point sampled (claimed bound: 1 ulp; generated/certificates)"


@dataclass(frozen=True)
class Argument:
    """A public argument: its symbol in the ledger, unit, domain (a key of the emitted domain table) and meaning."""

    name: str
    symbol: str
    unit: str
    domain: str
    doc: str


@dataclass(frozen=True)
class Output:
    """A public result.

    ``at_rest`` is its value where friction holds the bead (None: no such state). ``limits`` groups the arguments by
    where the result goes as they grow: arguments of two groups infinite at once leave it undecided, unless one group
    holds both.
    """

    name: str
    unit: str
    doc: str
    at_rest: float | None = None
    limits: tuple = ()


@dataclass(frozen=True)
class Ceiling:
    """The largest value of an argument for which there is a result, where all outputs are one number.

    ``most`` and ``there`` name the functions of the same paper that give the value and the number.
    """

    argument: str
    most: str
    there: str


@dataclass(frozen=True)
class Function:
    """A public function.

    ``positional`` and ``keywords`` are argument names; ``variants`` maps each force set to its force arguments and its
    printed equations (ledger ids). ``routine`` names the function (template.function) that evaluates the whole stable
    form, where that is a matter of cases (an equation to be solved is one of ``solvers``). ``primitive`` names the
    one-variable function that is the whole stable form: its kernels serve. ``domains`` gives the arguments whose domain
    is not that of the table.
    """

    paper: str
    name: str
    doc: str
    positional: tuple
    keywords: tuple
    variants: dict
    outputs: tuple
    accuracy: str = WITHIN_1
    routine: str | None = None
    primitive: str | None = None
    domains: dict = field(default_factory=dict)
    ceiling: Ceiling | None = None

    @property
    def full_name(self):
        """``paper.name``."""
        return f"{self.paper}.{self.name}"

    @property
    def forces(self):
        """Names of all force arguments, in order."""
        return max((names for names, _ in self.variants.values()), key=len)

    def arguments(self, force_set):
        """Return the arguments of one variant, in order."""
        names = (*self.positional, *self.keywords, *self.variants[force_set][0])
        found = (ARGUMENTS[self.paper][name] for name in names)
        return tuple(replace(one, domain=self.domains.get(one.name, one.domain)) for one in found)

    def ledger_id(self, force_set):
        """Return the ledger id of the stable form of one variant."""
        return f"stable.{self.full_name}" + (f".{force_set}" if force_set else "")

    def sources(self, force_set):
        """Return the ledger ids of the printed equations of one variant."""
        return self.variants[force_set][1]


def _arguments(*rows):
    return {name: Argument(name, symbol, unit, domain, doc) for name, symbol, unit, domain, doc in rows}


ARGUMENTS = {
    "chord": _arguments(
        ("t", "t", "s", "nonnegative", "time since release"),
        ("theta", "theta", "rad", "chord angle", "angle of the chord from the vertical, signed, |theta| <= pi/2"),
        ("diameter", "D", "m", "positive", "diameter of the circle"),
        ("g", "g", "m/s^2", "positive", "acceleration of gravity"),
        ("mu", "mu", "1", "nonnegative", "coefficient of sliding friction"),
        ("gamma", "gamma", "1/s", "nonnegative", "drag coefficient over mass"),
    ),
    "projectile": _arguments(
        ("t", "t", "s", "nonnegative", "time since launch"),
        ("theta", "theta", "rad", "elevation", "elevation of the launch from the horizontal, 0 <= theta <= pi/2"),
        ("v", "v", "m/s", "positive", "launch speed"),
        ("g", "g", "m/s^2", "positive", "acceleration of gravity"),
        ("k", "k", "1/s", "nonnegative", "resistance coefficient over mass"),
        ("r", "r", "m", "nonnegative", "range, at most the largest one"),
        ("alpha", "alpha", "1", "nonnegative", "k v/g, resistance at launch speed over weight"),
    ),
    "lambert": _arguments(
        ("x", "q", "1", "branch", "argument of W"),
        ("a", "a", "1/s", "real", "coefficient of t"),
        ("b", "b", "1", "real", "constant term"),
        ("c", "c", "1", "real", "coefficient of the exponential"),
        ("d", "d", "1/s", "real", "rate in the exponential"),
    ),
}
