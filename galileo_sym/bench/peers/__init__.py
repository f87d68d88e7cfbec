"""Peers: the printed formulas compiled with other libraries' Lambert W, each if its tools are on this machine."""

from .build import PEERS, Peer, peers

__all__ = ["PEERS", "Peer", "peers"]
