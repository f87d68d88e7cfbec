"""Certain references of the launch angles: the impact times that reach a range, and the elevations that belong to them.

With T = k t at the impact, the printed equations are sin(theta) = (T/(1 - exp(-T)) - 1)/alpha, alpha = k v/g, and
k r/v = cos(theta) (1 - exp(-T)). The square of the range rises with T up to its maximum and falls from there on, so a
rise through (k r/v)**2 encloses the low shot and a fall the high one.
"""

from fractions import Fraction

from mpmath import libmp, mp

from .enclosure import CONTEXT, ZERO, Undecided, arctangent, decay, enclosure, number

_GUESS_BITS = 200
_HALVINGS = 90
_STEEP = 2.0**40  # conditions beyond which an error is measured against what the arguments' own roundings do


def _square(time, lift):
    """(k r/v)**2 at an impact time, and its derivative over 2 (1 - exp(-T))."""
    fading, lost, lag = decay(time)
    height = lag / lift
    return lost * lost - height * height, fading - lag / (lift * lift)


def _guess_decay(time):
    """exp(-T), 1 - exp(-T) and T - 1 + exp(-T), without loss, in ordinary multiprecision."""
    lost = -mp.expm1(-time)
    if time > 2**-20:
        return 1 - lost, lost, time - lost
    return 1 - lost, lost, time**2 / 2 * (1 - time / 3 * (1 - time / 4 * (1 - time / 5 * (1 - time / 6))))


def _guess_best(lift):
    """The impact time of the largest range, nearly: by Theorem 3."""
    if lift < mp.mpf(2) ** -40:
        return mp.sqrt(2) * lift * (1 - mp.sqrt(2) / 3 * lift)
    return 1 + mp.lambertw((lift**2 - 1) / mp.e).real


def _guess(lift, pull, low):
    """An impact time close to the root, by halving the interval between its bounds, geometrically where it is wide."""
    best = _guess_best(lift)
    bottom, top = (pull, best) if low else (best, min(1 + lift, 2 * lift))
    if bottom >= top:
        return best
    for _ in range(_HALVINGS):
        middle = mp.sqrt(bottom * top) if top > 2 * bottom else (bottom + top) / 2
        _, lost, lag = _guess_decay(middle)
        above = (lost - lag / lift) * (lost + lag / lift) > pull**2
        if above == low:
            top = middle
        else:
            bottom = middle
    return middle


def _middle(interval):
    """An interval's lower end as an ordinary multiprecision number."""
    return mp.make_mpf(interval._mpi_[0])


def _impact(lift, pull, low):
    """Enclosure of the impact time of the low or the high shot, with lift = k v/g and pull = k r/v."""
    with mp.workprec(_GUESS_BITS):
        near = CONTEXT.make_mpf((_guess(_middle(lift), _middle(pull), low)._mpf_,) * 2)
    target = pull * pull
    for _ in range(CONTEXT.prec.bit_length()):  # Newton's method doubles the digits
        value, slope = _square(near, lift)
        step = (value - target) / (2 * decay(near)[1] * slope)
        near = _point(near - step)
    half = CONTEXT.make_mpf((libmp.from_man_exp(1, -CONTEXT.prec // 2),) * 2)
    ends = _point(near * (1 - half)), _point(near * (1 + half))
    below, above = (_square(end, lift)[0] - target for end in (ends if low else ends[::-1]))
    if not (below.b < 0 < above.a):
        raise Undecided("no sign of the range at an end of the bracket")
    return ends


def _point(x):
    middle = libmp.mpf_shift(libmp.mpf_add(*x._mpi_), -1)
    middle = libmp.mpf_pos(middle, CONTEXT.prec, libmp.round_nearest)
    return CONTEXT.make_mpf((middle, middle))


def _with_resistance(r, v, g, k):
    lift, pull = number(k) * number(v) / number(g), number(k) * number(r) / number(v)
    angles = []
    for low in (True, False):
        ends = _impact(lift, pull, low)
        lags = [decay(end)[2] for end in ends]
        lag = CONTEXT.make_mpf((lags[0]._mpi_[0], lags[1]._mpi_[1]))
        angle = arctangent(lag / (lift * pull))
        angles.append(enclosure(angle, _unit(angle, ends[0], lift, pull)))
    return tuple(angles)


def _unit(angle, time, lift, pull):
    """What errors are measured against where the angle follows the range over 2**40 times: that share of its change."""
    _, lost, lag = decay(time)
    _, slope = _square(time, lift)
    of_tangent = pull * pull / (slope * lag) - 1  # by the logarithms of both
    share = abs(of_tangent * lag * pull / (lost * lost * lift * angle))
    return angle * share / _STEEP if share.a > _STEEP else None


def _without_resistance(r, v, g):
    """sin(2 theta) = g r/v**2."""
    sine = number(g) * number(r) / (number(v) * number(v))
    if Fraction(g) * Fraction(r) == Fraction(v) ** 2:
        return (enclosure(arctangent(number(1))),) * 2
    rest = 1 - sine * sine
    if not rest.a > 0:
        raise Undecided("whether the range is beyond the largest needs more bits")
    cosine = CONTEXT.sqrt(rest)
    return enclosure(arctangent(sine / (1 + cosine))), enclosure(arctangent((1 + cosine) / sine))


def _launch_angles(r, v, g, k):
    """Both elevations at which the range is r; r below the largest range, as a real number.

    Raises
    ------
    Undecided
        If the bits do not suffice; above the largest range none do.
    """
    if r == 0:
        right = arctangent(number(1))
        return ZERO, enclosure(2 * right)
    return _with_resistance(r, v, g, k) if k else _without_resistance(r, v, g)


EQUATIONS = {"projectile.launch_angles": _launch_angles}
