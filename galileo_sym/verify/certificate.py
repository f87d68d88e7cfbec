"""Certificates: what was claimed, what was measured and where it was worst, one JSON file for each public function."""

import json
import math
from pathlib import Path

from galileo_sym.files import write_whole

from .functions import FUNCTIONS
from .measure import as_hex, from_hex
from .strata import strata_names
from .ulp import rounded_up

REMEDY = "run `galileo-sym verify --update` and review what changes"
OTHERS = {"proofs.json", "tables.json", "scenes.json"}  # in the same folder, written by `make prove` and for scenes
_ENTRY_KEYS = ("bound", "measured", "output", "worst", "points", "back_ends")


def entry(function, measurement, points, back_ends):
    """The record of one stratum: claim, sampled maximum rounded up, and the input it was measured at, in hex."""
    return {
        "bound": function.bound,
        "measured": rounded_up(measurement.error),
        "output": measurement.output,
        "worst": as_hex(measurement.worst),
        "points": points,
        "back_ends": list(back_ends),
    }


def certificate(function, entries, seed, date):
    """The certificate of a function.

    Parameters
    ----------
    function : Function
        A row of the table of functions.
    entries : dict of (str, str) to dict
        For each force set and stratum its record, as from `entry`.
    seed : int
        Of the draw.
    date : str
        Day of the update, as YYYY-MM-DD.

    Returns
    -------
    dict
        Keys in a fixed order, force sets and strata in the order of their tables.
    """
    units = {name: function.unit.get(name, "ulp of the exact result") for name in function.outputs}
    return {
        "function": function.full_name,
        "date": date,
        "seed": seed,
        "measured": "sampled maxima, rounded up: the true maximum is at least about as large",
        "unit": units,
        "force_sets": {
            force_set: {
                name: {key: entries[force_set, name][key] for key in _ENTRY_KEYS}
                for name in strata_names(function, force_set)
                if (force_set, name) in entries
            }
            for force_set in function.force_sets
        },
    }


def path_of(folder, full_name):
    """Where a function's certificate is kept."""
    return Path(folder) / f"{full_name}.json"


def _is_number(value):
    """Whether a value from JSON, which has NaN and takes true for no number, is a finite number."""
    return type(value) in (int, float) and math.isfinite(value)


def _fault(function, force_set, record):
    """What is wrong with a record, or None."""
    try:
        worst = from_hex(record["worst"])
        bound, measured, output, _, points, back_ends = (record[key] for key in _ENTRY_KEYS)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as cause:
        return f"unreadable record ({cause!r})"
    if list(worst) != list(function.arguments(force_set)):
        return "its worst input has other arguments than the function"
    if function.outside(worst):
        return f"its worst input lies outside the domain ({', '.join(function.outside(worst))})"
    if not (_is_number(bound) and _is_number(measured)):
        return f"its bound {bound!r} and its measured maximum {measured!r} must be finite numbers"
    if bound > function.bound:
        return f"claims {bound} ulp where the function claims {function.bound}"
    if not 0 <= measured <= bound:
        return f"its measured maximum {measured!r} is not between 0 and its bound {bound!r}"
    if output not in function.outputs or type(points) is not int or points < 1 or not isinstance(back_ends, list):
        return f"unreadable record (output {output!r}, points {points!r}, back_ends {back_ends!r})"
    return None


def _read_records(function, force_sets):
    """Records and faults of the parsed `force_sets` of a certificate."""
    records, faults = {}, []
    for force_set, strata in force_sets.items():
        if force_set not in function.force_sets:
            faults.append(f"{function.full_name}: its certificate names an unknown force set {force_set!r}")
            continue
        known = strata_names(function, force_set)
        for stratum, record in strata.items():
            place = f"{function.full_name} [{force_set}] {stratum}"
            fault = "unknown stratum" if stratum not in known else _fault(function, force_set, record)
            if fault is None:
                records[force_set, stratum] = {**record, "worst": from_hex(record["worst"])}
            else:
                faults.append(f"{place}: {fault}")
        missing = [name for name in known if name not in strata]
        faults.extend(f"{function.full_name} [{force_set}] {name}: not in the certificate" for name in missing)
    absent = [name for name in function.force_sets if name not in force_sets]
    faults.extend(f"{function.full_name} [{name}]: not in the certificate" for name in absent)
    return records, faults


def read(folder, full_name):
    """Read a function's certificate.

    Parameters
    ----------
    folder : Path
        The folder of certificates.
    full_name : str
        The function.

    Returns
    -------
    records : dict of (str, str) to dict
        For each force set and stratum its record, the worst input as floats; only those without fault.
    faults : list of str
        What is missing, unreadable or unknown, each with the remedy.
    """
    path = path_of(folder, full_name)
    try:
        force_sets = json.loads(path.read_text(encoding="utf-8"))["force_sets"]
        records, faults = _read_records(FUNCTIONS[full_name], force_sets)
    except FileNotFoundError:
        records, faults = {}, [f"{full_name}: no certificate"]
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as cause:
        records, faults = {}, [f"{full_name}: unreadable certificate {path.name} ({cause!r})"]
    return records, [f"{fault}; {REMEDY}" for fault in faults]


def stale(folder):
    """Names of certificate files that belong to no function; but for proved bounds and scenes."""
    names = {path.name for path in Path(folder).glob("*.json") if path.stem not in FUNCTIONS}
    return sorted(names - OTHERS)


def write(folder, certificates):
    """Write certificates, each whole or not at all.

    Parameters
    ----------
    folder : Path
        The folder of certificates; made if it is not there.
    certificates : list of dict
        As from `certificate`.
    """
    folder = Path(folder)
    for content in certificates:
        text = json.dumps(content, indent=2) + "\n"
        write_whole(path_of(folder, content["function"]), text.encode())
