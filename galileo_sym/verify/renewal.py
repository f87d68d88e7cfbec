"""Renewing certificates: when it is refused, and what is written."""

from . import certificate
from .functions import FUNCTIONS
from .selection import select_strata
from .strata import fixed_strata


class RefusedUpdateError(Exception):
    """An update would leave a certificate with holes, or replace a record by a weaker one; the message says which."""


def _shown(place):
    return "{} [{}] {}".format(*place)


def require_sound_update(chosen, records, points, default_points):
    """Refuse an update after which a certificate would be worth less than before.

    Parameters
    ----------
    chosen : list of tuple
        The strata to be measured, as (function, force set, stratum).
    records : dict
        The records of the functions' certificates that are without fault, by the same triples.
    points, default_points : int
        Points to be drawn in each stratum; the number below which no new record is made.

    Raises
    ------
    RefusedUpdateError
        If a stratum is neither measured nor recorded, or is to be measured with fewer than the default points although
        its record has more, or there is no record.
    """
    functions = list(dict.fromkeys(name for name, _, _ in chosen))
    holes = [place for place in select_strata(functions, ()) if place not in chosen and place not in records]
    if holes:
        raise RefusedUpdateError(
            f"--update of single strata needs a whole certificate, and {_shown(holes[0])} has no sound record "
            f"({len(holes)} such); renew all strata: leave --stratum out"
        )
    if points >= default_points:
        return
    for place in chosen:
        name, force_set, stratum = place
        known = records[place]["points"] if place in records else default_points
        if points < known and stratum not in fixed_strata(FUNCTIONS[name], force_set):
            raise RefusedUpdateError(
                f"--update with {points} points would weaken the record of {_shown(place)}; "
                f"it takes {min(known, default_points)} points at least: leave --points out"
            )


def renew(folder, outcomes, records, back_ends, seed, date):
    """Write the certificates of the functions that held, strata not measured now taken over from the old ones.

    Parameters
    ----------
    folder : Path
        The folder of certificates.
    outcomes : dict
        What `judge` returned for each (function, force set, stratum).
    records : dict
        Earlier records, by the same triples.
    back_ends : list
        What was measured.
    seed : int
        Of the draw.
    date : str
        Day of the update.

    Returns
    -------
    list of str
        Full names of the functions whose certificates were written.
    """
    failed = {rows[0].function for rows, _ in outcomes.values() if any(row.failed for row in rows)}
    entries = {name: {} for name, _, _ in outcomes if name not in failed}
    for (name, force_set, stratum), old in records.items():
        if name in entries:
            entries[name][force_set, stratum] = {**old, "worst": certificate.as_hex(old["worst"])}
    for (name, force_set, stratum), (rows, worst) in outcomes.items():
        if name in entries:
            names = [back_end.name for back_end in back_ends]
            record = certificate.entry(FUNCTIONS[name], worst, rows[0].points, names)
            entries[name][force_set, stratum] = record
    renewed = [certificate.certificate(FUNCTIONS[name], found, seed, date) for name, found in entries.items()]
    certificate.write(folder, renewed)
    return [content["function"] for content in renewed]
