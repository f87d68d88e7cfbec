"""Coefficients as they are committed: a line a piece, in hexadecimal, so that nothing is rounded on the way."""

from galileo_sym.primitives.pieces import Piece

_COLUMNS = "# a line a piece: centre, c0, its rest, c1, its rest, c2, c3, ..."


def to_text(head, pieces):
    """Return the committed form of pieces, below lines that say what they are of and what makes them."""
    rows = [" ".join(v.hex() for v in (piece.centre, *piece.coefficients)) for piece in pieces]
    return "\n".join([*(f"# {line}" for line in head), _COLUMNS, *rows]) + "\n"


def read(path):
    """Return the committed pieces; their ``error`` is not kept, and 0.

    Raises
    ------
    FileNotFoundError
        If they were never made: run ``python -m galileo_sym.primitives.remake``.
    """
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = [[float.fromhex(v) for v in line.split()] for line in lines if not line.startswith("#")]
    return tuple(Piece(row[0], tuple(row[1:]), 0.0) for row in rows)
