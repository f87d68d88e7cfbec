"""A scene: which forces act, what is constant, what varies and what is wanted."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path

from galileo_sym.files import write_whole
from galileo_sym.generated._graphs import SYSTEMS
from galileo_sym.scenes import c_source, python_source
from galileo_sym.scenes.arguments import (
    ENDS,
    check_function_name,
    checked_constant,
    checked_lengths,
    checked_names,
    known_name,
    when_it_ends,
)
from galileo_sym.scenes.arrays import Axes, checked_outs
from galileo_sym.scenes.blocks import blocks_of
from galileo_sym.scenes.compiled import compiled
from galileo_sym.scenes.curves import curve_of
from galileo_sym.scenes.explain import explained
from galileo_sym.scenes.numpy_run import evaluate
from galileo_sym.scenes.results import plan_of

EMITTED = {"c": c_source.source, "numpy": python_source.source}


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
        row = SYSTEMS[known_name(system, SYSTEMS, "system", ValueError)]
        over, wanted = (
            checked_names(over, row["arguments"], "axis", system),
            checked_names(outputs, row["outputs"], "output", system),
        )
        for name in constants:
            known_name(name, row["arguments"], f"argument of {system} scenes", TypeError)
        both = [name for name in constants if name in over]
        if both:
            raise ValueError(f"{both[0]} is both an axis and a constant: leave out one of them")
        values = {name: checked_constant(name, constants[name], row) for name in row["arguments"] if name in constants}
        acting = {name: value for name, value in values.items() if value or name not in row["forces"].values()}
        for output in wanted:
            for name in row["outputs"][output]["arguments"]:
                if name not in over and name not in acting:
                    raise ValueError(f"{output} needs {name}: give {name}=, or name it in over=")
        alone, until = isinstance(outputs, str), when_it_ends(until, system, {*over, *acting})
        self.__dict__.update(system=system, over=over, outputs=wanted, until=until, _constants=acting, alone=alone)

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

    @cached_property
    def pointwise_plan(self):
        """What is computed where no value of an axis serves several points: all by the public functions."""
        return self._plan(direct=True, split=False)

    def _plan(self, **ways):
        ending = self.until in ENDS.values()
        return plan_of(self.system, self.over, self._constants, self.outputs, ending=ending, **ways)

    def plan_for(self, laid):
        """Return the plan for axes, an `arrays.Axes`."""
        return self.plan if laid.shares else self.pointwise_plan

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
        argument = forces[known_name(force, forces, f"force of {self.system} scenes", ValueError)]
        constants = {name: value for name, value in self._constants.items() if name != argument}
        over = tuple(axis for axis in self.over if axis != argument)
        return Scene(self.system, over=over, outputs=self._asked, until=self.until, **constants)

    @property
    def _asked(self):
        return self.outputs[0] if self.alone else self.outputs

    def __call__(self, *, grid=True, out=None, **axes):
        """Compute the outputs.

        Parameters
        ----------
        grid : bool, optional
            Whether the outputs are over the outer grid of the axes, with the shapes of these one after the other; else
            the axes broadcast as they are: where no value serves several points, by one call of the public function.
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
        laid = Axes(self.plan, self.checked_axes(axes), grid)
        outs = checked_outs(out, len(self.outputs), laid.shape)
        found = evaluate(self.plan_for(laid), laid.all_values(), outs, laid.dtype)
        found = tuple(array if laid.shape else array[()] for array in found)
        return found[0] if self.alone else found

    blocks = blocks_of
    curve = curve_of

    def checked_axes(self, axes, over=None):
        """Return axes by name if they are those of the scene, or those of some names; else raise TypeError."""
        over = self.over if over is None else over
        missing = [name for name in over if name not in axes]
        for name in axes:
            known_name(name, over, "axis that varies here", TypeError)
        if missing:
            raise TypeError(f"the scene is over {', '.join(self.over)}: give {missing[0]}=")
        return axes

    def compile(self):
        """Return the scene as a function of C, compiled by the system's compiler, and called as the scene is.

        The library is kept in the user's cache folder, by content; two processes may ask for it at once. Where there is
        no compiler the scene itself is returned, with a RuntimeWarning.

        Returns
        -------
        Compiled or Scene
        """
        return compiled(self)

    def emit(self, language, path):
        """Write a self-contained file that computes the scene, and nothing else.

        Parameters
        ----------
        language : str
            ``"c"``: C99 that compiles alone. The function has the name of the file without its ending, and takes for
            each axis its length and values, then work space (of as many bytes as the function of that name and
            ``_work`` tells for the lengths), and where each output is written. ``"numpy"``: a Python module that needs
            NumPy alone; the function of that name takes the axes and returns the outputs.
        path : path
            Of the file; what was there stays until the new one is complete.

        Raises
        ------
        ValueError
            For another language, and where the name of the file is no identifier.
        """
        path = Path(path)
        write = EMITTED[known_name(language, EMITTED, "language of emitted scenes", ValueError)]
        check_function_name(path.stem)
        write_whole(path, write(self.separate_plan, path.stem).encode())

    @cached_property
    def separate_plan(self):
        """What C computes: the plan with steps of its own for every output."""
        return self._plan(direct=False)

    def explain(self, **lengths):
        """Return in words what is computed, over which axes, with how many operations.

        Parameters
        ----------
        **lengths : int, optional
            Of the axes; with them the operations are counted for all elements.
        """
        return explained(self.plan, checked_lengths(self.over, lengths) if lengths else None)

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
        return {axes: dict(counts) for axes, counts in self.plan.cost(checked_lengths(self.over, lengths)).items()}

    def __setattr__(self, name, value):
        raise AttributeError(f"a scene does not change: make one with another {name}")

    def __delattr__(self, name):
        raise AttributeError(f"a scene does not change: {name} stays")

    def _key(self):
        return self.system, self.over, self.outputs, self.until, self.alone, tuple(self._constants.items())

    def __eq__(self, other):
        return self._key() == other._key() if isinstance(other, Scene) else NotImplemented

    def __hash__(self):
        return hash(self._key())

    def __repr__(self):
        more = {} if self.until == when_it_ends(None, self.system, self._known_arguments) else {"until": self.until}
        given = "".join(f", {name}={value!r}" for name, value in {**more, **self._constants}.items())
        return f"Scene({self.system!r}, over={self.over!r}, outputs={self._asked!r}{given})"
