"""Evaluation by chunks, so that what is computed on the way stays in the cache whatever the size of the arrays."""

import numpy as np

CHUNK = 15360  # doubles at most: the few arrays in use fit a cache of 1 MB, and each operation has its call repaid

np.empty(
    1 << 22, np.uint8
)  # freed, it teaches glibc to keep memory between chunks rather than map it anew, page by page


def extent(x):
    """The least and the greatest of a vector, or of one number, whose methods are slow."""
    return (x, x) if x.ndim == 0 else (x.min(), x.max())


def _is_chunk(operands):
    """Whether operands are vectors of one length, no longer than a chunk."""
    size = operands[0].size
    return 0 < size <= CHUNK and all(x.shape == (size,) and x.flags.c_contiguous for x in operands)


def _own(found, operands):
    """A result as an array of its own."""
    shape = operands[0].shape
    if np.shape(found) != shape:
        return np.full(shape, found)
    return found.copy() if any(found is x for x in operands) else found


def in_chunks(evaluate, operands, outputs):
    """Return the arrays that a function of contiguous vectors gives of operands that broadcast.

    Parameters
    ----------
    evaluate : callable
        From vectors of equal length, one for each operand, to a tuple of vectors, or of numbers that do not vary.
    operands : sequence of array_like
    outputs : int
        How many vectors there are in the tuple.

    Returns
    -------
    tuple of ndarray
    """
    operands = [np.asarray(x, dtype=np.float64) for x in operands]
    count = len(operands)
    if _is_chunk(operands):
        return tuple(_own(found, operands) for found in evaluate(*operands))
    size = np.broadcast(*operands).size if count > 1 else operands[0].size
    chunks = max(1, -(-size // CHUNK))
    iterator = np.nditer(
        [*operands, *[None] * outputs],
        ["external_loop", "buffered", "zerosize_ok"],
        [["readonly", "aligned", "contig"]] * count + [["writeonly", "allocate", "aligned", "contig"]] * outputs,
        op_dtypes=[np.float64] * (count + outputs),
        buffersize=max(1, -(-size // chunks)),  # of about equal lengths
    )
    with iterator:
        if iterator.itersize:
            for chunk in iterator:
                vectors = chunk if isinstance(chunk, tuple) else (chunk,)
                for target, found in zip(vectors[count:], evaluate(*vectors[:count]), strict=True):
                    target[...] = found
        return iterator.operands[count:]
