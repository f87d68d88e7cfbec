/* Arithmetic on pairs hi + lo, GS_LANES at a time, about 2^-95 relative, for arguments of ordinary size: there nothing
 * overflows or underflows, and no flag is raised but 'inexact'. Other lanes are told apart first and go another way.
 * hi need not be the nearest double: lo may be some units in its last place, as waiting for it would take too long.
 */
#ifndef GALILEO_LANES_H
#define GALILEO_LANES_H

#include "galileo_pairs.h"

#define GS_GROUP 16 /* vectors that one loop leaves to the next: some kilobytes */

typedef struct {
    gs_v hi, lo;
} gs_vp;

/* Sine and cosine of |theta|, and what has the sign of theta. */
typedef struct {
    gs_vp s, c;
    gs_v sign;
} gs_turn;

/* The first of `count` numbers and copies of the last, a vector in all. */
static inline const double *gs_padded(double *pad, const double *x, size_t count)
{
    for (size_t j = 0; j < GS_LANES; j++)
        pad[j] = x[j < count ? j : count - 1];
    return pad;
}

/* Whether least <= x <= greatest; or 0, too. */
static inline gs_mask gs_between(gs_v x, double least, double greatest)
{
    return gs_both(gs_at_least(x, gs_v_of(least)), gs_at_least(gs_v_of(greatest), x));
}

static inline gs_mask gs_between_or_0(gs_v x, double least, double greatest)
{
    const gs_v zero = gs_v_of(0.0);
    return gs_either(gs_between(x, least, greatest), gs_both(gs_at_least(x, zero), gs_at_least(zero, x)));
}

/* A rate, 0 where no time of ordinary size makes it felt. */
static inline gs_v gs_felt(gs_v x) { return gs_select(gs_at_least(x, gs_v_of(0x1p-400)), x, gs_v_of(0.0)); }

static inline gs_vp gs_vp_of(gs_v hi, gs_v lo)
{
    const gs_vp r = {hi, lo};
    return r;
}

/* a + b as a pair, where |a| >= |b| or a = 0. */
static inline gs_vp gs_vp_sum(gs_v a, gs_v b)
{
    const gs_v s = gs_add(a, b);
    return gs_vp_of(s, gs_rest(a, b, s));
}

/* The nearest double but for a little. */
static inline gs_v gs_vp_value(gs_vp a) { return gs_add(a.hi, a.lo); }

static inline gs_vp gs_vp_load(gs_v x) { return gs_vp_of(x, gs_v_of(0.0)); }
static inline gs_vp gs_vp_constant(double x) { return gs_vp_of(gs_v_of(x), gs_v_of(0.0)); }

/* Products and quotients of doubles, of pairs, and of a pair by a double. */
static inline gs_vp gs_vp_product(gs_v a, gs_v b)
{
    const gs_v p = gs_mul(a, b);
    return gs_vp_of(p, gs_product_rest(a, b, p));
}

static inline gs_vp gs_vp_times(gs_vp a, gs_v b)
{
    const gs_v p = gs_mul(a.hi, b);
    return gs_vp_of(p, gs_fma(a.lo, b, gs_product_rest(a.hi, b, p)));
}

static inline gs_vp gs_vp_mul(gs_vp a, gs_vp b)
{
    const gs_v p = gs_mul(a.hi, b.hi);
    return gs_vp_of(p, gs_fma(a.hi, b.lo, gs_fma(a.lo, b.hi, gs_product_rest(a.hi, b.hi, p))));
}

/* One division: what the product with 1/b leaves is exact enough to be mended by it. */
static inline gs_vp gs_vp_div(gs_vp a, gs_vp b)
{
    const gs_v inverse = gs_div(gs_v_of(1.0), b.hi);
    const gs_v q = gs_mul(a.hi, inverse);
    const gs_v rest = gs_fnma(q, b.lo, gs_add(gs_fnma(q, b.hi, a.hi), a.lo));
    return gs_vp_of(q, gs_mul(rest, inverse));
}

static inline gs_vp gs_vp_over(gs_vp a, gs_v b)
{
    const gs_v inverse = gs_div(gs_v_of(1.0), b);
    const gs_v q = gs_mul(a.hi, inverse);
    return gs_vp_of(q, gs_mul(gs_add(gs_fnma(q, b, a.hi), a.lo), inverse));
}

static inline gs_vp gs_vp_quotient(gs_v a, gs_v b)
{
    const gs_v inverse = gs_div(gs_v_of(1.0), b);
    const gs_v q = gs_mul(a, inverse);
    return gs_vp_of(q, gs_mul(gs_fnma(q, b, a), inverse));
}

static inline gs_vp gs_vp_sqrt(gs_vp a)
{
    const gs_v s = gs_sqrt(a.hi);
    const gs_v rest = gs_add(gs_fnma(s, s, a.hi), a.lo);
    return gs_vp_of(s, gs_mul(gs_mul(rest, gs_v_of(0.5)), gs_rough_inverse(s)));
}

static inline gs_vp gs_vp_add(gs_vp a, gs_vp b)
{
    const gs_v s = gs_add(a.hi, b.hi), t = gs_add(a.lo, b.lo);
    return gs_vp_sum(s, gs_add(gs_sum_rest(a.hi, b.hi, s), t));
}

static inline gs_vp gs_vp_sub(gs_vp a, gs_vp b)
{
    const gs_v s = gs_sub(a.hi, b.hi), part = gs_sub(s, a.hi);
    const gs_v rest = gs_sub(gs_sub(a.hi, gs_sub(s, part)), gs_add(b.hi, part));
    return gs_vp_sum(s, gs_add(rest, gs_sub(a.lo, b.lo)));
}

static inline gs_vp gs_vp_scaled(gs_vp a, double unit)
{
    return gs_vp_of(gs_mul(a.hi, gs_v_of(unit)), gs_mul(a.lo, gs_v_of(unit)));
}

/* The numbers of a group that are put aside, side by side, with their places in it. */
typedef struct {
    double hi[(GS_GROUP + 1) * GS_LANES], lo[(GS_GROUP + 1) * GS_LANES], place[(GS_GROUP + 1) * GS_LANES];
    size_t count;
} gs_aside;

/* The lanes of a mask, side by side; there is room for a whole vector. */
#if GS_LANES == 8
static inline size_t gs_compress(double *to, gs_mask lanes, gs_v x)
{
    gs_v_store(to, _mm512_maskz_compress_pd(lanes, x));
    return (size_t)__builtin_popcount(lanes);
}
#else
static inline size_t gs_compress(double *to, gs_mask lanes, gs_v x)
{
    double each[GS_LANES];
    size_t count = 0;
    gs_v_store(each, x);
    for (size_t j = 0; j < GS_LANES; j++) {
        to[count] = each[j];
        count += gs_bits_of(lanes) >> j & 1;
    }
    return count;
}
#endif

/* Put lanes of the ith vector of a group aside. */
static inline void gs_s_put_aside(gs_aside *aside, gs_mask lanes, size_t i, gs_v x)
{
    static const double number[8] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
    const gs_v place = gs_add(gs_v_load(number), gs_v_of((double)(i * GS_LANES)));
    gs_compress(aside->place + aside->count, lanes, place);
    aside->count += gs_compress(aside->hi + aside->count, lanes, x);
}
static inline void gs_vp_put_aside(gs_aside *aside, gs_mask lanes, size_t i, gs_vp x)
{
    gs_compress(aside->lo + aside->count, lanes, x.lo);
    gs_s_put_aside(aside, lanes, i, x.hi);
}

/* How many there are, after the last vector is filled up with copies. */
static inline size_t gs_s_filled(gs_aside *aside)
{
    for (size_t j = aside->count; j % GS_LANES != 0; j++)
        aside->hi[j] = aside->hi[aside->count - 1];
    return aside->count;
}
static inline size_t gs_vp_filled(gs_aside *aside)
{
    for (size_t j = aside->count; j % GS_LANES != 0; j++)
        aside->lo[j] = aside->lo[aside->count - 1];
    return gs_s_filled(aside);
}
static inline gs_v gs_s_aside(const gs_aside *aside, size_t i) { return gs_v_load(aside->hi + i); }
static inline gs_vp gs_vp_aside(const gs_aside *aside, size_t i)
{
    return gs_vp_of(gs_v_load(aside->hi + i), gs_v_load(aside->lo + i));
}
static inline void gs_s_put(gs_aside *aside, size_t i, gs_v x) { gs_v_store(aside->hi + i, x); }
static inline void gs_vp_put(gs_aside *aside, size_t i, gs_vp x)
{
    gs_v_store(aside->hi + i, x.hi);
    gs_v_store(aside->lo + i, x.lo);
}

/* Back to their places in the group. */
static inline void gs_s_put_back(const gs_aside *aside, gs_v *value)
{
    for (size_t k = 0; k < aside->count; k++)
        ((double *)value)[(size_t)aside->place[k]] = aside->hi[k];
}
static inline void gs_vp_put_back(const gs_aside *aside, gs_vp *value)
{
    for (size_t k = 0; k < aside->count; k++) {
        const size_t place = (size_t)aside->place[k];
        ((double *)&value[place / GS_LANES].hi)[place % GS_LANES] = aside->hi[k];
        ((double *)&value[place / GS_LANES].lo)[place % GS_LANES] = aside->lo[k];
    }
}

static inline gs_vp gs_vp_select(gs_mask m, gs_vp a, gs_vp b)
{
    return gs_vp_of(gs_select(m, a.hi, b.hi), gs_select(m, a.lo, b.lo));
}

@FACTORS@
@TURN@
/* |theta|, or what it lacks of pi/2 if that is less (far), as the nearest of 16 angles and d + x_lo beyond it. */
typedef struct {
    gs_vp s, c;          /* of the nearest angle */
    gs_v d, over, less;  /* sin(d + x_lo) - d, cos(d + x_lo) - 1 */
    gs_mask far;
} gs_near_angle;

static inline gs_near_angle gs_vp_near_angle(gs_v theta)
{
    const gs_v size = gs_abs(theta), zero = gs_v_of(0.0), big = gs_v_of(0x1.8p+52);
    const gs_mask far = gs_at_least(size, gs_v_of(GS_QUARTER_TURN));
    const gs_v left = gs_sub(gs_v_of(GS_HALF_TURN_0), size); /* 0, or above the second part of pi/2 */
    const gs_v y = gs_add(left, gs_v_of(GS_HALF_TURN_1));
    const gs_v y_lo = gs_add(gs_rest(left, gs_v_of(GS_HALF_TURN_1), y), gs_v_of(GS_HALF_TURN_2));
    const gs_v x = gs_select(far, y, size), x_lo = gs_select(far, y_lo, zero);
    const gs_v u = gs_fma(x, gs_v_of(GS_TURNS_A_RADIAN), big);
    const gs_index i = gs_low_index(u);
    const gs_v d = gs_fnma(gs_sub(u, big), gs_v_of(GS_TURN_STEP), x);
    const gs_v q = gs_fma(d, d, gs_mul(gs_add(d, d), x_lo));
    gs_v more = gs_fma(q, gs_v_of(0x1.71de3a556c734p-19), gs_v_of(-0x1.a01a01a01a01ap-13));
    more = gs_fma(more, q, gs_v_of(0x1.1111111111111p-7));
    more = gs_mul(gs_fma(more, q, gs_v_of(-0x1.5555555555555p-3)), q);
    gs_v less = gs_fma(q, gs_v_of(0x1.a01a01a01a01ap-16), gs_v_of(-0x1.6c16c16c16c17p-10));
    less = gs_fma(less, q, gs_v_of(0x1.5555555555555p-5));
    less = gs_mul(gs_fma(less, q, gs_v_of(-0.5)), q);
    const gs_near_angle r = {
        {gs_pick(gs_turn_sine, i), gs_pick(gs_turn_sine_lo, i)},
        {gs_pick(gs_turn_cosine, i), gs_pick(gs_turn_cosine_lo, i)},
        d,
        gs_fma(d, more, x_lo),
        less,
        far,
    };
    return r;
}

/* a cos(d + x_lo) + b sin(d + x_lo), about 2^-62 relative, where |a| >= |b d| or a = 0. */
static inline gs_vp gs_vp_beside(gs_vp a, gs_vp b, gs_v d, gs_v over, gs_v less)
{
    const gs_v p = gs_mul(b.hi, d);
    const gs_v h = gs_add(a.hi, p);
    const gs_v h_lo = gs_add(gs_rest(a.hi, p, h), gs_product_rest(b.hi, d, p));
    return gs_vp_sum(h, gs_add(h_lo, gs_fma(a.hi, less, gs_fma(b.hi, over, gs_fma(b.lo, d, a.lo)))));
}

static inline gs_v gs_minus(gs_v a) { return gs_sub(gs_v_of(0.0), a); }

static inline gs_turn gs_vp_angle(gs_v theta)
{
    const gs_near_angle t = gs_vp_near_angle(theta);
    const gs_vp sine = gs_vp_beside(t.s, t.c, t.d, t.over, t.less);
    const gs_vp cosine = gs_vp_beside(t.c, t.s, gs_minus(t.d), gs_minus(t.over), t.less);
    const gs_turn r = {gs_vp_select(t.far, cosine, sine), gs_vp_select(t.far, sine, cosine), theta};
    return r;
}

/* One of both: the cosine of the step if crossed. */
static inline gs_vp gs_vp_one(gs_near_angle t, gs_mask crossed)
{
    const gs_v d = gs_select(crossed, gs_minus(t.d), t.d), over = gs_select(crossed, gs_minus(t.over), t.over);
    return gs_vp_beside(gs_vp_select(crossed, t.c, t.s), gs_vp_select(crossed, t.s, t.c), d, over, t.less);
}

static inline gs_vp gs_vp_sine_of(gs_v theta)
{
    const gs_near_angle t = gs_vp_near_angle(theta);
    const gs_vp r = gs_vp_one(t, t.far);
    return gs_vp_of(gs_flip(r.hi, theta), gs_flip(r.lo, theta));
}

static inline gs_vp gs_vp_cosine_of(gs_v theta)
{
    const gs_near_angle t = gs_vp_near_angle(theta);
    return gs_vp_one(t, gs_not(t.far));
}

static inline gs_vp gs_vp_sine(gs_turn a) { return gs_vp_of(gs_flip(a.s.hi, a.sign), gs_flip(a.s.lo, a.sign)); }
static inline gs_vp gs_vp_cosine(gs_turn a) { return a.c; }

/* cos(theta) - mu sin(|theta|), where it is 2^-5 of the cosine or more; 1 where friction holds the bead. */
static inline gs_vp gs_vp_driving(gs_turn a, gs_v mu, gs_mask *good, gs_mask *held)
{
    const gs_vp n = gs_vp_sub(a.c, gs_vp_times(a.s, mu));
    const gs_v one = gs_v_of(1.0), zero = gs_v_of(0.0);
    const gs_mask clear = gs_at_least(gs_abs(n.hi), gs_mul(a.c.hi, gs_v_of(0x1p-5)));
    const gs_mask moves = gs_both(clear, gs_less(zero, n.hi));
    *good = gs_both(*good, clear);
    *held = gs_not(moves);
    return gs_vp_of(gs_select(moves, n.hi, one), gs_select(moves, n.lo, zero));
}

static inline gs_vp gs_vp_right_angle(void) { return gs_vp_of(gs_v_of(GS_HALF_TURN_0), gs_v_of(GS_HALF_TURN_1)); }

/* Arctangent of x > 0. */
static inline gs_vp gs_vp_arctangent(gs_vp x, gs_mask *good)
{
    const gs_v one = gs_v_of(1.0);
    const gs_mask here = gs_less(gs_v_of(0.0), x.hi);
    const gs_vp some = {gs_select(here, x.hi, one), gs_select(here, x.lo, gs_v_of(0.0))};
    *good = gs_both(*good, here);
    return gs_vp_acot(gs_vp_div(gs_vp_constant(1.0), some));
}

/* What stays clear of a ceiling, beside which results go with the square root of the distance; half of that elsewhere. */
#define GS_CLEAR 0x1.ffcp-1
static inline gs_vp gs_vp_below(gs_vp x, gs_vp most, gs_mask *good)
{
    const gs_mask here = gs_both(*good, gs_less(x.hi, gs_mul(most.hi, gs_v_of(GS_CLEAR))));
    const gs_vp r = {gs_select(here, x.hi, gs_mul(most.hi, gs_v_of(0.5))), gs_select(here, x.lo, gs_v_of(0.0))};
    *good = here;
    return r;
}

/* exp(-z), z below 512 */
static inline gs_vp gs_vp_phi0m(gs_vp z, gs_mask *good)
{
    const gs_mask here = gs_less(z.hi, gs_v_of(512.0));
    gs_vp r;
    *good = gs_both(*good, here);
    r.hi = gs_exp_minus_range0_pair(gs_select(here, z.hi, gs_v_of(0.0)), gs_select(here, z.lo, gs_v_of(0.0)), &r.lo);
    return r;
}

#endif
