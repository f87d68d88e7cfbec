"""Premises whose factor the result rightly does not depend on, each with a wrong version that must be noticed."""

from functools import partial

from mutants import opposite, scaled, shifted

# Where doubling a right side rightly changes nothing, another mutant must be noticed.
CENTRE_ALONE = {
    ("chord.claim.centre-accel", "chord.eq9"): partial(scaled, name="g"),
    ("chord.claim.centre-off-axis", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.claim.centre-accel-mu", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.claim.centre-line-angle", "chord.eq21"): partial(scaled, name="mu"),
    ("chord.eq23", "chord.eq21"): partial(scaled, name="mu"),
}
ROOT_ALONE = {
    ("chord.eq13", "chord.eq12"): partial(scaled, name="mu"),
    ("projectile.nodrag.impact", "projectile.nodrag.y"): partial(scaled, name="g"),
    ("projectile.impact.eq", "projectile.drag.y"): partial(scaled, name="g"),
    ("projectile.claim.trivial-root", "projectile.impact.time"): partial(scaled, name="u"),
    ("projectile.limit.rewrite", "projectile.limit.statement"): partial(scaled, name="u"),
    ("projectile.limit.nodrag", "projectile.range.u"): partial(scaled, name="u"),
}
SIGN_ALONE = {
    ("projectile.support.branch-thm3", "projectile.def.alpha"): opposite,
    ("projectile.lemma.c.denominator", "projectile.lemma.c.second"): shifted,
    ("projectile.lemma.d.step1", "projectile.def.uyR"): partial(scaled, name="k"),
    ("projectile.thm2.a", "projectile.lemma.e"): opposite,
    ("projectile.thm2.factor-increasing", "projectile.def.uyR"): partial(scaled, name="k"),
    ("projectile.thm2.stationary", "projectile.lemma.f.second"): partial(scaled, name="k"),
    ("projectile.thm2.stationary", "projectile.thm2.limit-0"): opposite,
    ("projectile.thm2.b", "projectile.lemma.f.second"): opposite,
    ("projectile.mono.inv-increasing", "projectile.mono.deriv2"): opposite,
    ("projectile.mono.inv-increasing", "projectile.mono.alpha2"): shifted,
    ("beyond.pure-flight.best-angle", "beyond.pure-flight.independent"): opposite,
}
SLOPES_ALONE = {  # an equation doubled has doubled slopes
    ("stable.projectile.launch_angles.slopes", "stable.projectile.launch_angles.drag"): partial(scaled, name="alpha"),
}
INVARIANT = {**CENTRE_ALONE, **ROOT_ALONE, **SIGN_ALONE, **SLOPES_ALONE}
