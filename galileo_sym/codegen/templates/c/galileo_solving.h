/* What solvers on vectors share: a logarithm to begin with, and phi2 in pairs by its power series. */
#ifndef GALILEO_SOLVING_H
#define GALILEO_SOLVING_H

#include "galileo_single.h"

/* log(x), x > 0 and no subnormal, within 1e-9. */
static inline gs_v gs_rough_log(gs_v x)
{
    const gs_v middle = gs_v_of(0x1.6a09e667f3bcdp+1), m = gs_mantissa(x); /* sqrt(8), in [2, 4) */
    const gs_v f = gs_div(gs_sub(m, middle), gs_add(m, middle)), q = gs_mul(f, f);
    gs_v odd = gs_fma(q, gs_v_of(0x1.c71c71c71c71cp-3), gs_v_of(0x1.2492492492492p-2));
    odd = gs_fma(gs_fma(odd, q, gs_v_of(0x1.999999999999ap-2)), q, gs_v_of(0x1.5555555555555p-1));
    odd = gs_fma(odd, q, gs_v_of(2.0)); /* 2 atanh(f)/f */
    return gs_fma(gs_exponent(x), gs_v_of(0x1.62e42fefa39efp-1), gs_fma(odd, f, gs_v_of(0x1.0a2b23f3bab73p+0)));
}

/* log(1 + w)/w, w > 0, within 5e-5. */
static inline gs_v gs_age(gs_v w)
{
    const gs_v one = gs_v_of(1.0), log = gs_rough_log(gs_add(one, w));
    const gs_mask small = gs_less(w, gs_v_of(0.125));
    return gs_div(gs_select(small, gs_fma(w, gs_v_of(0x1.5555555555555p-3), one), log),
                  gs_select(small, gs_fma(w, gs_v_of(0x1.5555555555555p-1), one), w));
}

/* Coefficients of phi2 at -s, GS_SECOND_PAIRS of them as pairs. */
@SERIES@

/* c + s r, |s r| < |c|. */
static inline gs_vp gs_vp_horner(const double c[2], gs_vp s, gs_vp r)
{
    const gs_vp p = gs_vp_mul(s, r), h = gs_vp_sum(gs_v_of(c[0]), p.hi);
    return gs_vp_of(h.hi, gs_add(h.lo, gs_add(gs_v_of(c[1]), p.lo)));
}

/* phi2(-s), |s| < 3/4, to 2^-62: the last terms in plain doubles. */
static inline gs_vp gs_vp_second(gs_vp s)
{
    gs_v tail = gs_v_of(gs_second_series[GS_SECOND_TERMS - 1][0]);
    for (int k = GS_SECOND_TERMS - 2; k >= GS_SECOND_PAIRS; k--)
        tail = gs_fma(s.hi, tail, gs_v_of(gs_second_series[k][0]));
    gs_vp second = gs_vp_load(tail);
    for (int k = GS_SECOND_PAIRS - 1; k >= 0; k--)
        second = gs_vp_horner(gs_second_series[k], s, second);
    return second;
}

#endif
