"""Runs of the harness with few points, for tests: what is told and left behind, and changes of a certificate."""

import io
import json

from verify_stand_in import Rounded

from galileo_sym.verify.run import run

POINTS = 6
NAME = "projectile.flight_time"


def verify(folder, *back_ends, names=(NAME,), **options):
    """Exit code and output of a run with few points."""
    out, err = io.StringIO(), io.StringIO()
    options = {"points": POINTS, "processes": 1, "date": "2026-01-02"} | options
    code = run(names, back_ends=list(back_ends) or [Rounded()], certificates=folder, out=out, err=err, **options)
    return code, out.getvalue() + err.getvalue()


def edit(folder, change, name=NAME):
    path = folder / f"{name}.json"
    content = json.loads(path.read_text())
    change(content)
    path.write_text(json.dumps(content))


def rename_stratum(content):
    content["force_sets"]["drag"]["tipical"] = content["force_sets"]["drag"].pop("typical")


def near_zero(force_set, point):
    return force_set == "drag" and 0 < point["theta"] < 2.0**-9
