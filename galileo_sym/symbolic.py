"""The SymPy expressions behind the public functions, as printed in the papers and in the stable form that is emitted.

``symbolic.chord.descent_time.stable["drag"]`` is an expression in the paper's symbols and the primitives;
``symbolic.chord.descent_time.printed["drag"]`` the printed equations it was shown equal to. Force sets are those of
``symbolic.chord.descent_time.force_sets``.
"""

from types import SimpleNamespace

from galileo_sym.catalogue import FUNCTIONS, ledger, stable

__all__ = ["SymbolicFunction", "chord", "lambert", "projectile"]


class SymbolicFunction:
    """A public function as SymPy expressions.

    Attributes
    ----------
    name : str
        ``paper.function``.
    force_sets : tuple of str
        ``free``, ``friction``, ``drag``, ``friction_drag``, as far as they apply; ``""`` for a function without forces.
    outputs : tuple of str
        Names of the results, in order.
    """

    def __init__(self, function):
        self._function = function
        self.name = function.full_name
        self.force_sets = tuple(function.variants)
        self.outputs = tuple(output.name for output in function.outputs)

    def __repr__(self):
        return f"<SymbolicFunction {self.name}, force sets {', '.join(self.force_sets) or 'none'}>"

    @property
    def stable(self):
        """Stable forms by force set: an expression, or a tuple of them in the order of the outputs."""
        forms = {force_set: stable(self._function, force_set) for force_set in self.force_sets}
        return {force_set: form if len(form) > 1 else form[0] for force_set, form in forms.items()}

    @property
    def printed(self):
        """Printed equations by force set: a tuple of SymPy statements, from the ledger."""
        entries = ledger()
        return {s: tuple(entries[i].printed for i in self._function.sources(s)) for s in self.force_sets}


def _namespace(paper):
    return SimpleNamespace(**{f.name: SymbolicFunction(f) for f in FUNCTIONS.values() if f.paper == paper})


chord = _namespace("chord")
lambert = _namespace("lambert")
projectile = _namespace("projectile")
