/* Both real branches of W of pairs, and their distance from -1 in x = -1 - log of minus the argument. */
#include "galileo_support.h"

#define GS_HUGE 100 /* exponent above which log(y) is nothing beside y */
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
