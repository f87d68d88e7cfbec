/* Exponential and logarithm of scaled pairs as scaled pairs, about 2^-96 relative: series, no table. */
#include "galileo_support.h"

#define GS_HALVINGS 8
#define GS_ATANH_PAIRS 11 /* terms that need two doubles */
#define GS_GROWTH_PAIRS 5
#define GS_TINY 0x1p-60 /* its square is nothing beside 1, and might underflow */
#define GS_ROOT_HALF 0.7071067811865476
#define GS_LOG_OF_INFINITE (1 << 19) /* exponent: infinite, yet below any infinite argument */

/* Series in x: in doubles as long as the terms are small, then in pairs. */
static gs_pair gs_horner(const double (*rows)[2], int count, int pairs, gs_pair x)
{
    double tail = rows[count - 1][0];
    for (int i = count - 2; i >= pairs; i--)
        tail = tail * x.hi + rows[i][0];
    gs_pair sum = {tail, 0.0};
    for (int i = pairs - 1; i >= 0; i--) {
        const gs_pair row = {rows[i][0], rows[i][1]};
        sum = gs_pair_add(row, gs_pair_mul(sum, x));
    }
    return sum;
}

/* (exp(x) - 1)/x for |x| <= log(2)/2: at x/2^8 by its series, then doubled 8 times. */
gs_pair gs_relative_growth(gs_pair x)
{
    x.hi = ldexp(x.hi, -GS_HALVINGS);
    x.lo = ldexp(x.lo, -GS_HALVINGS);
    gs_pair sum = gs_horner(gs_growth, GS_GROWTH_TERMS, GS_GROWTH_PAIRS, x);
    for (int i = 0; i < GS_HALVINGS; i++) {
        const gs_pair half = {ldexp(x.hi, i - 1), ldexp(x.lo, i - 1)};
        sum = gs_pair_add(sum, gs_pair_mul(gs_pair_mul(sum, sum), half));
    }
    return sum;
}

/* The k and r with t = k log(2) + r, |r| <= log(2)/2, for |t| <= 2^16. */
gs_pair gs_reduce_exponent(gs_scaled t, int *count)
{
    const gs_pair x = gs_plain(t);
    const double k = rint(x.hi * (1.0 / gs_log_2[0]));
    const gs_pair head = {-k * gs_log_2[0], 0.0};
    gs_pair tail = gs_two_prod(-k, gs_log_2[1]);
    tail.lo = tail.lo - k * gs_log_2[2];
    *count = (int)k;
    return gs_pair_add(gs_pair_add(x, head), tail);
}

/* exp(t), |t| <= 2^16. */
gs_scaled gs_exponential(gs_scaled t)
{
    int k;
    const gs_pair x = gs_reduce_exponent(t, &k), one = {1.0, 0.0};
    return gs_make(gs_pair_add(one, gs_pair_mul(x, gs_relative_growth(x))), k);
}

/* log(1 + f), sqrt(1/2) <= 1 + f <= sqrt(2): 2 atanh(f/(2 + f)). */
gs_scaled gs_log_from_excess(gs_scaled f)
{
    const gs_scaled z = gs_div(f, gs_add(gs_constant(2.0), f));
    gs_pair x = gs_plain(z);
    if (fabs(x.hi) < GS_TINY)
        x.hi = x.lo = 0.0;
    const gs_pair series = gs_horner(gs_atanh, GS_ATANH_TERMS, GS_ATANH_PAIRS, gs_pair_mul(x, x));
    return gs_scale(gs_mul(z, gs_make(series, 0)), 1);
}

/* log(a), a > 0; infinite, but below any infinite argument, where a is an infinite argument or its inverse. */
gs_scaled gs_logarithm(gs_scaled a)
{
    int shift;
    const double m = frexp(a.hi, &shift);
    shift -= m < GS_ROOT_HALF;
    const int k = a.e + shift;
    if (k >= GS_LIMIT || k <= -GS_LIMIT) {
        const gs_scaled infinite = {copysign(0.5, k), 0.0, GS_LOG_OF_INFINITE};
        return infinite;
    }
    const gs_pair excess = gs_two_sum(ldexp(a.hi, -shift), -1.0);
    const gs_scaled near =
        gs_log_from_excess(gs_make(gs_fast_two_sum(excess.hi, excess.lo + ldexp(a.lo, -shift)), 0));
    if (k == 0)
        return near;
    const double x = k;
    const gs_pair head = {x * gs_log_2[0], 0.0};
    gs_pair tail = gs_two_prod(x, gs_log_2[1]);
    tail.lo = tail.lo + x * gs_log_2[2];
    return gs_add(gs_make(gs_pair_add(head, tail), 0), near);
}
