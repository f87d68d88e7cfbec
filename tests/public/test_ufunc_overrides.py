"""Subclasses of arrays, types with functions of their own, and threads, with the ufuncs of the extension."""

import threading
import time

import numpy as np
import pytest

THETA = np.linspace(-1.2, 1.2, 7)


class Tagged(np.ndarray):
    """A subclass that keeps a tag of its own."""

    def __new__(cls, values, tag):
        made = np.asarray(values).view(cls)
        made.tag = tag
        return made

    def __array_finalize__(self, source):
        self.tag = getattr(source, "tag", None)

    def __array_wrap__(self, array, context=None, return_scalar=False):
        wrapped = np.asarray(array).view(type(self))
        wrapped.tag = f"{self.tag}, {context[0].__name__}"
        return wrapped


class Preferred(Tagged):
    __array_priority__ = 5.0


class Overriding:
    """Takes ufuncs in its own hands."""

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        return ufunc.__name__, method, len(inputs), sorted(options)


class Refusing:
    __array_ufunc__ = None


def test_subclasses(drag):
    found = drag(Tagged(THETA, "mine"))
    assert type(found) is Tagged
    assert found.tag == "mine, chord_distance_drag"
    assert np.array_equal(np.asarray(found), drag(THETA))
    assert type(drag(Tagged(THETA, "mine"), subok=False)) is np.ndarray
    assert type(drag(Tagged(THETA, "a"), Preferred(np.ones(7), "b"))) is Preferred


def test_overrides(drag):
    assert drag(Overriding()) == ("chord_distance_drag", "__call__", 4, [])
    assert drag(THETA, out=Overriding()) == ("chord_distance_drag", "__call__", 4, ["out"])
    with pytest.raises(TypeError, match="does not support ufuncs"):
        drag(Refusing())


def test_the_lock_is_released(lib):
    """While one thread is in a long loop another one runs."""
    x, seen, done = np.full(200_000, 0.3), [], threading.Event()

    def work():
        lib.lambert_linear_exponential_roots(x, x, x, x)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        seen.append(time.perf_counter())
        time.sleep(0.001)
    thread.join()
    assert len(seen) > 3
