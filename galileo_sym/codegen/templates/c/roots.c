/* Real roots of a t + b + c exp(d t) = 0 by both branches of W, in T = d t, beta = b d/a and kappa = c d/a.
 *
 * T + beta + kappa exp(T) = 0 has the roots T = -beta - w, w exp(w) = kappa exp(-beta). That argument is never formed
 * where it is large or close to -1/e: log|kappa| - beta and its distance from -1 take its place. Two Newton steps in pairs
 * repair what -beta - w cancels, in S + T + kappa (exp(T) - 1) with S = (b + c) d/a where T is small.
 */
#include "galileo_support.h"

#define GS_UNSURE 0x1p-20 /* share of its terms below which their difference is taken in integers */
#define GS_DOUBLE 0x1p-35 /* distance of w from -1 below which a Newton step would lose more than it gains */
#define GS_LOOKED_UP -2.0 /* log|kappa| - beta below which w comes from its argument, whatever the sign of kappa */
#define GS_CLOSE 0.25   /* distance of -b/c from 1 below which its logarithm is that of 1 - (b + c)/c */
#define GS_STEPS 2

typedef struct {
    gs_scaled beta, kappa, size, log, total, beta_less;
    int negative;
} gs_equation;

/* A double of either sign as a scaled pair. */
static gs_scaled gs_load_signed(double x)
{
    const gs_scaled size = gs_load(fabs(x));
    const gs_scaled r = {copysign(size.hi, x), size.lo, size.e};
    return r;
}

/* beta - 1 - log(-kappa), >= 0 where there are roots for kappa < 0. */
static gs_scaled gs_distance(const gs_equation *eq, double a, double b, double c, double d)
{
    const gs_scaled value = gs_sub(eq->beta_less, eq->log);
    const gs_scaled largest = gs_add(gs_size(eq->beta_less), gs_size(eq->log));
    if (largest.e < 18 && !(gs_sub(gs_size(value), gs_mul(gs_constant(GS_UNSURE), largest)).hi > 0.0))
        return gs_excess(a, b, c, d);
    return value;
}

/* W0(kappa exp(-beta)) where that is small. */
static gs_scaled gs_small(const gs_equation *eq)
{
    const gs_pair e = {gs_inverse_e[0], gs_inverse_e[1]};
    gs_scaled argument = {0.0, 0.0, GS_ZERO_EXPONENT};
    if (gs_plain(eq->beta).hi < GS_FAR)
        argument = gs_mul(eq->kappa, gs_exponential(gs_neg(eq->beta)));
    return gs_principal(argument, gs_add(argument, gs_make(e, 0)));
}

/* T = log(|w|/|kappa|), for |w| >= 2. */
static gs_scaled gs_far_start(const gs_equation *eq, gs_scaled w)
{
    return gs_logarithm(gs_div(w, eq->size));
}

/* One step for T + beta + kappa exp(T) = 0. */
static gs_scaled gs_newton(const gs_equation *eq, gs_scaled t)
{
    int k;
    const gs_pair x = gs_reduce_exponent(t, &k);
    const gs_scaled one = gs_constant(1.0);
    const gs_scaled change = gs_mul(k == 0 ? t : gs_make(x, 0), gs_make(gs_relative_growth(x), 0));
    const gs_scaled power = gs_mul(eq->kappa, gs_scale(gs_add(one, change), k));
    const gs_scaled rest = k == 0 ? gs_add(gs_add(eq->total, t), gs_mul(eq->kappa, change))
                                  : gs_add(gs_add(t, eq->beta), power);
    gs_scaled slope = gs_add(one, power);
    slope.lo = 0.0; /* a double will do */
    return gs_sub(t, gs_div(rest, slope));
}

/* Newton steps, but not where exp(T) is 0 or infinite. */
static gs_scaled gs_polished(const gs_equation *eq, gs_scaled t)
{
    if (fabs(gs_plain(t).hi) >= GS_FAR)
        return t;
    for (int i = 0; i < GS_STEPS; i++)
        t = gs_newton(eq, t);
    return t;
}

/* T by W0, at a distance >= 0 of log|kappa| - beta from -1 where kappa < 0. */
static gs_scaled gs_principal_root(const gs_equation *eq, gs_scaled distance)
{
    const gs_scaled y = gs_sub(eq->log, eq->beta);
    if (eq->negative && gs_add(y, gs_constant(-GS_LOOKED_UP)).hi >= 0.0) {
        const gs_scaled less = gs_principal_offset(distance), start = gs_sub(gs_neg(eq->beta_less), less);
        return gs_plain(less).hi < GS_DOUBLE ? start : gs_polished(eq, start);
    }
    const gs_scaled w = y.hi >= 0.0 && !eq->negative ? gs_wright_omega(y) : gs_small(eq);
    return gs_polished(eq, gs_plain(w).hi >= 2.0 ? gs_far_start(eq, w) : gs_sub(gs_neg(eq->beta), w));
}

/* T by W-1, where kappa < 0. */
static gs_scaled gs_lower_root(const gs_equation *eq, gs_scaled distance)
{
    const gs_scaled more = gs_lower_offset(distance), w = gs_add(gs_constant(1.0), more); /* w is -W-1 */
    const gs_scaled start =
        gs_plain(w).hi >= 2.0 ? gs_far_start(eq, w) : gs_add(gs_neg(eq->beta_less), more);
    return gs_plain(more).hi < GS_DOUBLE ? start : gs_polished(eq, start);
}

/* The roots for nonzero a, c, d. */
static void gs_roots(double a, double b, double c, double d, double *t0, double *tm1)
{
    const gs_scaled A = gs_load_signed(a), B = gs_load_signed(b), C = gs_load_signed(c), D = gs_load_signed(d);
    const gs_scaled rate = gs_div(D, A), zero = {0.0, 0.0, GS_ZERO_EXPONENT};
    gs_equation eq;
    eq.beta = gs_mul(B, rate);
    eq.kappa = gs_mul(C, rate);
    eq.size = gs_size(eq.kappa);
    eq.log = gs_logarithm(eq.size);
    eq.total = gs_mul(gs_add(B, C), rate);
    eq.beta_less = gs_div(gs_sub(gs_mul(B, D), A), A); /* b d is exact: nothing is lost where b d/a is near 1 */
    eq.negative = eq.kappa.hi < 0.0;
    const gs_scaled distance = eq.negative ? gs_distance(&eq, a, b, c, d) : zero;
    const double slope = copysign(1.0, a) * gs_add(A, gs_mul(C, D)).hi; /* sign of 1 + kappa, exactly */
    const int at_0 = b == -c;
    *t0 = *tm1 = NAN;
    if (eq.negative && !(distance.hi >= 0.0))
        return;
    *t0 = gs_store(gs_div(at_0 && slope >= 0.0 ? zero : gs_principal_root(&eq, distance), D));
    if (eq.negative)
        *tm1 = gs_store(gs_div(at_0 && slope <= 0.0 ? zero : gs_lower_root(&eq, distance), D));
}

/* The root where a, c or d is 0; NaN remains where there is none. */
static void gs_degenerate_root(double a, double b, double c, double d, double *t)
{
    const gs_scaled B = gs_load_signed(b), C = gs_load_signed(c), total = gs_add(B, C);
    if (a != 0.0) {
        *t = gs_store(gs_neg(gs_div(total, gs_load_signed(a))));
        return;
    }
    const gs_scaled ratio = gs_neg(gs_div(B, C));
    if (!(ratio.hi > 0.0))
        return;
    const int near = fabs(gs_plain(ratio).hi - 1.0) < GS_CLOSE;
    const gs_scaled value = near ? gs_log_from_excess(gs_neg(gs_div(total, C))) : gs_logarithm(ratio);
    *t = gs_store(gs_div(value, gs_load_signed(d)));
}

void gs_linear_exponential_roots(double a, double b, double c, double d, double *t0, double *tm1)
{
    *t0 = *tm1 = NAN;
    if (isnan(a) || isnan(b) || isnan(c) || isnan(d))
        return;
    if ((a == 0.0 && (c == 0.0 || d == 0.0)) || (isinf(a) != 0) + (isinf(b) != 0) + (isinf(c) != 0) + (isinf(d) != 0) > 1)
        *t0 = *tm1 = gs_invalid();
    else if (a == 0.0 || c == 0.0 || d == 0.0)
        gs_degenerate_root(a, b, c, d, t0);
    else
        gs_roots(a, b, c, d, t0, tm1);
}
