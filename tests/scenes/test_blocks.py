"""Grids block by block: the bits of a call, memory within what is given, factors once, files and dask arrays."""

import tracemalloc
from collections import Counter

import numpy as np
import pytest
from scene_grids import CASES, OUTPUTS, scene

from galileo_sym import Scene
from galileo_sym.scenes import blocks, kept
from galileo_sym.scenes.arguments import ENDS

SPINDLE = Scene("chord", over=("t", "theta"), outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)
AXES = {"t": np.linspace(0.0, 3.0, 700), "theta": np.linspace(-1.5, 1.5, 300)}
BYTES = 1_000_000


def pieces(scene, max_bytes, axes, **options):
    """Blocks, each as (index, tuple of arrays)."""
    for index, found in scene.blocks(max_bytes=max_bytes, **axes, **options):
        yield index, found if isinstance(found, tuple) else (found,)


def held_against_a_call(scene, max_bytes, axes):
    """Hold blocks against the call; return how many there are."""
    whole = scene(**axes)
    whole = whole if isinstance(whole, tuple) else (whole,)
    seen, count = np.zeros(whole[0].shape, int), 0
    for index, found in pieces(scene, max_bytes, axes):
        seen[index] += 1
        count += 1
        for one, all_of_it in zip(found, whole, strict=True):
            np.testing.assert_array_equal(one, all_of_it[index], strict=True)
    assert np.all(seen == 1)
    return count


@pytest.mark.parametrize(("system", "force_set"), CASES)
def test_blocks_have_the_bits_of_a_call(system, force_set):
    values = {"t": np.linspace(0.0, 4.0, 90), "g": np.array([1.6, 9.8]), "theta": np.linspace(0.0, 1.5, 70)}
    for over in (("t", "theta"), ("theta", "t"), ("t", "g", "theta")):
        axes = {name: values[name] for name in over}
        assert held_against_a_call(scene(system, force_set, OUTPUTS[system], over), 700_000, axes) > 1
    end, late = ENDS[system], {"t": values["t"] - 1, "theta": values["theta"]}
    assert held_against_a_call(scene(system, force_set, ("x", "y"), until=end), 500_000, late)


@pytest.mark.parametrize(
    "times", [np.linspace(0.0, 3.0, 500), np.geomspace(1e-300, 1e300, 60), np.array([-1.0, np.nan, 1.0] * 200)]
)
@pytest.mark.parametrize("over", [("t", "theta"), ("theta", "t")])
def test_memory_stays_within_what_is_given(times, over):
    turned = Scene("chord", over=over, outputs=("x", "y", "X"), g=9.81, mu=0.36, gamma=0.5)
    axes = {"t": times, "theta": AXES["theta"]}
    with np.errstate(all="ignore"):
        for _ in turned.blocks(max_bytes=BYTES, **axes):
            pass
        tracemalloc.start()
        for _, (_x, _y, _centre) in turned.blocks(max_bytes=BYTES, **axes):
            pass
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert BYTES // 8 < peak <= BYTES  # what is imported and made at the first call is there already


def test_factors_are_made_once_whatever_the_blocks(monkeypatch):
    made = Counter()

    def counting(name, function):
        def called(*operands):
            found = function(*operands)
            made[name] += np.size(getattr(found, "hi", getattr(found, "x", None)))
            return found

        return called

    counted = {name: counting(name, function) for name, function in kept.OPERATIONS.items()}
    monkeypatch.setattr(kept, "OPERATIONS", counted)
    for over in (("t", "theta"), ("theta", "t")):
        made.clear()
        turned = Scene("chord", over=over, outputs=("x", "y"), g=9.81, mu=0.36, gamma=0.5)
        assert sum(1 for _ in turned.blocks(max_bytes=BYTES, **AXES)) > 10
        assert (made["phi2m"], made["angle"]) == (700, 300)


def test_the_least_that_does_is_told_and_does():
    with pytest.raises(ValueError, match="the least that does is ") as told:
        SPINDLE.blocks(max_bytes=1000, **AXES)
    least = int(str(told.value).rsplit(" ", 1)[1])
    few = {"t": AXES["t"][:3], "theta": AXES["theta"]}
    assert held_against_a_call(SPINDLE, least, few) >= 3
    with pytest.raises(ValueError, match=f"the least that does is {least}$"):
        SPINDLE.blocks(max_bytes=least - 1, **AXES)
    for wrong, words in ((1e6, "whole number of bytes"), ("1 MB", "whole number of bytes")):
        with pytest.raises(TypeError, match=words):
            SPINDLE.blocks(max_bytes=wrong, **AXES)
    with pytest.raises(TypeError, match="the grid has"):
        SPINDLE.blocks(max_bytes=BYTES, out=(np.empty(3), None), **AXES)
    with pytest.raises(TypeError, match="give theta="):
        SPINDLE.blocks(max_bytes=BYTES, t=AXES["t"])


def test_memory_mapped_outputs_are_in_their_files_after_each_block(tmp_path):
    shape = (700, 300)
    maps = [np.lib.format.open_memmap(tmp_path / f"{name}.npy", "w+", np.float64, shape) for name in "xy"]
    whole = SPINDLE(**AXES)
    times = np.lib.format.open_memmap(tmp_path / "t.npy", "w+", np.float64, (700,))
    times[:] = AXES["t"]
    last = None
    for index, found in pieces(SPINDLE, BYTES, {**AXES, "t": times}, out=tuple(maps)):
        assert all(np.shares_memory(one, target) for one, target in zip(found, maps, strict=True))
        if last is not None:
            assert np.array_equal(np.load(tmp_path / "x.npy", mmap_mode="r")[last], whole[0][last])
        last = index
    for name, wanted in zip("xy", whole, strict=True):
        np.testing.assert_array_equal(np.load(tmp_path / f"{name}.npy"), wanted)
    private = np.memmap(tmp_path / "x.npy", np.float64, "c", 128, shape)
    for _ in SPINDLE.with_outputs("y").blocks(max_bytes=BYTES, out=private, **AXES):
        pass
    np.testing.assert_array_equal(private, whole[1])


def test_dask_arrays_are_computed_chunk_by_chunk_once_each():
    array = pytest.importorskip("dask.array")
    seen = []
    lazy = array.from_array(AXES["t"], chunks=90).map_blocks(lambda part: seen.append(part.size) or part, dtype=float)
    angles = array.from_array(AXES["theta"], chunks=(170, 130))
    whole = SPINDLE(**AXES)
    seen.clear()
    for index, found in pieces(SPINDLE, 3 * BYTES, {"t": lazy, "theta": angles}):
        assert index[0].start // 90 == (index[0].stop - 1) // 90
        assert index[1] in (slice(0, 170), slice(170, 300))
        np.testing.assert_array_equal(found, [one[index] for one in whole])
    assert sum(seen) == 700
    unknown = lazy[lazy > 1.0]
    with pytest.raises(ValueError, match="compute_chunk_sizes"):
        SPINDLE.blocks(max_bytes=BYTES, t=unknown, theta=angles)


def test_empty_grids_single_points_and_arrays_as_they_are():
    assert list(SPINDLE.blocks(max_bytes=BYTES, t=[], theta=[0.1])) == []
    ((index, (x, _)),) = SPINDLE.blocks(max_bytes=BYTES, t=1.0, theta=0.3)
    assert index == ()
    assert x == SPINDLE(t=1.0, theta=0.3)[0]
    t = np.linspace(0.0, 1.0, 60000)
    parts = [found[0] for _, found in pieces(SPINDLE, BYTES, {"t": t, "theta": t}, grid=False)]
    assert len(parts) > 1
    np.testing.assert_array_equal(np.concatenate(parts), SPINDLE(grid=False, t=t, theta=t)[0])


def test_progress_is_told_block_by_block_if_asked_for(monkeypatch):
    told = []

    class Bar:
        def __enter__(self):
            return lambda done, total, label: told.append((done, total))

        def __exit__(self, *error):
            pass

    monkeypatch.setattr(blocks, "progress_bar", lambda title: Bar())
    count = sum(1 for _ in SPINDLE.blocks(max_bytes=BYTES, **AXES))
    assert told == []
    assert sum(1 for _ in SPINDLE.blocks(max_bytes=BYTES, progress=True, **AXES)) == count
    assert told == [(done, count) for done in range(1, count + 1)]
