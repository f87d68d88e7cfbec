/* The primitives on scaled pairs: a table near 0, the leading terms beyond it. */
#include "galileo_support.h"

#define GS_QUARTER_PI 0.7853981633974483
#define GS_CLOSE 0x1p-10 /* share of the cosine below which the driving force needs more than pairs */
#define GS_PASSES 4
#define GS_GONE 0x1p17 /* exp(-z) of larger z is 0 times any finite number, */
#define GS_SMALL (-(1 << 19)) /* but not times an infinite one */
#define GS_VANISHED (-(1 << 22)) /* exp(-z) of infinite z */

/* The value at x + x_lo, 0 <= x + x_lo <= x_max but for rounding. */
gs_pair gs_lookup(const gs_table *table, double x, double x_lo)
{
    int e;
    const double m = frexp(1.0 + x, &e);
    int i = (e - 1) * GS_PER_BINADE + (int)floor((m - 0.5) * (2 * GS_PER_BINADE));
    if (i < 0)
        i = 0;
    if (i > table->count - 1)
        i = table->count - 1;
    const double *row = table->rows[i];
    const gs_pair d = gs_two_sum(x - row[0], x_lo);
    double tail = row[GS_ROW - 1];
    for (int k = GS_ROW - 2; k >= 5; k--)
        tail = tail * d.hi + row[k];
    const gs_pair slope = gs_two_sum(row[3], tail * d.hi);
    const gs_pair rise = gs_two_prod(slope.hi, d.hi);
    const gs_pair value = gs_two_sum(row[1], rise.hi);
    const double slope_lo = slope.lo + row[4];
    return gs_fast_two_sum(value.hi, value.lo + (row[2] + (rise.lo + (slope_lo * d.hi + slope.hi * d.lo))));
}

static gs_scaled gs_far(const gs_table *table, gs_scaled x)
{
    const gs_scaled inverse = gs_div(gs_constant(1.0), x);
    const double u = gs_plain(inverse).hi;
    const double small = table->correction * (table->order == 2 ? u * u : u);
    const gs_scaled factor = gs_make(gs_fast_two_sum(1.0, small), 0);
    if (table->power == 0)
        return gs_scale(factor, table->shift);
    const gs_scaled lead = table->power == -2 ? gs_mul(inverse, inverse) : table->power == -1 ? inverse : x;
    return gs_scale(gs_mul(lead, factor), table->shift);
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
gs_scaled gs_range_loss(gs_scaled b) { return gs_primitive(&gs_range_loss_table, b); }
gs_scaled gs_acot(gs_scaled x) { return gs_primitive(&gs_acot_table, x); }

/* exp(-z): 2^-n times a table at the rest that n log(2) leaves of z. */
gs_scaled gs_phi0m(gs_scaled z)
{
    gs_pair u = gs_plain(z);
    const int gone = u.hi >= GS_GONE;
    if (gone)
        u.hi = u.lo = 0.0;
    const double n = floor(u.hi / gs_log_2[0]);
    const gs_pair less = {u.lo, -n * gs_log_2[2]};
    const gs_pair r = gs_pair_add(gs_two_sum(u.hi - n * gs_log_2[0], -n * gs_log_2[1]), less);
    const gs_pair value = gs_lookup(&gs_phi0m_table, r.hi, r.lo);
    return gs_make(value, gone ? (z.e > GS_LIMIT ? GS_VANISHED : GS_SMALL) : -(int)n);
}

/* b exp(-T)/(T - b), T = (1 + b)(1 - exp(-T)): exp(-b) times what grows like b/e. */
gs_scaled gs_range_balance(gs_scaled b)
{
    const gs_pair u = gs_plain(b), inverse_e = {gs_inverse_e[0], gs_inverse_e[1]};
    const gs_scaled grown = u.hi >= gs_grown_balance_table.x_max
                                ? gs_mul(b, gs_make(inverse_e, 0))
                                : gs_make(gs_lookup(&gs_grown_balance_table, u.hi, u.lo), 0);
    return gs_mul(gs_phi0m(b), grown);
}

gs_pair gs_log(gs_scaled a)
{
    int e;
    const double m = frexp(a.hi, &e);
    const double k = a.e + e - 1 < 1030 ? a.e + e - 1 : 1030;
    return gs_pair_add(gs_fast_two_sum(k * gs_log_2[0], k * gs_log_2[1]),
                       gs_lookup(&gs_log1p_table, 2.0 * m - 1.0, ldexp(a.lo, 1 - e)));
}

/* Arcsine of 0 <= a < 0.011. */
static gs_scaled gs_small_arcsine(gs_scaled a)
{
    const double u = gs_plain(a).hi;
    const double q = u * u;
    const double rest = q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0))));
    return gs_mul(a, gs_make(gs_fast_two_sum(1.0, rest), 0));
}

/* w = s - 1 for large a, from w + log(w) = log(a^2 - 1) - 1. */
static gs_scaled gs_excess_far(gs_scaled a)
{
    const double u = gs_plain(gs_div(gs_constant(1.0), a)).hi;
    const double q = u * u;
    gs_pair y = gs_log(a);
    const gs_pair twice = {y.hi + y.hi, y.lo + y.lo}, less = {-1.0, -q * (1.0 + 0.5 * q)};
    y = gs_pair_add(twice, less);
    return gs_make(gs_lookup(&gs_wright_omega_table, y.hi, y.lo), 0);
}

/* From sin = w/(a - (1 + w)/a). */
static gs_scaled gs_best_elevation_far(gs_scaled a)
{
    const gs_scaled w = gs_excess_far(a);
    return gs_small_arcsine(gs_div(w, gs_sub(a, gs_div(gs_add(gs_constant(1.0), w), a))));
}

/* From (1 + s) exp(-s) = w (2 + w)/(a^2 - 1). */
static gs_scaled gs_max_range_factor_far(gs_scaled a)
{
    const gs_scaled one = gs_constant(1.0), w = gs_excess_far(a);
    const gs_scaled lost = gs_div(gs_mul(w, gs_add(gs_constant(2.0), w)), gs_sub(gs_mul(a, a), one));
    return gs_div(gs_sqrt(gs_sub(one, lost)), a);
}

/* From s = 1 + w. */
gs_scaled gs_best_time(gs_scaled a)
{
    const gs_pair u = gs_plain(a);
    if (u.hi >= gs_best_time_table.x_max)
        return gs_div(gs_add(gs_constant(1.0), gs_excess_far(a)), a);
    return gs_make(gs_lookup(&gs_best_time_table, u.hi, u.lo), 0);
}

gs_scaled gs_best_elevation(gs_scaled a)
{
    const gs_pair u = gs_plain(a);
    if (u.hi >= gs_best_angle_table.x_max)
        return gs_best_elevation_far(a);
    return gs_make(gs_lookup(&gs_best_angle_table, u.hi, u.lo), 0);
}

gs_scaled gs_max_range_factor(gs_scaled a)
{
    const gs_pair u = gs_plain(a);
    if (u.hi >= gs_max_range_factor_table.x_max)
        return gs_max_range_factor_far(a);
    return gs_make(gs_lookup(&gs_max_range_factor_table, u.hi, u.lo), 0);
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

/* Sums of three doubles. */
typedef struct {
    double part[3];
} gs_triple;

/* Terms whose sum is the product, times the sign. */
static void gs_products(double terms[9], double sign, gs_triple a, gs_triple b)
{
    const double *x = a.part, *y = b.part;
    const gs_pair p = gs_two_prod(x[0], y[0]), q = gs_two_prod(x[0], y[1]), r = gs_two_prod(x[1], y[0]);
    const double all[9] = {p.hi, p.lo, q.hi, q.lo, r.hi, r.lo, x[0] * y[2], x[1] * y[1], x[2] * y[0]};
    for (int j = 0; j < 9; j++)
        terms[j] = sign * all[j];
}

/* Sum of doubles: exact transformations move the rounding errors down before anything is dropped. */
static gs_triple gs_sum(double *terms, int count)
{
    for (int pass = 0; pass < GS_PASSES; pass++)
        for (int j = 1; j < count; j++) {
            const gs_pair s = gs_two_sum(terms[j], terms[j - 1]);
            terms[j] = s.hi;
            terms[j - 1] = s.lo;
        }
    gs_triple r = {{terms[count - 1], terms[count - 2], terms[0]}};
    for (int j = 1; j < count - 2; j++)
        r.part[2] += terms[j];
    return r;
}

static void gs_copy(double terms[3], gs_triple a)
{
    for (int j = 0; j < 3; j++)
        terms[j] = a.part[j];
}

static gs_triple gs_row(const double row[3])
{
    const gs_triple r = {{row[0], row[1], row[2]}};
    return r;
}

/* q (r1 + q (r2 + ...)) */
static gs_triple gs_series(const double rows[GS_SERIES_TERMS][3], gs_triple q)
{
    double terms[12];
    gs_triple total = gs_row(rows[GS_SERIES_TERMS - 1]);
    for (int k = GS_SERIES_TERMS - 2; k >= 0; k--) {
        gs_products(terms, 1.0, total, q);
        gs_copy(terms + 9, gs_row(rows[k]));
        total = gs_sum(terms, 12);
    }
    gs_products(terms, 1.0, total, q);
    return gs_sum(terms, 9);
}

/* The driving force where cosine and friction nearly cancel, with error about 2^-150 of the cosine: P - mu Q with
 * (P, Q) = (cos, sin) of theta, or (sin, cos) of its complement; dP/dx = turn Q, dQ/dx = -turn P. At a distance d from
 * the nearest table step it is (P - mu Q) cos(d) + turn (Q + mu P) sin(d), in sums of three doubles.
 */
static gs_pair gs_close_driving(const gs_direction *a, gs_scaled mu)
{
    double d, terms[24];
    int k;
    const int i = gs_nearest_step(a->x, &d);
    const gs_triple P = gs_row(a->complement ? gs_sine_table[i] : gs_cosine_table[i]);
    const gs_triple Q = gs_row(a->complement ? gs_cosine_table[i] : gs_sine_table[i]);
    const double turn = a->complement ? 1.0 : -1.0;
    const double m = ldexp(mu.hi, mu.e < 20 ? mu.e : 20); /* less than mu only where Q = 0 */
    const double unit = frexp(d, &k);
    const gs_pair h = gs_two_prod(mu.hi, unit), far = gs_two_prod(m, a->x2);
    const gs_triple mass = {{m, 0.0, 0.0}}, step = {{d, a->x2, a->x3}};
    double product[5] = {ldexp(h.hi, mu.e + k), ldexp(h.lo, mu.e + k), far.hi, far.lo, m * a->x3};
    const gs_triple friction = gs_sum(product, 5); /* mu d */
    gs_copy(terms, P);
    gs_products(terms + 3, -1.0, mass, Q);
    const gs_triple at_step = gs_sum(terms, 12);
    gs_products(terms, turn, step, Q);
    gs_products(terms + 9, turn, friction, P);
    const gs_triple drift = gs_sum(terms, 18);
    const int small = fabs(d) < 0x1p-100;
    const gs_triple z = {{small ? 0.0 : d, small ? 0.0 : a->x2, small ? 0.0 : a->x3}};
    gs_products(terms, 1.0, z, z);
    const gs_triple q = gs_sum(terms, 9);
    gs_products(terms, 1.0, at_step, gs_series(gs_cosm1, q));
    gs_products(terms + 9, 1.0, drift, gs_series(gs_sinc, q));
    gs_copy(terms + 18, at_step);
    gs_copy(terms + 21, drift);
    const gs_triple n = gs_sum(terms, 24);
    const gs_pair r = {n.part[0], n.part[1]};
    return r;
}

/* cos(theta) - mu sin(|theta|), mu >= 0: sign right, pair accurate however much cancels. */
gs_scaled gs_driving(gs_direction a, gs_scaled mu)
{
    const gs_scaled n = gs_sub(a.c, gs_mul(mu, a.s));
    if (fabs(gs_plain(gs_div(n, a.c)).hi) < GS_CLOSE)
        return gs_make(gs_close_driving(&a, mu), 0);
    return n;
}
