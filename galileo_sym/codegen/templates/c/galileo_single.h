/* The same operations as for pairs in plain double arithmetic, for results in binary32: no term of a formula over- or
 * underflows, whatever finite floats the arguments are, unless the result does.
 */
#ifndef GALILEO_SINGLE_H
#define GALILEO_SINGLE_H

#include "galileo_lanes.h"
#include "galileo_lean.h"

/* |theta|'s sine and cosine, and what has the sign of theta. */
typedef struct {
    gs_v s, c, sign;
} gs_turn_single;

/* The float next to pi/2, which lies above it, counts as pi/2. */
#define GS_HALF_TURN_SINGLE 0x1.921fb6p+0

static inline double gs_wide_angle(float theta)
{
    const double x = theta;
    return fabs(x) == GS_HALF_TURN_SINGLE ? copysign(GS_HALF_TURN_0, x) : x;
}

static inline const float *gs_padded_single(float *pad, const float *x, size_t count)
{
    for (size_t j = 0; j < GS_LANES; j++)
        pad[j] = x[j < count ? j : count - 1];
    return pad;
}

static inline gs_v gs_s_constant(double x) { return gs_v_of(x); }
static inline gs_v gs_s_mul(gs_v a, gs_v b) { return gs_mul(a, b); }
static inline gs_v gs_s_div(gs_v a, gs_v b) { return gs_div(a, b); }
static inline gs_v gs_s_sqrt(gs_v a) { return gs_sqrt(a); }
static inline gs_v gs_s_scaled(gs_v a, double unit) { return gs_mul(a, gs_v_of(unit)); }

/* Sums: well enough unless nearly all cancels. */
static inline gs_v gs_s_kept(gs_v r, gs_v a, gs_mask *good)
{
    *good = gs_both(*good, gs_at_least(gs_abs(r), gs_mul(gs_abs(a), gs_v_of(0x1p-20))));
    return r;
}
static inline gs_v gs_s_add(gs_v a, gs_v b, gs_mask *good) { return gs_s_kept(gs_add(a, b), a, good); }
static inline gs_v gs_s_sub(gs_v a, gs_v b, gs_mask *good) { return gs_s_kept(gs_sub(a, b), a, good); }

/* The same step as of pairs. */
typedef struct {
    gs_v s, c, over, less; /* sin(d), cos(d) - 1 */
    gs_mask far;
} gs_near_angle_single;

static inline gs_near_angle_single gs_s_near_angle(gs_v theta)
{
    const gs_v size = gs_min(gs_abs(theta), gs_v_of(GS_HALF_TURN_0)), big = gs_v_of(0x1.8p+52);
    const gs_mask far = gs_at_least(size, gs_v_of(GS_QUARTER_TURN));
    const gs_v left = gs_add(gs_sub(gs_v_of(GS_HALF_TURN_0), size), gs_v_of(GS_HALF_TURN_1));
    const gs_v x = gs_select(far, left, size);
    const gs_v u = gs_fma(x, gs_v_of(GS_TURNS_A_RADIAN), big);
    const gs_index i = gs_low_index(u);
    const gs_v d = gs_fnma(gs_sub(u, big), gs_v_of(GS_TURN_STEP), x);
    const gs_v q = gs_mul(d, d);
    const gs_v over = gs_mul(gs_fma(q, gs_v_of(0x1.1111111111111p-7), gs_v_of(-0x1.5555555555555p-3)), q);
    const gs_v less = gs_fma(q, gs_v_of(-0x1.6c16c16c16c17p-10), gs_v_of(0x1.5555555555555p-5));
    const gs_near_angle_single r = {
        gs_pick(gs_turn_sine, i),
        gs_pick(gs_turn_cosine, i),
        gs_fma(over, d, d),
        gs_mul(gs_fma(less, q, gs_v_of(-0.5)), q),
        far,
    };
    return r;
}

static inline gs_turn_single gs_s_angle(gs_v theta)
{
    const gs_near_angle_single t = gs_s_near_angle(theta);
    const gs_v sine = gs_fma(t.c, t.over, gs_fma(t.s, t.less, t.s));
    const gs_v cosine = gs_fnma(t.s, t.over, gs_fma(t.c, t.less, t.c));
    const gs_turn_single r = {gs_select(t.far, cosine, sine), gs_select(t.far, sine, cosine), theta};
    return r;
}

static inline gs_v gs_s_one(gs_near_angle_single t, gs_mask crossed)
{
    const gs_v a = gs_select(crossed, t.c, t.s), b = gs_select(crossed, t.s, t.c);
    return gs_fma(b, gs_select(crossed, gs_minus(t.over), t.over), gs_fma(a, t.less, a));
}

static inline gs_v gs_s_sine_of(gs_v theta)
{
    const gs_near_angle_single t = gs_s_near_angle(theta);
    return gs_flip(gs_s_one(t, t.far), theta);
}

static inline gs_v gs_s_cosine_of(gs_v theta)
{
    const gs_near_angle_single t = gs_s_near_angle(theta);
    return gs_s_one(t, gs_not(t.far));
}

static inline gs_v gs_s_sine(gs_turn_single a) { return gs_flip(a.s, a.sign); }
static inline gs_v gs_s_cosine(gs_turn_single a) { return a.c; }

static inline gs_v gs_s_driving(gs_turn_single a, gs_v mu, gs_mask *good, gs_mask *held)
{
    const gs_v n = gs_fnma(mu, a.s, a.c);
    const gs_mask clear = gs_at_least(gs_abs(n), gs_mul(a.c, gs_v_of(0x1p-20)));
    const gs_mask moves = gs_both(clear, gs_less(gs_v_of(0.0), n));
    *good = gs_both(*good, clear);
    *held = gs_not(moves);
    return gs_select(moves, n, gs_v_of(1.0));
}

@CALLS@
static inline gs_v gs_s_right_angle(void) { return gs_v_of(GS_HALF_TURN_0); }

static inline gs_v gs_s_arctangent(gs_v x, gs_mask *good)
{
    const gs_mask here = gs_less(gs_v_of(0.0), x);
    *good = gs_both(*good, here);
    return gs_s_acot(gs_div(gs_v_of(1.0), gs_select(here, x, gs_v_of(1.0))));
}

static inline gs_v gs_s_below(gs_v x, gs_v most, gs_mask *good)
{
    *good = gs_both(*good, gs_less(x, gs_mul(most, gs_v_of(GS_CLEAR))));
    return gs_select(*good, x, gs_mul(most, gs_v_of(0.5)));
}

/* exp(-z): beyond 600 any product with floats is 0 in binary32. */
static inline gs_v gs_s_phi0m(gs_v z) { return gs_exp_minus_range0_lean(gs_min(z, gs_v_of(600.0))); }

#endif
