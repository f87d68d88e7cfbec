"""The command line: messages and exit codes where something is wrong, and what --json carries."""

import json
import os
import subprocess
import sys

import pytest

FULL_DISK = "/dev/full"


def command(*words, **options):
    run = [sys.executable, "-m", "galileo_sym", *words]
    return subprocess.run(run, stderr=subprocess.PIPE, text=True, check=False, **options)


def shown(*words):
    done = command(*words, stdout=subprocess.PIPE)
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize(("text", "message"), [("abc", "'abc' is not a whole number"), ("0", "0 is not a positive")])
def test_points_that_are_no_number(text, message):
    code, _, err = shown("verify", "--points", text)
    assert code == 2
    assert message in err
    assert "_positive" not in err


@pytest.mark.skipif(not os.path.exists(FULL_DISK), reason=f"this system has no {FULL_DISK}")
@pytest.mark.parametrize("words", [("derive", "chord.eq1"), ("derive", "chord.eq1", "--show", "--json")])
def test_a_full_disk_is_told(words):
    with open(FULL_DISK, "w") as disk:
        done = command(*words, stdout=disk)
    assert done.returncode == 1
    assert done.stderr.startswith("galileo-sym derive: [Errno 28]")
    assert "make room" in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_reader_that_has_seen_enough():
    read, write = os.pipe()
    os.close(read)
    with open(write, "w") as pipe:
        done = command("derive", "chord.eq1", stdout=pipe)
    assert (done.returncode, done.stderr) == (0, "")


def test_json_with_show_carries_the_steps():
    code, out, _ = shown("derive", "chord.eq21", "--show", "--json")
    (row,) = json.loads(out)
    assert code == 0
    assert row["steps"]
    assert all(list(step) == ["text", "statement"] and all(step.values()) for step in row["steps"])
    assert "steps" not in json.loads(shown("derive", "chord.eq21", "--json")[1])[0]


def test_an_update_with_few_points_is_refused():
    code, out, err = shown("verify", "projectile.best_angle", "--update", "--points", "4")
    assert (code, out) == (2, "")
    assert "would weaken the record of projectile.best_angle" in err
