"""A scene: which forces act, what is constant, what varies and what is wanted."""

from __future__ import annotations

import difflib
from functools import cached_property
from math import isfinite
from numbers import Real

import numpy as np

from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.generated._kernel import DOMAINS
from galileo_sym.scenes.arrays import axis_arrays, checked_outs
from galileo_sym.scenes.explain import explained
from galileo_sym.scenes.numpy_run import evaluate
from galileo_sym.scenes.results import plan_of

ENDS = {"chord": "arrival", "projectile": "landing"}
_NEVER = "forever"
_WORDS = {
    "positive": "> 0",
    "nonnegative": ">= 0",
    "chord angle": "of size at most pi/2",
    "elevation": "from 0 to pi/2",
}


class Scene:
    """What is to be computed of a motion, and nothing else.

    Parameters
    ----------
    system : str
        ``"chord"``, beads sliding from rest along chords of a vertical circle, or ``"projectile"``.
    over : str or sequence of str
        Arguments that vary: each is an axis of the outputs, in this order.
    outputs : str or sequence of str
        Of chords: ``x``, ``y``, ``distance``, ``speed``, ``descent_time``, and ``X``, ``Y``, ``R`` of the synchronous
        circle. Of projectiles: ``x``, ``y``, ``vx``, ``vy``, ``flight_time``, ``range``. SI units, as the functions of
        `galileo_sym.chord` and `galileo_sym.projectile`.
    until : str, optional
        ``"arrival"``: a bead that has arrived at the end of its chord stays there, and before t = 0 at the top; its
        speed is 0 then. This is so where a diameter is given or varies. ``"landing"``: likewise for a projectile,
        which stays where it comes back to the height of its launch. ``"forever"``: motions have no end, as in the
        public functions; so it is where neither is asked for.
    **constants : float
        The other arguments that the outputs need, in SI units and radians, finite and inside their domains: ``t``,
        ``theta``, ``diameter``, ``g``, ``mu``, ``gamma``, or ``t``, ``theta``, ``v``, ``g``, ``k``. A force that is
        absent or exactly 0 does not act.

    Raises
    ------
    TypeError
        For names that the system does not have, and constants that are no numbers.
    ValueError
        For an output without an argument that it needs, and constants outside their domains.

    Notes
    -----
    Scenes are immutable, compare by what they show, and can be keys. A factor that depends on some axes is computed
    over these alone, in pairs of doubles, and rounded once; a point costs one multiplication an output. Measured error:
    at most 1 ulp more than that of the public function; of y and vy in ulp of the larger term, as there.

    Examples
    --------
    >>> scene = Scene("chord", g=9.81, mu=0.36, over=("t", "theta"), outputs=("x", "y"))
    >>> x, y = scene(t=[0.1, 0.2], theta=[-0.5, 0.0, 0.5])
    >>> x.shape
    (2, 3)
    """

    def __init__(self, system, *, over, outputs, until=None, **constants):
        row = SYSTEMS[_known(system, SYSTEMS, "system", ValueError)]
        over, wanted = _names(over, row["arguments"], "axis", system), _names(outputs, row["outputs"], "output", system)
        for name in constants:
            _known(name, row["arguments"], f"argument of {system} scenes", TypeError)
        both = [name for name in constants if name in over]
        if both:
            raise ValueError(f"{both[0]} is both an axis and a constant: leave out one of them")
        values = {name: _constant(name, constants[name], row) for name in row["arguments"] if name in constants}
        acting = {name: value for name, value in values.items() if value or name not in row["forces"].values()}
        for output in wanted:
            for name in row["outputs"][output]["arguments"]:
                if name not in over and name not in acting:
                    raise ValueError(f"{output} needs {name}: give {name}=, or name it in over=")
        alone, until = isinstance(outputs, str), _until(until, system, {*over, *acting})
        self.__dict__.update(system=system, over=over, outputs=wanted, until=until, _constants=acting, _alone=alone)

    @property
    def constants(self):
        """Constants by name, without forces that do not act."""
        return dict(self._constants)

    @property
    def forces(self):
        """Names of the forces that act."""
        acting = self._known_arguments
        return tuple(force for force, argument in SYSTEMS[self.system]["forces"].items() if argument in acting)

    @property
    def _known_arguments(self):
        return {*self.over, *self._constants}

    @cached_property
    def plan(self):
        """What is computed: a `galileo_sym.scenes.plan.Plan`."""
        return self._plan(direct=True)

    def _plan(self, *, direct):
        ending = self.until in ENDS.values()
        return plan_of(self.system, self.over, self._constants, self.outputs, direct=direct, ending=ending)

    def with_outputs(self, *outputs):
        """Return the scene with other outputs: names, or one sequence of names; a single name gives a single array."""
        wanted = outputs[0] if len(outputs) == 1 else outputs
        return Scene(self.system, over=self.over, outputs=wanted, until=self.until, **self._constants)

    def without(self, force):
        """Return the scene without ``"friction"`` or ``"drag"``: neither as a constant nor as an axis.

        Raises
        ------
        ValueError
            For a force that the system does not have.
        """
        forces = SYSTEMS[self.system]["forces"]
        argument = forces[_known(force, forces, f"force of {self.system} scenes", ValueError)]
        constants = {name: value for name, value in self._constants.items() if name != argument}
        over = tuple(axis for axis in self.over if axis != argument)
        return Scene(self.system, over=over, outputs=self._asked, until=self.until, **constants)

    @property
    def _asked(self):
        return self.outputs[0] if self._alone else self.outputs

    def __call__(self, *, grid=True, out=None, **axes):
        """Compute the outputs.

        Parameters
        ----------
        grid : bool, optional
            Whether the outputs are over the outer grid of the axes, with the shapes of these one after the other; else
            the axes broadcast as they are.
        out : ndarray or tuple of ndarray, optional
            Where the outputs are written, one for each: float64 or float32, of the shape of the result.
        **axes : array_like
            Values along each axis. float64, or float32 where all are; outside its domain an argument gives NaN, with
            NumPy's 'invalid' error state; NaN gives NaN without it.

        Returns
        -------
        ndarray or tuple of ndarray
            One for each output, in their order; the array itself where the scene has one output, by its name alone. An
            output that does not depend on some axis is a read-only view with stride 0 there, unless `out` is given.

        Raises
        ------
        TypeError
            For missing or unknown axes, dtypes that are not supported, and `out` of another shape or type.
        """
        missing = [name for name in self.over if name not in axes]
        for name in axes:
            _known(name, self.over, "axis of this scene", TypeError)
        if missing:
            raise TypeError(f"the scene is over {', '.join(self.over)}: give {missing[0]}=")
        arrays, dtype, shape = axis_arrays(self.plan, axes, grid)
        found = evaluate(self.plan, arrays, checked_outs(out, len(self.outputs), shape), dtype)
        found = tuple(array[()] if not shape else array for array in found)
        return found[0] if self._alone else found

    def explain(self, **lengths):
        """Return in words what is computed, over which axes, with how many operations.

        Parameters
        ----------
        **lengths : int, optional
            Of the axes; with them the operations are counted for all elements.
        """
        return explained(self.plan, _lengths(self.over, lengths) if lengths else None)

    def cost(self, **lengths):
        """Return how many operations a call takes.

        Parameters
        ----------
        **lengths : int
            Of every axis.

        Returns
        -------
        dict
            By axes, a tuple of names: a dict of counts by operation, those of ``transcendental`` functions among them.
        """
        return {axes: dict(counts) for axes, counts in self.plan.cost(_lengths(self.over, lengths)).items()}

    def __setattr__(self, name, value):
        raise AttributeError(f"a scene does not change: make one with another {name}")

    def __delattr__(self, name):
        raise AttributeError(f"a scene does not change: {name} stays")

    def _key(self):
        return self.system, self.over, self.outputs, self.until, self._alone, tuple(self._constants.items())

    def __eq__(self, other):
        return self._key() == other._key() if isinstance(other, Scene) else NotImplemented

    def __hash__(self):
        return hash(self._key())

    def __repr__(self):
        more = {} if self.until == _until(None, self.system, self._known_arguments) else {"until": self.until}
        given = "".join(f", {name}={value!r}" for name, value in {**more, **self._constants}.items())
        return f"Scene({self.system!r}, over={self.over!r}, outputs={self._asked!r}{given})"


def _known(name, names, kind, error):
    """Return a name that is among some; else raise an error that tells the nearest."""
    if name in names:
        return name
    near = difflib.get_close_matches(str(name), names, n=3, cutoff=0.4)
    raise error(f"{name!r} is no {kind}; {f'nearest: {near[0]}; ' if near else ''}there are {', '.join(names)}")


def _names(given, names, kind, system):
    """Names of axes or outputs as a tuple."""
    found = (given,) if isinstance(given, str) else tuple(given)
    for name in found:
        _known(name, names, f"{kind} of {system} scenes", ValueError)
    twice = [name for name in found if found.count(name) > 1]
    if twice:
        raise ValueError(f"{kind} {twice[0]} is named twice: name each once")
    if not found:
        raise ValueError(f"a scene has at least one {kind}: name it")
    return found


def _until(given, system, known):
    """When the motion ends."""
    if given is None:
        return ENDS[system] if "diameter" in known else _NEVER
    _known(given, (ENDS[system], _NEVER), f"end of {system} scenes", ValueError)
    if given == "arrival" and "diameter" not in known:
        raise ValueError("beads arrive at the end of a chord: give diameter=, or name it in over=")
    return given


def _constant(name, value, row):
    """A constant as a double."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, bool | np.bool_) or not isinstance(value, Real):
        raise TypeError(f"{name} is {value!r}, not a number: name it in over= if it varies")
    domain, unit = row["arguments"][name]
    if not (isfinite(value) and DOMAINS[domain][0](np.float64(value))):
        raise ValueError(f"{name} is {value!r} {unit}: it must be finite and {_WORDS[domain]}")
    return float(value)


def _lengths(over, lengths):
    """Lengths of all axes."""
    for name in lengths:
        _known(name, over, "axis of this scene", TypeError)
    for name in over:
        if name not in lengths:
            raise TypeError(f"give the length of every axis: {name}= is missing")
    return lengths
