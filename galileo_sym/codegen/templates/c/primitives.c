/* The primitives on scaled pairs: a table near 0, the leading terms beyond it. */
#include "galileo_support.h"

#define GS_QUARTER_PI 0.7853981633974483
#define GS_CLOSE 0x1p-10 /* share of the cosine below which the driving force needs more than pairs */
#define GS_PASSES 4

/* The value at x + x_lo, 0 <= x <= x_max. */
static gs_pair gs_lookup(const gs_table *table, double x, double x_lo)
{
    int e;
    const double m = frexp(1.0 + x, &e);
    int i = (e - 1) * GS_PER_BINADE + (int)floor((m - 0.5) * (2 * GS_PER_BINADE));
    if (i > table->count - 1)
        i = table->count - 1;
    const double *row = table->rows[i];
    const double d = (x - row[0]) + x_lo;
    double tail = row[GS_DEGREE + 2];
    for (int k = GS_DEGREE + 1; k >= 3; k--)
        tail = tail * d + row[k];
    return gs_fast_two_sum(row[1], row[2] + tail * d);
}

static gs_scaled gs_far(const gs_table *table, gs_scaled x)
{
    const gs_scaled inverse = gs_div(gs_constant(1.0), x);
    const double u = gs_plain(inverse).hi;
    const double small = table->correction * (table->order == 2 ? u * u : u);
    const gs_scaled factor = gs_make(gs_fast_two_sum(1.0, small), 0);
    if (table->power == 0)
        return gs_scale(factor, table->shift);
    return gs_scale(gs_mul(table->power < 0 ? inverse : x, factor), table->shift);
}

static gs_scaled gs_primitive(const gs_table *table, gs_scaled x)
{
    const gs_pair u = gs_plain(x);
    return u.hi >= table->x_max ? gs_far(table, x) : gs_make(gs_lookup(table, u.hi, u.lo), 0);
}

gs_scaled gs_phi1m(gs_scaled z) { return gs_primitive(&gs_phi1m_table, z); }
gs_scaled gs_phi2m(gs_scaled z) { return gs_primitive(&gs_phi2m_table, z); }
gs_scaled gs_descent_factor(gs_scaled p) { return gs_primitive(&gs_descent_factor_table, p); }
gs_scaled gs_flight_factor(gs_scaled b) { return gs_primitive(&gs_flight_factor_table, b); }
gs_scaled gs_range_factor(gs_scaled b) { return gs_primitive(&gs_range_factor_table, b); }

/* Natural logarithm of a >= 1 (one double, normalised). */
static gs_pair gs_log(gs_scaled a)
{
    const double k = a.e - 1 < 1030 ? a.e - 1 : 1030;
    return gs_pair_add(gs_fast_two_sum(k * gs_log_2[0], k * gs_log_2[1]),
                       gs_lookup(&gs_log1p_table, 2.0 * a.hi - 1.0, 0.0));
}

/* Arcsine of 0 <= a < 0.011. */
static gs_scaled gs_small_arcsine(gs_scaled a)
{
    const double u = gs_plain(a).hi;
    const double q = u * u;
    const double rest = q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0))));
    return gs_mul(a, gs_make(gs_fast_two_sum(1.0, rest), 0));
}

/* From w + log(w) = log(a^2 - 1) - 1, w = s - 1, and sin = w/(a - (1 + w)/a). */
static gs_scaled gs_best_elevation_far(gs_scaled a)
{
    const double u = gs_plain(gs_div(gs_constant(1.0), a)).hi;
    const double q = u * u;
    gs_pair y = gs_log(a);
    const gs_pair twice = {y.hi + y.hi, y.lo + y.lo}, less = {-1.0, -q * (1.0 + 0.5 * q)};
    y = gs_pair_add(twice, less);
    const gs_scaled w = gs_make(gs_lookup(&gs_wright_omega_table, y.hi, y.lo), 0);
    return gs_small_arcsine(gs_div(w, gs_sub(a, gs_div(gs_add(gs_constant(1.0), w), a))));
}

gs_scaled gs_best_elevation(gs_scaled a)
{
    const double u = gs_plain(a).hi;
    if (u >= gs_best_angle_table.x_max)
        return gs_best_elevation_far(a);
    return gs_make(gs_lookup(&gs_best_angle_table, u, 0.0), 0);
}

/* Index of the nearest table step, and the exact distance from it. */
static int gs_nearest_step(double x, double *d)
{
    const double i = rint(x * GS_ANGLE_STEPS);
    *d = x - i / GS_ANGLE_STEPS;
    return (int)i;
}

/* Sine and cosine of x + x2 in [0, pi/4], with relative error about 2^-68. */
static void gs_sine_cosine(double x, double x2, gs_pair *sine, gs_pair *cosine)
{
    double d;
    const int i = gs_nearest_step(x, &d);
    const double s = gs_sine_table[i][0], s2 = gs_sine_table[i][1];
    const double c = gs_cosine_table[i][0], c2 = gs_cosine_table[i][1];
    const double q = d * d;
    const double sd =
        d * (q * (gs_sinc[0][0] + q * (gs_sinc[1][0] + q * (gs_sinc[2][0] + q * gs_sinc[3][0])))) + x2;
    const double cd = q * (gs_cosm1[0][0] + q * (gs_cosm1[1][0] + q * (gs_cosm1[2][0] + q * gs_cosm1[3][0])));
    gs_pair p = gs_two_prod(c, d), h = gs_two_sum(s, p.hi);
    *sine = gs_fast_two_sum(h.hi, h.lo + (p.lo + (s2 + (c * sd + c2 * d + s * cd))));
    p = gs_two_prod(s, d);
    h = gs_two_sum(c, -p.hi);
    *cosine = gs_fast_two_sum(h.hi, h.lo + ((c2 + (c * cd - s * sd - s2 * d)) - p.lo));
}

gs_direction gs_angle(double theta)
{
    gs_direction a;
    gs_pair sine, cosine;
    a.x = fabs(theta);
    a.x2 = a.x3 = 0.0;
    a.sign = copysign(1.0, theta);
    a.complement = a.x > GS_QUARTER_PI;
    if (a.complement) {
        const gs_pair r = gs_two_sum(gs_half_pi[0] - a.x, gs_half_pi[1]), rest = gs_two_sum(r.lo, gs_half_pi[2]);
        a.x = r.hi;
        a.x2 = rest.hi;
        a.x3 = rest.lo + gs_half_pi[3];
    }
    const int tiny = a.x < 0x1p-60;
    gs_sine_cosine(tiny ? 0.0 : a.x, a.x2, &sine, &cosine);
    const gs_scaled s = tiny ? gs_load(a.x) : gs_make(sine, 0), c = gs_make(cosine, 0);
    a.s = a.complement ? c : s;
    a.c = a.complement ? s : c;
    return a;
}

/* Terms whose sum is (a1 + a2 + a3)(b1 + b2 + b3), to three doubles, times the sign. */
static void gs_products(double *terms, double sign, const double a[3], const double b[3])
{
    const gs_pair p = gs_two_prod(a[0], b[0]), q = gs_two_prod(a[0], b[1]), r = gs_two_prod(a[1], b[0]);
    const double all[9] = {p.hi, p.lo, q.hi, q.lo, r.hi, r.lo, a[0] * b[2], a[1] * b[1], a[2] * b[0]};
    for (int j = 0; j < 9; j++)
        terms[j] = sign * all[j];
}

/* Sum of doubles: exact transformations move the rounding errors down before anything is dropped. */
static gs_pair gs_distil(double *terms, int count)
{
    for (int pass = 0; pass < GS_PASSES; pass++)
        for (int j = 1; j < count; j++) {
            const gs_pair s = gs_two_sum(terms[j], terms[j - 1]);
            terms[j] = s.hi;
            terms[j - 1] = s.lo;
        }
    double rest = terms[0];
    for (int j = 1; j < count - 1; j++)
        rest += terms[j];
    return gs_fast_two_sum(terms[count - 1], rest);
}

/* q (r1 + q (r2 + ...)) */
static gs_pair gs_series(const double rows[GS_SERIES_TERMS][2], gs_pair q)
{
    gs_pair sum = {rows[GS_SERIES_TERMS - 1][0], rows[GS_SERIES_TERMS - 1][1]};
    for (int k = GS_SERIES_TERMS - 2; k >= 0; k--) {
        const gs_pair term = {rows[k][0], rows[k][1]};
        sum = gs_pair_add(gs_pair_mul(sum, q), term);
    }
    return gs_pair_mul(sum, q);
}

/* The driving force where cosine and friction nearly cancel, with error about 2^-117 of the cosine: P - mu Q with
 * (P, Q) = (cos, sin) of theta, or (sin, cos) of its complement, developed about the nearest table step. The part
 * linear in d is summed exactly, the rest is small.
 */
static gs_pair gs_close_driving(const gs_direction *a, gs_scaled mu)
{
    double d, terms[34];
    int k;
    const int i = gs_nearest_step(a->x, &d);
    const double *P = a->complement ? gs_sine_table[i] : gs_cosine_table[i];
    const double *Q = a->complement ? gs_cosine_table[i] : gs_sine_table[i];
    const double turn = a->complement ? 1.0 : -1.0; /* of dP/dx = turn Q, dQ/dx = -turn P */
    const double m = ldexp(mu.hi, mu.e < 20 ? mu.e : 20); /* larger only where Q = 0 */
    const double unit = frexp(d, &k);
    const gs_pair h = gs_two_prod(mu.hi, unit), lower = gs_two_prod(m, a->x2);
    const gs_pair rest = gs_two_sum(ldexp(h.lo, mu.e + k), lower.hi);
    const double md[3] = {ldexp(h.hi, mu.e + k), rest.hi, rest.lo + (lower.lo + m * a->x3)};
    const double mu_parts[3] = {m, 0.0, 0.0}, d_parts[3] = {d, a->x2, a->x3};
    const int tiny = fabs(d) < 0x1p-100;
    const gs_pair z = gs_fast_two_sum(tiny ? 0.0 : d, tiny ? 0.0 : a->x2), q = gs_pair_mul(z, z);
    const gs_pair p2 = {P[0], P[1]}, q2 = {Q[0], Q[1]}, d2 = {d, a->x2}, md2 = {md[0], md[1]}, m2 = {m, 0.0};
    const gs_pair held = gs_pair_mul(m2, q2), minus = {-held.hi, -held.lo};
    const gs_pair drift = gs_pair_add(gs_pair_mul(d2, q2), gs_pair_mul(md2, p2));
    const gs_pair turned = {turn * drift.hi, turn * drift.lo};
    const gs_pair bend = gs_pair_mul(gs_pair_add(p2, minus), gs_series(gs_cosm1, q));
    const gs_pair twist = gs_pair_mul(turned, gs_series(gs_sinc, q));
    terms[0] = bend.hi;
    terms[1] = bend.lo;
    terms[2] = twist.hi;
    terms[3] = twist.lo;
    terms[4] = P[0];
    terms[5] = P[1];
    terms[6] = P[2];
    gs_products(terms + 7, -1.0, mu_parts, Q);
    gs_products(terms + 16, turn, d_parts, Q);
    gs_products(terms + 25, turn, md, P);
    return gs_distil(terms, 34);
}

/* cos(theta) - mu sin(|theta|), mu >= 0: sign right, pair accurate however much cancels. */
gs_scaled gs_driving(gs_direction a, gs_scaled mu)
{
    const gs_scaled n = gs_sub(a.c, gs_mul(mu, a.s));
    if (fabs(gs_plain(gs_div(n, a.c)).hi) < GS_CLOSE)
        return gs_make(gs_close_driving(&a, mu), 0);
    return n;
}
