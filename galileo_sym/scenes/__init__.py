"""Scenes: a system, its forces, what varies and what is wanted; nothing that the picture does not show is computed."""

from galileo_sym.scenes.scene import Scene

__all__ = ["Scene"]
