"""The operations that evaluate the primitives, in order: what both languages print, and what the proof replays.

A line is a name, an operation and its operands, which are names, numbers or columns of a table. All operations are
IEEE binary64, and none reads a lane beside its own:

- ``add``, ``sub``, ``mul``, ``div``, ``sqrt``, ``min``, ``max``, ``abs``, ``copy``; ``fma(a, b, c)`` = a b + c,
  ``fnma(a, b, c)`` = c - a b, rounded once;
- ``rest(a, b, s)``, the exact rest of s = a + b rounded where |a| >= |b|, and ``sum_rest(a, b, s)`` wherever;
  ``product_rest(a, b, p)`` = a b - p, rounded once: the exact rest of p = a b rounded;
- ``at_least(a, b)``, ``less(a, b)``, ``both(m, n)``, which give masks, and ``select(m, a, b)``, a where m, b elsewhere;
- ``flip(a, x)``, -a where the sign bit of x is set;
- ``piece(u, first, drop)`` and ``low_index(u)``, the bits of u above the dropped ones less the first, and its last
  four: indices 0 to 15; ``pick(column)`` of piece i, or ``pick(table, index)``;
- ``power(u)`` = 2**-n, n the bits of u above the last four; ``exponent(x)`` = k and ``mantissa(x)`` = m, x = 2**k m,
  2 <= m < 4;
- ``near(bank, x)`` and ``near_pair(bank, x, x_lo)``, an approximation at x or x + x_lo: the line's name is the value,
  and with ``_lo`` its rest.
"""

from dataclasses import dataclass

from galileo_sym.primitives.approximations import APPROXIMATIONS, coefficients


@dataclass(frozen=True)
class Line:
    """``name = operation(*operands)``."""

    name: str
    operation: str
    operands: tuple


def columns(bank):
    """Return {column: values by piece} of an approximation, in the order of evaluation."""
    names = ["centre", "c0", "c0_lo", "c1", "c1_lo"]
    names += [f"c{k}" for k in range(2, APPROXIMATIONS[bank].degree + 1)]
    rows = [(piece.centre, *piece.coefficients) for piece in coefficients(bank)]
    return dict(zip(names, zip(*rows, strict=True), strict=True))


def near_lines(bank, paired):
    """Return the lines that evaluate an approximation at x, or at x + x_lo if paired: the result as r + lo.

    All but the last steps of Horner's rule are in plain arithmetic; the last ones keep what is rounded away.
    """
    partition, degree = APPROXIMATIONS[bank].partition, APPROXIMATIONS[bank].degree
    lines = [
        Line("u", "add", ("x", partition.offset)),
        Line("i", "piece", ("u", partition.first, partition.drop)),
        Line("d", "sub", ("x", ("pick", "centre"))),
        Line(f"q{degree}", "pick", (("pick", f"c{degree}"),)),
    ]
    lines += [Line(f"q{k}", "fma", (f"q{k + 1}", "d", ("pick", f"c{k}"))) for k in range(degree - 1, 1, -1)]
    lines += [
        Line("c1", "pick", (("pick", "c1"),)),
        Line("h", "mul", ("q2", "d")),
        Line("t", "add", ("c1", "h")),
        Line("t_rest", "rest", ("c1", "h", "t")),
        Line("t_lo", "add", ("t_rest", ("pick", "c1_lo"))),
        Line("p", "mul", ("d", "t")),
        Line("p_rest", "product_rest", ("d", "t", "p")),
        Line("p_lo", "fma", ("d", "t_lo", "p_rest")),
    ]
    if paired:  # f(x + x_lo) - f(x), with c1 + 2 h for the slope
        lines += [
            Line("slope", "add", ("t", "h")),
            Line("p_all", "fma", ("x_lo", "slope", "p_lo")),
        ]
    lines += [
        Line("c0", "pick", (("pick", "c0"),)),
        Line("s", "add", ("c0", "p")),
        Line("s_rest", "rest", ("c0", "p", "s")),
        Line("s_lo", "add", ("p_all" if paired else "p_lo", ("pick", "c0_lo"))),
        Line("e", "add", ("s_rest", "s_lo")),
        Line("r", "add", ("s", "e")),
        Line("lo", "rest", ("s", "e", "r")),
    ]
    return lines


def left_of(line, zero):
    """Return what is left of a line where what ``zero`` names is 0: a line, what stands for its name, or None for 0."""
    gone = [operand in zero for operand in line.operands]
    a, *others = line.operands
    if not any(gone):
        return line
    if line.operation == "near_pair":
        return Line(line.name, "near", line.operands[:2])
    if line.operation in ("add", "sub") and not all(gone) and (line.operation == "add" or gone[1]):
        return others[0] if gone[0] else a
    if line.operation in ("fma", "fnma") and (gone[0] or gone[1]) and not gone[2]:
        return others[1]
    if line.operation == "fma" and not (gone[0] or gone[1]):
        return Line(line.name, "mul", line.operands[:2])
    if line.operation == "select" and not all(o == 0.0 or o in zero for o in others):
        return Line(line.name, "select", tuple(0.0 if is_0 else o for o, is_0 in zip(line.operands, gone, strict=True)))
    if line.operation in ("copy", "select", "mul", "div", "flip", "rest", "sum_rest", "product_rest", "fma", "fnma"):
        return None
    raise ValueError(f"what {line} is where {', '.join(o for o in line.operands if o in zero)} is 0 has no rule")


def used(lines):
    """Lines without those whose results nothing needs."""
    needed, kept = {"r", "lo"}, []
    for line in reversed(lines):
        if {line.name, f"{line.name}_lo"} & needed:
            kept.append(line)
            for operand in line.operands:
                needed.update(operand[2:] if isinstance(operand, tuple) else [operand])
    return tuple(kept[::-1])


def alone(lines):
    """Return what is left of lines for x + x_lo where x_lo is 0: those for x, with the same result."""
    zero, instead, found = {"x_lo"}, {}, []
    for line in lines:
        left = left_of(Line(line.name, line.operation, tuple(instead.get(o, o) for o in line.operands)), zero)
        if isinstance(left, Line):
            found.append(left)
        elif line.name in ("r", "lo"):
            found.append(Line(line.name, "copy", (0.0 if left is None else left,)))
        elif left is None:
            zero.add(line.name)
        else:
            instead[line.name] = left
    return used(found)
