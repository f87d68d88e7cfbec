"""Proved bounds of the error of the emitted primitives: approximation and rounding, from the emitted C itself."""
