/* Arithmetic on scaled pairs (hi + lo) * 2^e: no intermediate over- or underflow, about 2^-100 relative error.
 * Internal to the library; the same operations in the same order as in the NumPy modules, so the same bits.
 */
#ifndef GALILEO_SUPPORT_H
#define GALILEO_SUPPORT_H

#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif
#if FLT_EVAL_METHOD != 0
#error "galileo needs double arithmetic without extra precision: on 32-bit x86 compile with -msse2 -mfpmath=sse"
#endif
#if defined(__FAST_MATH__)
#error "galileo is not correct under -ffast-math: compile without it"
#endif

@SIZES@
#define GS_ZERO_EXPONENT (-(1 << 24))    /* of 0: below that of any number, so that sums align on the other operand */
#define GS_INFINITE_EXPONENT (1 << 20)   /* stands for an infinite argument */
#define GS_LIMIT (1 << 18)

typedef struct {
    double hi, lo;
    int e;
} gs_scaled;

/* |theta|, or its complement where that is smaller, as x + x2 + x3; with the sine (>= 0), cosine and sign. */
typedef struct {
    double x, x2, x3, sign;
    int complement;
    gs_scaled s, c;
} gs_direction;

/* exp(-s), phi1(-s) = (1 - exp(-s))/s and phi2(-s) = (s - 1 + exp(-s))/s^2; exp(-s) is 0 for s > 75. */
typedef struct {
    gs_scaled fading, first, second;
} gs_decay_values;

/* F at a time of flight z, its first derivative by Z = z^2 and minus its second; rise/range = tan(theta), d rise/dZ. */
typedef struct {
    gs_scaled square, slope, bend, rise, lean;
} gs_balance;

/* The two angles that reach a range. */
typedef struct {
    gs_scaled low, high;
} gs_angles;

/* A piecewise polynomial, and the leading terms 2^shift x^power (1 + correction x^-order) beyond x_max. */
typedef struct {
    const double (*rows)[GS_ROW]; /* centre, c0, its rest, c1, its rest, c2, ... */
    int count;
    double x_max;
    int power, shift;
    double correction;
    int order;
} gs_table;

extern const gs_table gs_phi1m_table, gs_phi2m_table, gs_descent_factor_table, gs_flight_factor_table,
    gs_range_factor_table, gs_range_loss_table, gs_grown_balance_table, gs_best_angle_table, gs_best_time_table,
    gs_max_range_factor_table, gs_acot_table, gs_phi0m_table, gs_wright_omega_table, gs_log1p_table,
    gs_principal_table, gs_w0_offset_table, gs_wm1_offset_table;
extern const double gs_sinc[GS_SERIES_TERMS][3], gs_cosm1[GS_SERIES_TERMS][3];
extern const double gs_sine_table[][3], gs_cosine_table[][3];
extern const double gs_half_pi[4], gs_log_2[3], gs_e[2], gs_inverse_e[3];
extern const double gs_atanh[GS_ATANH_TERMS][2], gs_growth[GS_GROWTH_TERMS][2], gs_decay_series[GS_DECAY_SERIES_TERMS][2];

gs_scaled gs_phi0m(gs_scaled z);
gs_scaled gs_phi1m(gs_scaled z);
gs_scaled gs_phi2m(gs_scaled z);
gs_scaled gs_descent_factor(gs_scaled p);
gs_scaled gs_flight_factor(gs_scaled b);
gs_scaled gs_range_factor(gs_scaled b);
gs_scaled gs_range_balance(gs_scaled b);
gs_scaled gs_range_loss(gs_scaled b);
gs_scaled gs_best_elevation(gs_scaled a);
gs_scaled gs_max_range_factor(gs_scaled a);
gs_scaled gs_acot(gs_scaled x);
gs_scaled gs_best_time(gs_scaled a);
gs_direction gs_angle(double theta);
gs_scaled gs_driving(gs_direction a, gs_scaled mu);
gs_decay_values gs_decay(gs_scaled s);
gs_scaled gs_elevation_of(gs_scaled opposite, gs_scaled adjacent);
gs_scaled gs_arctangent(gs_scaled x);
/* Both angles of a range in units of v^2/g, below that of the best angle; balance takes a time in units of v/g. */
gs_angles gs_launch(gs_balance (*balance)(gs_scaled z, gs_scaled alpha), gs_scaled reach, gs_scaled alpha);

/* Pairs: an unevaluated sum of two doubles. */

typedef struct {
    double hi, lo;
} gs_pair;

gs_pair gs_log(gs_scaled a); /* natural logarithm of a >= 1 (one double, normalised) */

static inline gs_pair gs_fast_two_sum(double a, double b)
{
    const double s = a + b;
    const gs_pair r = {s, b - (s - a)};
    return r;
}

static inline gs_pair gs_two_sum(double a, double b)
{
    const double s = a + b;
    const double t = s - a;
    const gs_pair r = {s, (a - (s - t)) + (b - t)};
    return r;
}

static inline gs_pair gs_two_prod(double a, double b)
{
    const double p = a * b;
    const gs_pair r = {p, fma(a, b, -p)};
    return r;
}

static inline gs_pair gs_pair_mul(gs_pair a, gs_pair b)
{
    const gs_pair p = gs_two_prod(a.hi, b.hi);
    return gs_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline gs_pair gs_pair_add(gs_pair a, gs_pair b)
{
    gs_pair s = gs_two_sum(a.hi, b.hi);
    const gs_pair t = gs_two_sum(a.lo, b.lo);
    s = gs_fast_two_sum(s.hi, s.lo + t.hi);
    return gs_fast_two_sum(s.hi, s.lo + t.lo);
}

/* Scaled pairs. */

static inline gs_scaled gs_make(gs_pair p, int e)
{
    const gs_scaled r = {p.hi, p.lo, e};
    return r;
}

static inline gs_pair gs_mantissa(gs_scaled a)
{
    const gs_pair r = {a.hi, a.lo};
    return r;
}

static inline gs_scaled gs_constant(double value)
{
    const gs_scaled r = {value, 0.0, 0};
    return r;
}

static inline gs_scaled gs_zero(void)
{
    const gs_scaled r = {0.0, 0.0, GS_ZERO_EXPONENT};
    return r;
}

static inline gs_scaled gs_right_angle(void)
{
    const gs_scaled r = {gs_half_pi[0], gs_half_pi[1], 0};
    return r;
}

static inline gs_scaled gs_load(double x)
{
    gs_scaled r = {0.5, 0.0, GS_INFINITE_EXPONENT};
    if (!isinf(x)) {
        r.hi = frexp(x, &r.e);
        if (x == 0.0)
            r.e = GS_ZERO_EXPONENT;
    }
    return r;
}

static inline gs_scaled gs_mul(gs_scaled a, gs_scaled b)
{
    return gs_make(gs_pair_mul(gs_mantissa(a), gs_mantissa(b)), a.e + b.e);
}

static inline gs_scaled gs_div(gs_scaled a, gs_scaled b)
{
    const double q = a.hi / b.hi;
    const gs_pair p = gs_two_prod(q, b.hi);
    const double rest = (((a.hi - p.hi) - p.lo) + a.lo) - q * b.lo;
    return gs_make(gs_fast_two_sum(q, rest / b.hi), a.e - b.e);
}

static inline gs_scaled gs_sqrt(gs_scaled a)
{
    const int odd = a.e % 2 != 0;
    const double unit = odd ? 2.0 : 1.0;
    const double hi = unit * a.hi, lo = unit * a.lo;
    const double s = sqrt(hi);
    const gs_pair p = gs_two_prod(s, s);
    const double rest = ((hi - p.hi) - p.lo) + lo;
    return gs_make(gs_fast_two_sum(s, rest / (s + s)), (a.e - odd) / 2);
}

static inline gs_pair gs_align(gs_scaled a, int e)
{
    const int shift = a.e - e > -400 ? a.e - e : -400;
    const uint64_t bits = (uint64_t)(1023 + shift) << 52; /* of 2^shift: a product takes a fifth of the time of ldexp */
    double unit;
    memcpy(&unit, &bits, sizeof unit);
    const gs_pair r = {a.hi * unit, a.lo * unit};
    return r;
}

static inline gs_scaled gs_add(gs_scaled a, gs_scaled b)
{
    const int e = a.e > b.e ? a.e : b.e;
    return gs_make(gs_pair_add(gs_align(a, e), gs_align(b, e)), e);
}

static inline gs_scaled gs_neg(gs_scaled a)
{
    const gs_scaled r = {-a.hi, -a.lo, a.e};
    return r;
}

static inline gs_scaled gs_sub(gs_scaled a, gs_scaled b)
{
    return gs_add(a, gs_neg(b));
}

static inline gs_scaled gs_scale(gs_scaled a, int k)
{
    a.e += k;
    return a;
}

/* Absolute value. */
static inline gs_scaled gs_size(gs_scaled a)
{
    return copysign(1.0, a.hi) < 0.0 ? gs_neg(a) : a;
}

/* The nearest double of a scaled pair as one, normalised. */
static inline gs_scaled gs_rounded(gs_scaled a)
{
    int e;
    const double m = frexp(a.hi, &e);
    const gs_scaled r = {m, 0.0, a.e + e};
    return r;
}

static inline gs_scaled gs_sine(gs_direction a)
{
    const gs_scaled r = {a.sign * a.s.hi, a.sign * a.s.lo, a.s.e};
    return r;
}

static inline gs_scaled gs_cosine(gs_direction a)
{
    return a.c;
}

/* hi + lo rounded to a multiple of the smallest double: once, where rounding hi again would be twice. */
static inline double gs_round_subnormal(gs_scaled a)
{
    const int e = a.e > -1200 ? a.e : -1200;
    const double big = ldexp(1.0, -1074 - e) * 0x1p52;
    const gs_pair s = gs_fast_two_sum(big, fabs(a.hi));
    return copysign(ldexp((s.hi + (s.lo + copysign(1.0, a.hi) * a.lo)) - big, e), a.hi);
}

static inline gs_scaled gs_fading(gs_decay_values a)
{
    return a.fading;
}

static inline gs_scaled gs_first(gs_decay_values a)
{
    return a.first;
}

static inline gs_scaled gs_second(gs_decay_values a)
{
    return a.second;
}

/* The nearest double, with the flags of one rounding; limits at infinite arguments come without a flag. */
static inline double gs_store(gs_scaled a)
{
    if (a.e > GS_LIMIT)
        return copysign(INFINITY, a.hi);
    if (a.e < -GS_LIMIT)
        return copysign(0.0, a.hi);
    const double result = ldexp(a.hi, a.e);
    return fabs(result) <= DBL_MIN && a.hi != 0.0 ? gs_round_subnormal(a) : result;
}

/* A number that is only looked up: 0 below 2^-120, some large number above 2^100. */
static inline gs_pair gs_plain(gs_scaled a)
{
    const int e = a.e < 200 ? a.e : 200;
    gs_pair r = {0.0, 0.0};
    if (e >= -120) {
        r.hi = ldexp(a.hi, e);
        r.lo = ldexp(a.lo, e);
    }
    return r;
}

/* Domains, for arguments that are not NaN. */

static inline int gs_positive(double x) { return x > 0.0; }
static inline int gs_nonnegative(double x) { return x >= 0.0; }
static inline int gs_chord_angle(double x) { return fabs(x) <= gs_half_pi[0]; }
static inline int gs_elevation(double x) { return x >= 0.0 && x <= gs_half_pi[0]; }

static inline double gs_invalid(void)
{
    feraiseexcept(FE_INVALID);
    return NAN;
}

/* The result, unless it is undecided because two arguments are infinite at once; an exact 0 stays 0. */
static inline double gs_settle(gs_scaled value, int undecided)
{
    return undecided && value.hi != 0.0 ? gs_invalid() : gs_store(value);
}

/* The float next to the most that an argument may be counts as that. */
static inline double gs_widen_to(float x, float most, double wide)
{
    return x == most ? wide : (double)x;
}

/* Exponential and logarithm, both branches of W, and the equations they solve. */

#define GS_FAR 0x1p16 /* beyond it an exponential is 0 or infinite beside any quotient of doubles */

gs_pair gs_lookup(const gs_table *table, double x, double x_lo);
gs_pair gs_relative_growth(gs_pair x);
gs_pair gs_reduce_exponent(gs_scaled t, int *k);
gs_scaled gs_exponential(gs_scaled t);
gs_scaled gs_log_from_excess(gs_scaled f);
gs_scaled gs_logarithm(gs_scaled a);
gs_scaled gs_wright_omega(gs_scaled y);
gs_scaled gs_principal(gs_scaled x, gs_scaled above);
gs_scaled gs_principal_offset(gs_scaled x);
gs_scaled gs_lower_offset(gs_scaled x);
gs_scaled gs_excess(double a, double b, double c, double d);
void gs_linear_exponential_roots(double a, double b, double c, double d, double *t0, double *tm1);

#endif
