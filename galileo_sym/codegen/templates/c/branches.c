/* Both real branches of W, and their distance from -1 in x = -1 - log of minus the argument. */
#include "galileo_support.h"

#define GS_HUGE 100   /* exponent above which log(y) is nothing beside y */
#define GS_NEAR -0.26 /* below it -e x is nearer 1 than sqrt(1/2) */
#define GS_CLOSE_BY 0x1p-12 /* below it s - log(1 + s) cancels more than a Newton step gains */

/* A table at a scaled pair >= 0; 0 where it has ended. */
static int gs_at(const gs_table *table, gs_scaled x, gs_scaled *value)
{
    const gs_pair u = gs_plain(x);
    if (u.hi >= table->x_max)
        return 0;
    *value = gs_make(gs_lookup(table, u.hi, u.lo), 0);
    return 1;
}

/* w with w + log(w) = y >= 0: a table, or y - log(y), and a Newton step. */
gs_scaled gs_wright_omega(gs_scaled y)
{
    const gs_scaled one = gs_constant(1.0);
    gs_scaled w;
    if (y.e > GS_HUGE)
        return y;
    if (!gs_at(&gs_wright_omega_table, y, &w))
        w = gs_sub(y, gs_logarithm(y));
    return gs_div(gs_mul(w, gs_sub(gs_add(one, y), gs_logarithm(w))), gs_add(one, w));
}

/* W0(x) = x exp(-W0(x)) for x in [-1/e, 1], above = x + 1/e: regular in sqrt(2 e above). */
gs_scaled gs_principal(gs_scaled x, gs_scaled above)
{
    const gs_pair e = {gs_e[0], gs_e[1]};
    const gs_pair u = gs_plain(gs_sqrt(gs_scale(gs_mul(gs_make(e, 0), above), 1)));
    return gs_mul(x, gs_make(gs_lookup(&gs_principal_table, u.hi, u.lo), 0));
}

/* 1 + W0(-exp(-1 - x)), x >= 0. */
gs_scaled gs_principal_offset(gs_scaled x)
{
    gs_scaled factor;
    if (x.hi == 0.0)
        return gs_constant(0.0);
    const gs_scaled p = gs_sqrt(gs_scale(x, 1));
    return gs_at(&gs_w0_offset_table, p, &factor) ? gs_mul(p, factor) : gs_constant(1.0);
}

/* -1 - W-1(-exp(-1 - x)), x >= 0: s with s - log(1 + s) = x, by a table or x + log(x), and a Newton step. */
gs_scaled gs_lower_offset(gs_scaled x)
{
    const gs_scaled one = gs_constant(1.0);
    gs_scaled s;
    if (x.hi == 0.0)
        return gs_constant(0.0);
    if (x.e > GS_HUGE)
        return x;
    const gs_scaled p = gs_sqrt(gs_scale(x, 1));
    if (gs_at(&gs_wm1_offset_table, p, &s)) {
        s = gs_mul(p, s);
        if (gs_plain(p).hi < GS_CLOSE_BY)
            return s;
    } else
        s = gs_add(x, gs_logarithm(x));
    const gs_scaled gap = gs_sub(gs_sub(s, gs_logarithm(gs_add(one, s))), x);
    return gs_sub(s, gs_div(gs_mul(gap, gs_add(one, s)), s));
}

/* x + 1/e, exact but for the last rounding of a pair. */
static gs_scaled gs_above(double x)
{
    const gs_pair rest = {gs_inverse_e[1], gs_inverse_e[2]};
    return gs_make(gs_pair_add(gs_two_sum(x, gs_inverse_e[0]), rest), 0);
}

double gs_w0(double x)
{
    if (isnan(x) || x == 0.0)
        return x;
    if (!gs_branch(x))
        return gs_invalid();
    const gs_scaled argument = gs_load(x);
    if (x >= 1.0)
        return gs_store(gs_wright_omega(gs_logarithm(argument)));
    const gs_scaled w = gs_principal(argument, gs_above(x)), one = gs_constant(1.0);
    const gs_scaled gap = gs_sub(w, gs_mul(argument, gs_exponential(gs_neg(w)))); /* for a Newton step */
    return gs_store(gs_sub(w, gs_div(gap, gs_add(one, w))));
}

double gs_wm1(double x)
{
    const gs_pair e = {gs_e[0], gs_e[1]};
    gs_scaled distance;
    if (isnan(x))
        return x;
    if (!gs_lower_branch(x))
        return gs_invalid();
    if (x == 0.0) {
        feraiseexcept(FE_DIVBYZERO);
        return -INFINITY;
    }
    if (x < GS_NEAR)
        distance = gs_neg(gs_log_from_excess(gs_neg(gs_mul(gs_make(e, 0), gs_above(x)))));
    else
        distance = gs_sub(gs_neg(gs_logarithm(gs_load(-x))), gs_constant(1.0));
    return gs_store(gs_neg(gs_add(gs_constant(1.0), gs_lower_offset(distance))));
}
