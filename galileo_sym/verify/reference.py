"""Certain references: each public function from its printed equation, by ball arithmetic on the exact float inputs.

Nothing here uses the package's primitives, stable forms or emitted code. Implicit results (descent time, flight time,
best angle) are roots of the printed equations, found by Newton's method and then proved by a change of sign.
Every function takes its arguments as floats in SI units and radians, and returns a tuple of `Enclosure`.
"""

from . import chord_equations, lambert_reference, launch_equations, projectile_equations
from .enclosure import certain

_TABLES = (chord_equations, lambert_reference, launch_equations, projectile_equations)
EQUATIONS = {name: equation for table in _TABLES for name, equation in table.EQUATIONS.items()}


def reference(function, arguments):
    """Certain enclosures of the exact results of a public function at float inputs.

    Parameters
    ----------
    function : str
        Full name, such as ``"chord.descent_time"``.
    arguments : dict of str to float
        Every argument by its public name, finite and inside the function's domain; an absent force is 0.0.

    Returns
    -------
    tuple of Enclosure
        One for each output, of relative width below 2**-90 (relative to the larger term where errors are measured so);
        `INFINITE` for the descent time of a bead at rest, `ZERO` for its distance and position, `ABSENT` for a root
        that does not exist.

    Raises
    ------
    KeyError
        For a function without a reference.
    ArithmeticError
        If 40960 bits do not settle the result.
    """
    equation = EQUATIONS[function]
    return certain(lambda: equation(**arguments))
