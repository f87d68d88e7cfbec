"""From a stable form to an ordered list of scaled operations, the same for every language.

A node is a nested tuple (operation, operand, ...) with variable names and numbers at its leaves. Named intermediate
results become assignments; what two outputs share is computed once.
"""

from collections import Counter
from dataclasses import dataclass, field
from functools import reduce

from sympy import Add, Function, Integer, Mul, Number, Pow, Rational, Symbol, cos, exp, pi, sin

from galileo_sym.catalogue import FUNCTIONS, NAMED, PURE, in_catalogue_symbols, stable
from galileo_sym.codegen.products import powers_of, shared_factor
from galileo_sym.primitives import driving, phi1, phi2
from galileo_sym.solvers import SOLVERS

# How each function is called: emitted name, name given to its value or argument.
_OF_ANGLE = {sin: ("sine", "S"), cos: ("cosine", "C"), driving: ("driving", "n")}
_OF_DECAY = {exp: ("fading", "fade"), phi1: ("first", "phi1"), phi2: ("second", "phi2")}  # where a solver meets them
OF_NUMBER = {
    "exp": ("phi0m", "z", -1),
    "phi1": ("phi1m", "z", -1),
    "phi2": ("phi2m", "z", -1),
    "descent_factor": ("descent_factor", "p", 1),
    "flight_factor": ("flight_factor", "b", 1),
    "range_factor": ("range_factor", "b", 1),
    "range_balance": ("range_balance", "b", 1),
    "range_loss": ("range_loss", "b", 1),
    "best_angle": ("best_elevation", None, 1),
    "max_range_factor": ("max_range_factor", "alpha", 1),
    "acot": ("acot", None, 1),
    "best_time": ("best_time", None, 1),
    "atan": ("arctangent", None, 1),
}
TABLE_CALLS = tuple(name for name, _, _ in OF_NUMBER.values() if name != "arctangent")
_COUNTED = {
    "mul": "mul",
    "div": "div",
    "add": "add",
    "sub": "add",
    "sqrt": "sqrt",
    "angle": "sine and cosine",
    "driving": "driving force",
    "decay": "decay",
    "arctangent": "arctangent",
    "launch": "solver",
    **dict.fromkeys(TABLE_CALLS, "table"),
}
_VALUES = {"arctangent": "turn"}  # names of values that several outputs share
_RIGHT_ANGLE = pi / 2


@dataclass
class Limit:
    """Where an argument ends: nodes of its largest value and of the output there; made after so many steps."""

    after: int
    most: tuple
    there: tuple


@dataclass
class Schedule:
    """The plan of one kernel.

    ``loads`` are the symbols of the arguments taken as scaled pairs, in order; ``steps`` (name, node) assignments in
    order; ``results`` one node for each output; ``limit`` says where an argument ends; ``balance`` is the schedule of
    what a solver evaluates in each of its steps, ``names`` the names of its results.
    """

    loads: list = field(default_factory=list)
    steps: list = field(default_factory=list)
    results: list = field(default_factory=list)
    limit: Limit | None = None
    balance: "Schedule | None" = None
    names: tuple = ()

    @property
    def nodes(self):
        """All nodes."""
        ends = [self.limit.most, self.limit.there] if self.limit else []
        return [node for _, node in self.steps] + ends + self.results

    @property
    def counts(self):
        """Return the number of operations of each kind."""
        total = Counter()
        for node in self.nodes:
            _count(node, total)
        return total


def _count(node, total):
    if isinstance(node, tuple):
        if node[0] in _COUNTED:
            total[_COUNTED[node[0]]] += 1
        for operand in node[1:]:
            _count(operand, total)


def _product(nodes):
    """Node of a product, from left to right."""
    return reduce(lambda x, y: ("mul", x, y), nodes)


class _Scheduler:
    def __init__(self, paper, order, in_solver=False):
        self.in_solver = in_solver
        self.schedule = Schedule()
        self.order = {symbol: i for i, symbol in enumerate(order)}
        self.named = [(name, form) for name, forms in NAMED[paper].items() for form in forms]
        self.known = {}
        self.used = set()

    def assign(self, name, expression, node):
        """Give a value a name, once."""
        if expression not in self.known:
            self.schedule.steps.append((name, node))
            self.known[expression] = name
        return self.known[expression]

    def lower(self, expression):
        """Return the node of an expression."""
        if expression in self.known:
            return self.known[expression]
        if expression == _RIGHT_ANGLE:
            return ("right_angle",)
        for kind, method in _LOWERING.items():
            if isinstance(expression, kind):
                return method(self, expression)
        raise TypeError(f"no scaled operation for {expression}: a stable form has products, sums, roots and primitives")

    def symbol(self, expression):
        """Name of an argument, to be loaded."""
        self.used.add(expression)
        return expression.name

    def number(self, expression):
        """Node of a numerical constant."""
        if not expression.is_Rational or Rational(float(expression)) != expression:
            raise TypeError(f"{expression} is not a double: write it as a quotient of ones that are")
        return ("constant", float(expression))

    def function(self, expression):
        """Node of a sine, cosine, driving force or primitive."""
        if expression.func in _OF_ANGLE:
            call, name = _OF_ANGLE[expression.func]
            angle = self.assign("a", ("angle", expression.args[0]), ("angle", expression.args[0].name))
            rest = tuple(self.lower(argument) for argument in expression.args[1:])
            return self.assign(name, expression, (call, angle, *rest))
        if self.in_solver and expression.func in _OF_DECAY:
            call, name = _OF_DECAY[expression.func]
            number = -expression.args[0]
            values = self.assign("d", ("decay", number), ("decay", self.assign("s", number, self.lower(number))))
            return self.assign(name, expression, (call, values))
        if expression.func.__name__ not in OF_NUMBER:
            raise TypeError(f"no emitted function for {expression.func}")
        call, name, sign = OF_NUMBER[expression.func.__name__]
        argument = sign * expression.args[0]
        node = self.lower(argument)
        value = (call, self.assign(name, argument, node) if name and not argument.is_Symbol else node)
        return self.assign(_VALUES[call], expression, value) if call in _VALUES else value

    def sum(self, expression):
        """Node of a sum: positive terms first."""
        terms = sorted(expression.args, key=lambda a: (a.could_extract_minus_sign(), not a.is_Number, str(a)))
        node = self.lower(terms[0])
        for term in terms[1:]:
            minus = term.could_extract_minus_sign()
            node = ("sub" if minus else "add", node, self.lower(-term if minus else term))
        return node

    def product(self, expression):
        """Node of a product or power: named factors first, square roots gathered into one."""
        powers = powers_of(expression)
        for name, form in self.named:
            powers = self._factor_out(name, form, powers)
        whole = {b: e for b, e in powers.items() if e.is_Integer}
        half = {b: 2 * e for b, e in powers.items() if not e.is_Integer}
        node = self._quotient(whole) if whole else None
        if half:
            root = ("sqrt", self._quotient(half))
            node = root if node is None else ("mul", root, node)
        return node

    def _factor_out(self, name, form, powers):
        wanted = {b: e for b, e in powers_of(form).items() if not b.is_Number}
        if not all(b in powers and powers[b] / e >= 1 for b, e in wanted.items()):
            return powers
        left = {b: e - wanted.get(b, 0) for b, e in powers.items()}
        numbers = {b: e for b, e in left.items() if b.is_Number and not e.is_Integer}
        key = Mul(form, *(b**e for b, e in numbers.items()))
        if key not in self.known:
            inside = self.named
            self.named = [pair for pair in inside if pair[0] != name]
            node = self.product(key)
            self.named = inside
            self.assign(name, key, node)
        self.known[Symbol(self.known[key])] = self.known[key]
        rest = {b: e for b, e in left.items() if e != 0 and b not in numbers}
        return {Symbol(self.known[key]): Integer(1), **rest}

    def _rank(self, base):
        if base in self.order:
            return (0, self.order[base], "")
        if base.is_Symbol:
            return (1, 0, base.name)
        return (2 if base.func in _OF_ANGLE else 3, 0, str(base))

    def _quotient(self, powers):
        """Node of a product of integer powers; arguments are divided by arguments: that waits for nothing else."""
        coefficient = reduce(
            lambda x, be: x * be[0] ** be[1], ((b, e) for b, e in powers.items() if b.is_Number), Integer(1)
        )
        bases = sorted((b for b in powers if not b.is_Number), key=self._rank)
        above = [(b, n) for b in bases for n in [self.lower(b)] * max(int(powers[b]), 0)]
        below = [(b, n) for b in bases for n in [self.lower(b)] * max(-int(powers[b]), 0)]
        given = [n for b, n in above if b in self.order] if all(b in self.order for b, _ in below) else []
        over, under = given or [n for _, n in above], [n for _, n in below]
        node = _product(over) if over else None
        if under:
            node = ("div", node or ("constant", 1.0), _product(under))
        made = [n for b, n in above if b not in self.order] if given else []
        return self._scaled(coefficient, _product([node, *made]) if made else node)

    def _scaled(self, coefficient, node):
        if coefficient == 1 or node is None:
            return node or self.number(coefficient)
        odd, twos = coefficient, 0
        while odd.p % 2 == 0:
            odd, twos = odd / 2, twos + 1
        while odd.q % 2 == 0:
            odd, twos = odd * 2, twos - 1
        if odd != 1:
            node = ("mul", self.number(Integer(odd.p)), node)
            node = node if odd.q == 1 else ("div", node, self.number(Integer(odd.q)))
        return ("scale", node, twos) if twos else node


_LOWERING = {
    Symbol: _Scheduler.symbol,
    Number: _Scheduler.number,
    Function: _Scheduler.function,
    Add: _Scheduler.sum,
    Mul: _Scheduler.product,
    Pow: _Scheduler.product,
}


def schedule(function, force_set):
    """Plan one kernel.

    Parameters
    ----------
    function : galileo_sym.catalogue.Function
    force_set : str
        A key of ``function.variants``.

    Returns
    -------
    Schedule

    Raises
    ------
    TypeError
        If the stable form holds something that has no scaled operation.
    """
    forms = stable(function, force_set)
    names = [argument.symbol for argument in function.arguments(force_set)]
    solver = SOLVERS.get((function.full_name, force_set))
    pure = {name: form for name, form in PURE.items() if {s.name for s in form.free_symbols} <= set(names)}
    needed = pure.values() if function.ceiling else forms
    symbols = sorted({s for form in needed for s in form.free_symbols}, key=lambda s: names.index(s.name))
    scheduler = _Scheduler(function.paper, symbols)
    plan = scheduler.schedule
    if function.ceiling:
        scheduler.named += pure.items()
        for name, form in pure.items():
            scheduler.assign(name, form, scheduler.lower(form))
        plan.limit = _limit(function, force_set, scheduler, pure)
    if solver:
        plan.balance = _balance(function.paper, solver)
        routine = balance_name(function, force_set)
        plan.steps.append(("angles", (solver.template, routine, *solver.numbers)))
        plan.names = tuple(output.name for output in function.outputs)
        plan.results = [f"angles.{name}" for name in plan.names]
    else:
        forms = _share(forms, scheduler)
        plan.results = [scheduler.lower(form) for form in forms]
    plan.loads = [s.name for s in symbols if s in scheduler.used]
    return plan


def balance_name(function, force_set):
    """Return the name of the function that a solver evaluates."""
    return f"{function.name}_{force_set}_balance"


def _share(forms, scheduler):
    """Forms with their common factor named."""
    shared = shared_factor(forms)
    if not shared.is_Mul:
        return forms
    symbol = Symbol("shared")
    node = scheduler.lower(shared)
    scheduler.known[symbol] = node if isinstance(node, str) else scheduler.assign("shared", symbol, node)
    return [form / shared * symbol for form in forms]


def _limit(function, force_set, scheduler, pure):
    """Where the argument under a ceiling ends."""
    most, there = (FUNCTIONS[f"{function.paper}.{name}"] for name in (function.ceiling.most, function.ceiling.there))
    (largest,) = stable(most, force_set)
    (output,) = stable(there, "")
    (number,) = output.free_symbols
    scheduler.known[number] = number.name if number.name in pure else ("constant", 0.0)
    nodes = scheduler.lower(largest), scheduler.lower(output)
    return Limit(len(scheduler.schedule.steps), *nodes)


def _balance(paper, solver):
    """Plan what a solver evaluates in each step."""
    forms = solver.balance()
    symbols = {s.name: s for form in forms.values() for s in form.free_symbols}
    scheduler = _Scheduler(paper, [symbols[name] for name in solver.unknown], in_solver=True)
    scheduler.named = [(name, form) for name, make in solver.named.items() for form in [in_catalogue_symbols(make)]]
    plan = scheduler.schedule
    plan.names = tuple(forms)
    plan.results = [scheduler.lower(form) for form in forms.values()]
    return plan
