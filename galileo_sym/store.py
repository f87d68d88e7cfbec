"""Values kept by content from one run to the next, in a file of the user's cache folder."""

from __future__ import annotations

import contextlib
import json
import os
import sqlite3
import sys
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from platformdirs import user_cache_path

FOLDER = "GALILEO_SYM_CACHE"  # environment variable: another folder
FORGET = 90 * 24 * 3600  # seconds after which what nobody asked for goes


def cache_folder() -> Path:
    """Where the package keeps what it need not make again: GALILEO_SYM_CACHE, else the user's cache folder."""
    folder = os.environ.get(FOLDER)
    return Path(folder) if folder else user_cache_path("galileo-sym")


class Store:
    """A table of JSON values by key. If its file cannot be used it says so once, and keeps nothing."""

    def __init__(self):
        self.path = cache_folder() / "findings.sqlite"
        self._works = True

    def get(self, keys: Iterable[str]) -> dict:
        """The values that are known, by key."""
        return self._try(lambda table: _read(table, keys)) or {}

    def put(self, values: Mapping[str, object]) -> None:
        """Keep values, all or none of them, and forget old ones."""
        rows = [(key, json.dumps(value), time.time()) for key, value in values.items()]
        self._try(lambda table: _write(table, rows))

    def _try(self, action: Callable):
        """What an action on the table returns; None if the file cannot be used."""
        if not self._works:
            return None
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with contextlib.closing(sqlite3.connect(self.path, timeout=20)) as connection, connection:
                connection.execute("CREATE TABLE IF NOT EXISTS kept (key TEXT PRIMARY KEY, value TEXT, used REAL)")
                return action(connection)
        except (sqlite3.Error, OSError, ValueError) as problem:
            self._works = False
            remedy = f"remove that file, or name another folder in {FOLDER}"
            print(f"galileo-sym: verdicts are not kept in {self.path}: {problem}; {remedy}", file=sys.stderr)
            return None


def _read(table, keys):
    found = {}
    for key in keys:
        row = table.execute("SELECT value FROM kept WHERE key = ?", (key,)).fetchone()
        if row is not None:
            found[key] = json.loads(row[0])
    table.executemany("UPDATE kept SET used = ? WHERE key = ?", [(time.time(), key) for key in found])
    return found


def _write(table, rows):
    table.executemany("INSERT OR REPLACE INTO kept VALUES (?, ?, ?)", rows)
    table.execute("DELETE FROM kept WHERE used < ?", (time.time() - FORGET,))
