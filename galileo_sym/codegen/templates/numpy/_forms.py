"""Forms on pairs, for arguments of ordinary size, chunk by chunk; scaled kernels where they are not."""

import numpy as np

from ._chunks import extent, in_chunks
from ._kernel import quiet
from ._tables import HALF_PI

# Least and greatest ordinary number, whether 0 is one, too, and whether the size alone counts. No term over- or
# underflows, nor what a product leaves; an angle that is used is so far from pi/2 that two doubles of that are enough
# for its cosine.
_SIZES = {
    "positive": (2.0**-100, 2.0**100, False, False),
    "nonnegative": (2.0**-100, 2.0**100, True, False),
    "rate": (0.0, 2.0**100, True, False),
    "chord angle": (2.0**-100, HALF_PI[0] - 2.0**-20, True, True),
    "elevation": (2.0**-100, HALF_PI[0] - 2.0**-20, True, False),
    "chord angle, idle": (-HALF_PI[0], HALF_PI[0], True, False),
}


class Form:
    """A formula on pairs.

    `sizes` tells which arguments are ordinary, the first `positional` of them never values; `arrays` gives the results
    of arrays, `values` of values a function that gives those of the other arguments, or is None; `scaled` is the kernel
    for numbers of any size.
    """

    def __init__(self, sizes, outputs, positional, arrays, values, scaled):
        self.sizes, self.outputs, self.positional = sizes, outputs, positional
        self.arrays, self.values, self.scaled = arrays, values, scaled
        self._last = None, None

    def of_values(self, values):
        """What gives the results of the other arguments; kept for the next chunk, which may come by another call."""
        bits = b"".join(x.tobytes() for x in values)
        known, found = self._last
        if known != bits:
            with quiet():
                found = self.values(*values)
            self._last = bits, found
        return found


class Lanes:
    """Which lanes of a vector a form serves, and in which friction holds the bead; True and None: all, and in none."""

    def __init__(self, good):
        self.good, self.held = good, None

    def keep(self, mask):
        """Take out the lanes where a mask does not hold."""
        self.good = mask if self.good is True else self.good & mask

    def rested(self, value, at_rest):
        """A result, where friction holds that at rest."""
        return value if self.held is None else np.where(self.held, at_rest, value)


def _as_tuple(results):
    return results if isinstance(results, tuple) else (results,)


def _ordinary(x, size):
    """Mask of numbers of ordinary size; True if all are."""
    least, greatest, zero, signed = _SIZES[size]
    x = np.abs(x) if signed else x
    lower, upper = extent(x)
    if least <= lower and upper <= greatest:
        return True
    mask = (x >= least) & (x <= greatest)
    mask = mask | (x == 0.0) if zero else mask
    return True if mask.all() else mask


def _evaluate(form, each, arguments, places):
    """Results of a chunk: of arguments of which those at the places are vectors."""
    with quiet():
        good = True
        for place in places:
            mask = _ordinary(arguments[place], form.sizes[place])
            good = mask if good is True else good if mask is True else good & mask
        lanes, found = Lanes(good), ()
        if good is True:
            found = each(*arguments, lanes)
        elif good.any():
            found = each(*(np.where(good, x, 1.0) if i in places else x for i, x in enumerate(arguments)), lanes)
    if lanes.good is True or np.all(lanes.good):
        return found
    good = np.broadcast_to(lanes.good, arguments[places[0]].shape)  # what tells it may not vary
    return _mended(form, found, good, arguments, places)


def _mended(form, found, good, arguments, places):
    """Results with those of the scaled kernel in the lanes that are not good."""
    lost = np.flatnonzero(~good)
    results = _as_tuple(form.scaled(*(x[lost] if i in places else x for i, x in enumerate(arguments))))
    mended = []
    for number, result in enumerate(results):
        full = np.empty(good.shape)
        if found:
            full[...] = found[number]
        full[lost] = result
        mended.append(full)
    return mended


def _each(form, arguments, places):
    """What gives a chunk's results: if all that vary are positional, what depends on the others is computed now."""
    if form.values is None or max(places) >= form.positional:
        return form.arrays
    each = form.of_values(arguments[form.positional :])
    return lambda *given: each(*given[: form.positional], given[-1])


def serve(form, arguments):
    """Results of a form for arguments that broadcast: an array, or a tuple of arrays."""
    arrays = [np.asarray(x, dtype=np.float64) for x in arguments]
    shape = np.broadcast(*arrays).shape
    places = [i for i, x in enumerate(arrays) if x.size != 1] or list(range(len(arrays)))
    vectors = [arrays[i] for i in places]
    fixed = [x if i in places else x.reshape(-1)[0] for i, x in enumerate(arrays)]
    ordinary = all(_ordinary(x, size) is True for x, size in zip(fixed, form.sizes, strict=True) if x.ndim == 0)
    each = _each(form, fixed, places) if ordinary else None

    def evaluate(*chunk):
        arguments = list(fixed)
        for place, vector in zip(places, chunk, strict=True):
            arguments[place] = vector
        if each is None:
            return _as_tuple(form.scaled(*arguments))
        return _evaluate(form, each, arguments, places)

    results = tuple(x.reshape(shape) for x in in_chunks(evaluate, vectors, form.outputs))
    return results if form.outputs > 1 else results[0]
