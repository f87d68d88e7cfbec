"""Evaluation by chunks, so that what is computed on the way stays in the cache whatever the size of the arrays."""

import numpy as np

CHUNK = 15360  # doubles at most: the few arrays in use fit a cache of 1 MB, and each operation has its call repaid


def in_chunks(evaluate, operands, outputs):
    """Return the arrays that a function of contiguous vectors gives of operands that broadcast.

    Parameters
    ----------
    evaluate : callable
        From vectors of equal length, one for each operand, to a tuple of vectors, or of numbers that do not vary.
    operands : sequence of ndarray
        Of float64.
    outputs : int
        How many vectors there are in the tuple.

    Returns
    -------
    tuple of ndarray
    """
    count = len(operands)
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
