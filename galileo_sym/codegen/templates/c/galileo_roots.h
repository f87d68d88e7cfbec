/* Real roots of a t + b + c exp(d t) = 0 on vectors, as T = d t: T + beta + kappa exp(T) = 0, beta = b d/a, kappa = c d/a.
 *
 * T = -beta - w with w + log|w| = y = log|kappa| - beta: w > 0 for kappa > 0, else -1 < w < 0 by W0 and w < -1 by W-1.
 * A closed form gives w within 2 percent, a step of the fourth order within 1e-8; then two steps of the third order for
 * T, in plain doubles and in pairs. What cancels in T is mended by T + total + kappa (exp(T) - 1), total = (b + c) d/a.
 * A pair exp(T) that errs by e makes an error of e w/|1 + w| in T; beside a double root the scaled code serves.
 */
#ifndef GALILEO_ROOTS_H
#define GALILEO_ROOTS_H

#include "galileo_solving.h"

#define GS_MOST_BETA 300.0  /* exponentials are ordinary numbers, ... */
#define GS_MOST_KAPPA 0x1p+100
#define GS_LEAST_TOTAL 0x1p-200 /* ... and no root is 0 */
#define GS_CLEARLY 0x1p-8 /* distance of -1 - y from 0: above there are two roots, below none */
#define GS_SHORT 0.375    /* |T| below which exp(T) - 1 is looked at */

typedef struct {
    gs_vp t0, tm1;
} gs_vp_roots_values;

typedef struct {
    gs_v t0, tm1;
} gs_s_roots_values;

/* The equation in plain doubles, its y, and in which lanes kappa < 0. */
typedef struct {
    gs_v beta, kappa, total, log, y;
    gs_mask negative;
} gs_plain_equation;

/* The equation in lanes that are served, another one elsewhere; `none` tells lanes that have no roots. */
static inline gs_plain_equation gs_equation_in(gs_v beta, gs_v kappa, gs_v total, gs_mask *served, gs_mask *none)
{
    const gs_v one = gs_v_of(1.0), zero = gs_v_of(0.0);
    gs_mask here = gs_at_least(gs_v_of(GS_MOST_BETA), gs_abs(beta));
    here = gs_both(here, gs_between(gs_abs(kappa), 1.0 / GS_MOST_KAPPA, GS_MOST_KAPPA));
    here = gs_both(here, gs_at_least(gs_abs(total), gs_v_of(GS_LEAST_TOTAL)));
    const gs_v log = gs_rough_log(gs_abs(gs_select(here, kappa, one)));
    const gs_v distance = gs_sub(gs_sub(gs_select(here, beta, one), log), one);
    const gs_mask negative = gs_less(kappa, zero), two = gs_at_least(distance, gs_v_of(GS_CLEARLY));
    *none = gs_both(here, gs_both(negative, gs_at_least(gs_v_of(-GS_CLEARLY), distance)));
    *served = gs_both(here, gs_either(gs_not(negative), two));
    const gs_plain_equation eq = {gs_select(*served, beta, one), gs_select(*served, kappa, one),
                                  gs_select(*served, total, gs_v_of(2.0)), gs_select(*served, log, zero),
                                  gs_select(*served, gs_sub(gs_v_of(-1.0), distance), gs_v_of(-1.0)),
                                  gs_both(*served, negative)};
    return eq;
}

/* Winitzki's approximations of W0(exp(y)) and, for kappa < 0, W0(-exp(y)). */
static inline gs_v gs_principal_start(const gs_plain_equation *eq)
{
    const gs_v one = gs_v_of(1.0), two = gs_v_of(2.0), past = gs_add(eq->y, one); /* 1 + y */
    const gs_v faded = gs_exp_minus_range0_lean(gs_abs(gs_select(eq->negative, past, eq->y)));
    const gs_v power = gs_select(gs_less(gs_v_of(0.0), eq->y), gs_div(one, faded), faded);
    const gs_v log = gs_mul(power, gs_age(power));
    const gs_v above = gs_mul(log, gs_sub(one, gs_div(gs_mul(log, gs_age(log)), gs_add(two, log))));
    if (!gs_bits_of(eq->negative))
        return above;
    const gs_v root = gs_sqrt(gs_abs(gs_fnma(two, faded, two)));
    const gs_v bent = gs_fma(root, gs_v_of(-0x1.0044324782138p-3), one);
    const gs_v below = gs_div(gs_mul(faded, bent), gs_add(bent, root));
    return gs_select(eq->negative, gs_mul(below, gs_v_of(-1.0)), above);
}

/* W-1(-exp(y)) after Barry and others; another start where kappa > 0. */
static inline gs_v gs_lower_start(const gs_plain_equation *eq, gs_v other)
{
    const gs_v root = gs_sqrt(gs_mul(gs_abs(gs_add(eq->y, gs_v_of(1.0))), gs_v_of(0.5)));
    const gs_v more = gs_div(gs_add(root, root), gs_fma(root, gs_v_of(0.32), gs_v_of(1.0)));
    return gs_select(eq->negative, gs_sub(eq->y, more), other);
}

/* T of w after a step of Fritsch's; by logarithms where w is large. */
static inline gs_v gs_time_of(const gs_plain_equation *eq, gs_v w)
{
    const gs_v one = gs_v_of(1.0), log = gs_rough_log(gs_abs(w)), past = gs_add(one, w);
    const gs_v z = gs_sub(gs_sub(eq->y, w), log);
    const gs_v q = gs_mul(gs_add(past, past), gs_fma(z, gs_v_of(0x1.5555555555555p-1), past));
    const gs_v e = gs_div(gs_mul(z, gs_sub(q, z)), gs_mul(past, gs_fnma(gs_v_of(2.0), z, q)));
    const gs_v grown = gs_mul(e, gs_fma(e, gs_fma(e, gs_v_of(0x1.5555555555555p-2), gs_v_of(-0.5)), one));
    const gs_v far = gs_sub(gs_add(log, grown), eq->log);
    const gs_v near = gs_sub(gs_fma(w, gs_mul(e, gs_v_of(-1.0)), gs_mul(w, gs_v_of(-1.0))), eq->beta);
    return gs_select(gs_less(one, gs_abs(w)), far, near);
}

/* What a step of Halley's takes from T, for a residual and kappa exp(T). */
static inline gs_v gs_halley(gs_v residual, gs_v power)
{
    const gs_v slope = gs_add(gs_v_of(1.0), power), newton = gs_div(residual, slope);
    return gs_div(gs_add(residual, residual), gs_fnma(newton, power, gs_add(slope, slope)));
}

static inline gs_v gs_plain_step(const gs_plain_equation *eq, gs_v t)
{
    const gs_v one = gs_v_of(1.0), size = gs_abs(t), faded = gs_exp_minus_range0_lean(size);
    const gs_mask rising = gs_less(gs_v_of(0.0), t), close = gs_less(size, gs_v_of(GS_SHORT));
    const gs_v grown = gs_select(rising, gs_div(one, faded), faded), power = gs_mul(eq->kappa, grown);
    const gs_v gone = gs_mul(t, gs_s_phi1m(gs_select(close, size, gs_v_of(0.25)))); /* +-(1 - exp(-|t|)) */
    const gs_v change = gs_mul(eq->kappa, gs_mul(gone, gs_select(rising, grown, one)));
    const gs_v residual = gs_select(close, gs_add(gs_add(eq->total, t), change), gs_add(gs_add(t, eq->beta), power));
    return gs_sub(t, gs_halley(residual, power));
}

/* The equation in pairs. */
typedef struct {
    gs_vp beta, kappa, total;
} gs_vp_equation;

/* T + beta + kappa exp(T), and kappa exp(T): for |T| < GS_SHORT by the power series, */
static inline gs_v gs_short_residual(const gs_vp_equation *eq, gs_v t, gs_v *power)
{
    const gs_vp time = gs_vp_load(t), back = gs_vp_load(gs_mul(t, gs_v_of(-1.0)));
    const gs_vp more = gs_vp_add(gs_vp_constant(1.0), gs_vp_mul(time, gs_vp_second(back)));
    const gs_vp change = gs_vp_mul(eq->kappa, gs_vp_mul(time, more));
    *power = gs_add(eq->kappa.hi, change.hi);
    return gs_vp_value(gs_vp_add(gs_vp_add(eq->total, time), change));
}

/* for others by exp(-|T|) */
static inline gs_v gs_long_residual(const gs_vp_equation *eq, gs_v t, gs_v *power)
{
    gs_vp faded;
    faded.hi = gs_exp_minus_range0_pair(gs_abs(t), gs_v_of(0.0), &faded.lo);
    const gs_vp inverse = gs_vp_div(gs_vp_constant(1.0), faded);
    const gs_vp grown = gs_vp_mul(eq->kappa, gs_vp_select(gs_less(gs_v_of(0.0), t), inverse, faded));
    *power = grown.hi;
    return gs_vp_value(gs_vp_add(gs_vp_add(gs_vp_load(t), eq->beta), grown));
}

static inline gs_vp gs_last_step(const gs_vp_equation *eq, gs_v t)
{
    const gs_mask close = gs_less(gs_abs(t), gs_v_of(GS_SHORT));
    gs_v residual, power;
    if (gs_all(close))
        residual = gs_short_residual(eq, t, &power);
    else {
        residual = gs_long_residual(eq, t, &power);
        if (gs_bits_of(close)) {
            gs_v other;
            const gs_v by_series = gs_short_residual(eq, gs_select(close, t, gs_v_of(0.25)), &other);
            residual = gs_select(close, by_series, residual);
            power = gs_select(close, other, power);
        }
    }
    return gs_vp_sum(t, gs_mul(gs_halley(residual, power), gs_v_of(-1.0)));
}

static inline gs_vp gs_vp_root_from(const gs_plain_equation *eq, const gs_vp_equation *pairs, gs_v w, gs_vp d)
{
    return gs_vp_div(gs_last_step(pairs, gs_plain_step(eq, gs_time_of(eq, w))), d);
}

static inline gs_mask gs_is_some(gs_v a, gs_v c, gs_v d)
{
    const gs_v zero = gs_v_of(0.0);
    return gs_both(gs_less(zero, gs_abs(a)), gs_both(gs_less(zero, gs_abs(c)), gs_less(zero, gs_abs(d))));
}

/* Roots by W0 and W-1; NaN where there is none. */
static inline gs_vp_roots_values gs_vp_roots(gs_vp a, gs_vp b, gs_vp c, gs_vp d, gs_mask *good)
{
    const gs_vp one = gs_vp_constant(1.0), nothing = gs_vp_load(gs_v_of(NAN));
    const gs_mask some = gs_is_some(a.hi, c.hi, d.hi);
    const gs_vp unit = gs_vp_select(some, d, one), rate = gs_vp_div(unit, gs_vp_select(some, a, one));
    const gs_v sum = gs_add(b.hi, c.hi);
    const gs_vp beta = gs_vp_mul(b, rate), kappa = gs_vp_mul(c, rate);
    const gs_vp total = gs_vp_mul(gs_vp_of(sum, gs_sum_rest(b.hi, c.hi, sum)), rate);
    gs_mask served, none;
    const gs_plain_equation eq =
        gs_equation_in(gs_vp_value(beta), gs_vp_value(kappa), gs_vp_value(total), &served, &none);
    const gs_vp_equation pairs = {gs_vp_select(served, beta, one), gs_vp_select(served, kappa, one),
                                  gs_vp_select(served, total, gs_vp_constant(2.0))};
    const gs_v w = gs_principal_start(&eq);
    gs_vp_roots_values roots = {gs_vp_root_from(&eq, &pairs, w, unit), nothing};
    if (gs_bits_of(eq.negative))
        roots.tm1 = gs_vp_select(eq.negative, gs_vp_root_from(&eq, &pairs, gs_lower_start(&eq, w), unit), nothing);
    roots.t0 = gs_vp_select(none, nothing, roots.t0);
    *good = gs_both(*good, gs_both(some, gs_either(served, none)));
    return roots;
}

static inline gs_v gs_s_root_from(const gs_plain_equation *eq, gs_v w, gs_v d)
{
    return gs_div(gs_plain_step(eq, gs_time_of(eq, w)), d);
}

static inline gs_s_roots_values gs_s_roots(gs_v a, gs_v b, gs_v c, gs_v d, gs_mask *good)
{
    const gs_v one = gs_v_of(1.0), nothing = gs_v_of(NAN);
    const gs_mask some = gs_is_some(a, c, d);
    const gs_v unit = gs_select(some, d, one), rate = gs_div(unit, gs_select(some, a, one));
    gs_mask served, none;
    const gs_plain_equation eq =
        gs_equation_in(gs_mul(b, rate), gs_mul(c, rate), gs_mul(gs_add(b, c), rate), &served, &none);
    const gs_v w = gs_principal_start(&eq);
    gs_s_roots_values roots = {gs_s_root_from(&eq, w, unit), nothing};
    if (gs_bits_of(eq.negative))
        roots.tm1 = gs_select(eq.negative, gs_s_root_from(&eq, gs_lower_start(&eq, w), unit), nothing);
    roots.t0 = gs_select(none, nothing, roots.t0);
    *good = gs_both(*good, gs_both(some, gs_either(served, none)));
    return roots;
}

#endif
