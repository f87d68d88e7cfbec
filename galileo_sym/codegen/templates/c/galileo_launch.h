/* Launch angles against resistance on vectors: the roots of rho^2 = F(z), z the time of flight in units of v/g.
 *
 * With s = alpha z, across = z phi1(-s), rise = z^2 phi2(-s), fade = exp(-s): F = across^2 - rise^2, and by z the slopes
 * of across and rise are fade and across. tan(theta) = rise/rho. Steps go to the root of the parabola that osculates F;
 * from the starts, which are those of launch.c, one leaves 2^-13 of z, two 2^-38, three nothing beside a rounding: in
 * pairs the third, for binary32 the second, is taken in `rise`, not in z.
 * An error e of the pair phi2 or fade makes one of e/|fade - rise| or e fade/((s - 1 + fade) |fade - rise|) in the
 * tangent: below 95 e for ranges that gs_vp_below lets pass, 0.1 ulp.
 */
#ifndef GALILEO_LAUNCH_H
#define GALILEO_LAUNCH_H

#include "galileo_solving.h"

#define GS_MOST_ALPHA 0x1p+20  /* sines of the best angle are known well enough from its range */
#define GS_LEAST_ALPHA 0x1p-100 /* resistance is nothing below */
#define GS_LEAST_REACH 0x1p-100 /* squares of squares do not underflow */
#define GS_LASTING 300.0          /* exp(-s) is nothing beyond */
#define GS_BY_SERIES 0.75       /* s below which phi2 is found, and exp(-s) from it; the other way round above */

/* The best shot in plain doubles, for the starts: what gives both times of flight by eta = sqrt(1 - (rho/most)^2). */
typedef struct {
    gs_v alpha, inverse_most, fade, best, reach, near, far, width, growth, rest;
} gs_best;

/* The same with what the last step in pairs needs of alpha. */
typedef struct {
    gs_best plain;
    gs_vp alpha, inverse, inverse_square;
} gs_vp_best;

typedef struct {
    gs_vp low, high;
} gs_vp_angles;

typedef struct {
    gs_v low, high;
} gs_s_angles;

typedef struct {
    gs_v across, rise, fade;
} gs_point;

/* 1/sqrt(1 + 2p/3 + p^2) */
static inline gs_v gs_bend_of(gs_v p)
{
    const gs_v square = gs_fma(p, gs_add(p, gs_v_of(0x1.5555555555555p-1)), gs_v_of(1.0));
    return gs_div(gs_v_of(1.0), gs_sqrt(square));
}

/* What the starts need of the best shot; its sine from its range, most = cos/(alpha + sin). */
static inline gs_best gs_s_shot(gs_v alpha_given, gs_mask *good)
{
    const gs_v one = gs_v_of(1.0), zero = gs_v_of(0.0);
    const gs_mask here = gs_at_least(gs_v_of(GS_MOST_ALPHA), alpha_given);
    const gs_v kept = gs_select(here, alpha_given, one);
    const gs_v alpha = gs_select(gs_at_least(kept, gs_v_of(GS_LEAST_ALPHA)), kept, zero);
    const gs_v most = gs_s_max_range_factor(alpha), stopped = gs_mul(alpha, most), square = gs_mul(most, most);
    const gs_v left = gs_fma(gs_sub(one, stopped), gs_add(one, stopped), square);
    const gs_v sine = gs_div(gs_fnma(stopped, most, gs_sqrt(left)), gs_add(one, square));
    const gs_v w = gs_div(alpha, sine), age = gs_age(gs_add(w, gs_v_of(0x1p-30)));
    const gs_v fade = gs_div(sine, gs_add(alpha, sine)), z = gs_div(age, sine), lost = gs_div(fade, age);
    const gs_v bend = gs_mul(lost, gs_fma(gs_div(alpha, z), fade, lost));
    gs_best shot;
    shot.alpha = alpha, shot.fade = fade;
    shot.inverse_most = gs_div(one, most);
    shot.width = gs_div(gs_add(most, most), gs_sqrt(bend));
    shot.best = gs_mul(z, z);
    shot.reach = gs_mul(shot.best, gs_mul(lost, lost));
    shot.near = gs_mul(gs_mul(shot.width, lost), fade);
    shot.far = gs_sub(shot.reach, shot.near);
    shot.growth = gs_sub(gs_sqrt(gs_div(one, fade)), one);
    const gs_v flight = gs_s_flight_factor(alpha), end = gs_add(flight, flight);
    shot.rest = gs_sub(gs_fma(end, end, gs_mul(shot.best, gs_v_of(-1.0))), gs_mul(shot.width, gs_bend_of(shot.growth)));
    *good = gs_both(*good, here);
    return shot;
}

/* Times of flight to begin with: as in launch.c. */
static inline void gs_starts_of(const gs_best *shot, gs_v rho, gs_v *low, gs_v *high)
{
    const gs_v one = gs_v_of(1.0), share = gs_mul(rho, shot->inverse_most);
    const gs_v eta = gs_sqrt(gs_mul(gs_sub(one, share), gs_add(one, share)));
    const gs_v chord = gs_mul(share, gs_sqrt(gs_div(gs_fma(shot->far, eta, shot->reach), gs_add(one, eta))));
    const gs_v gone = gs_mul(shot->alpha, chord), more = gs_add(one, gone), square = gs_mul(shot->alpha, shot->alpha);
    const gs_v spare = gs_fma(gs_mul(square, eta), gs_fma(shot->far, eta, shot->near),
                              gs_mul(shot->fade, gs_sub(gs_v_of(2.0), shot->fade)));
    const gs_v grown = gs_div(more, spare);
    *low = gs_mul(gs_mul(chord, grown), gs_age(gs_fma(gone, grown, gs_v_of(0x1p-30))));
    const gs_v wide = gs_mul(shot->width, gs_bend_of(gs_mul(eta, shot->growth)));
    *high = gs_sqrt(gs_fma(eta, gs_fma(shot->rest, eta, wide), shot->best));
}

static inline gs_point gs_point_at(gs_v z, gs_v alpha)
{
    const gs_v s = gs_mul(alpha, z), first = gs_s_phi1m(s);
    const gs_point at = {gs_mul(z, first), gs_mul(gs_mul(z, z), gs_s_phi2m(s)), gs_fnma(s, first, gs_v_of(1.0))};
    return at;
}

/* F - rho^2 */
static inline gs_v gs_gap(gs_point at, gs_v rho)
{
    return gs_fnma(at.rise, at.rise, gs_mul(gs_sub(at.across, rho), gs_add(at.across, rho)));
}

/* From z to the lower or upper root of the osculating parabola. */
static inline gs_v gs_step_from(gs_point at, gs_v gap, gs_v alpha, int low)
{
    const gs_v lead = gs_sub(at.fade, at.rise), slope = gs_mul(at.across, lead);
    const gs_v bend = gs_fnma(at.fade, lead, gs_mul(at.across, gs_fma(alpha, at.fade, at.across)));
    const gs_v turn = gs_sqrt(gs_abs(gs_fma(slope, slope, gs_mul(bend, gap)))); /* positive but for rounding */
    return gs_div(gap, gs_sub(gs_v_of(0.0), low ? gs_add(slope, turn) : gs_sub(slope, turn)));
}

static inline gs_v gs_stepped(gs_v z, const gs_best *shot, gs_v rho, int low)
{
    const gs_point at = gs_point_at(z, shot->alpha);
    return gs_add(z, gs_step_from(at, gs_gap(at, rho), shot->alpha, low));
}

/* What a step adds to the rise. */
static inline gs_v gs_risen(gs_point at, gs_v step)
{
    return gs_mul(step, gs_fma(gs_mul(step, gs_v_of(0.5)), at.fade, at.across));
}

/* A range that is at hand only in lanes that are served: no power of it underflows. */
static inline gs_mask gs_reached(gs_v rho) { return gs_at_least(rho, gs_v_of(GS_LEAST_REACH)); }

/* Ends of the time of one shot. */
static inline gs_v gs_s_elevation(gs_v z, const gs_best *shot, gs_v rho, int low)
{
    const gs_point at = gs_point_at(gs_stepped(z, shot, rho, low), shot->alpha);
    const gs_v step = gs_step_from(at, gs_gap(at, rho), shot->alpha, low);
    return gs_s_acot(gs_div(rho, gs_add(at.rise, gs_risen(at, step))));
}

static inline gs_s_angles gs_s_launch(gs_v rho_given, gs_best shot, gs_mask *good)
{
    const gs_mask here = gs_both(*good, gs_reached(rho_given));
    const gs_v rho = gs_select(here, rho_given, gs_div(gs_v_of(0.5), shot.inverse_most));
    gs_v low, high;
    gs_starts_of(&shot, rho, &low, &high);
    const gs_s_angles angles = {gs_s_elevation(low, &shot, rho, 1), gs_s_elevation(high, &shot, rho, 0)};
    *good = here;
    return angles;
}

static inline gs_vp_best gs_vp_shot(gs_vp alpha, gs_mask *good)
{
    const gs_v zero = gs_v_of(0.0);
    gs_vp_best shot;
    shot.plain = gs_s_shot(alpha.hi, good);
    const gs_mask felt = gs_less(zero, shot.plain.alpha);
    shot.alpha = gs_vp_of(shot.plain.alpha, gs_select(gs_both(*good, felt), alpha.lo, zero));
    const gs_vp some = {gs_select(felt, shot.alpha.hi, gs_v_of(1.0)), gs_select(felt, shot.alpha.lo, zero)};
    shot.inverse = gs_vp_div(gs_vp_constant(1.0), some);
    shot.inverse_square = gs_vp_mul(shot.inverse, shot.inverse);
    return shot;
}

/* Pairs of across and rise, and fade. */
typedef struct {
    gs_vp across, rise;
    gs_v fade;
} gs_vp_point;

/* By the power series of phi2, s < 3/4. */
static inline gs_vp_point gs_vp_soon(gs_v z, gs_vp s)
{
    const gs_vp second = gs_vp_second(s);
    const gs_vp first = gs_vp_sub(gs_vp_constant(1.0), gs_vp_mul(s, second)), time = gs_vp_load(z);
    gs_vp_point at;
    at.across = gs_vp_mul(time, first);
    at.rise = gs_vp_mul(gs_vp_mul(time, time), second);
    at.fade = gs_fnma(s.hi, first.hi, gs_v_of(1.0));
    return at;
}

/* By exp(-s), s >= 3/4: across is (1 - exp(-s))/alpha, and rise (s - 1 + exp(-s))/alpha^2. */
static inline gs_vp_point gs_vp_later(const gs_vp_best *shot, gs_vp s)
{
    const gs_vp one = gs_vp_constant(1.0);
    const gs_mask lasts = gs_less(s.hi, gs_v_of(GS_LASTING));
    gs_vp fade;
    fade.hi = gs_exp_minus_range0_pair(gs_select(lasts, s.hi, gs_v_of(GS_LASTING)), gs_select(lasts, s.lo, gs_v_of(0.0)),
                                       &fade.lo);
    const gs_vp gone = gs_vp_sub(one, fade);
    gs_vp_point at;
    at.across = gs_vp_mul(gone, shot->inverse);
    at.rise = gs_vp_mul(gs_vp_sub(s, gone), shot->inverse_square);
    at.fade = fade.hi;
    return at;
}

static inline gs_vp_point gs_vp_point_at(const gs_vp_best *shot, gs_v z)
{
    const gs_vp s = gs_vp_mul(shot->alpha, gs_vp_load(z));
    const gs_mask soon = gs_less(s.hi, gs_v_of(GS_BY_SERIES));
    if (gs_all(soon))
        return gs_vp_soon(z, s);
    const gs_vp_point later = gs_vp_later(shot, s);
    if (!gs_bits_of(soon))
        return later;
    const gs_vp_point near = gs_vp_soon(z, gs_vp_select(soon, s, gs_vp_constant(0.5)));
    const gs_vp_point at = {gs_vp_select(soon, near.across, later.across), gs_vp_select(soon, near.rise, later.rise),
                            gs_select(soon, near.fade, later.fade)};
    return at;
}

static inline gs_vp gs_vp_elevation(gs_v z, const gs_vp_best *shot, gs_vp rho, int low)
{
    for (int k = 0; k < 2; k++)
        z = gs_stepped(z, &shot->plain, rho.hi, low);
    const gs_vp_point pairs = gs_vp_point_at(shot, z);
    const gs_vp excess = gs_vp_sub(gs_vp_mul(pairs.across, pairs.across), gs_vp_mul(rho, rho));
    const gs_v gap = gs_vp_value(gs_vp_sub(excess, gs_vp_mul(pairs.rise, pairs.rise)));
    const gs_point at = {pairs.across.hi, pairs.rise.hi, pairs.fade};
    const gs_v more = gs_risen(at, gs_step_from(at, gap, shot->plain.alpha, low));
    return gs_vp_acot(gs_vp_div(rho, gs_vp_sum(pairs.rise.hi, gs_add(pairs.rise.lo, more))));
}

/* Both angles of a range in units of v^2/g, below the one that gs_vp_below tells. */
static inline gs_vp_angles gs_vp_launch(gs_vp rho_given, gs_vp_best shot, gs_mask *good)
{
    const gs_mask here = gs_both(*good, gs_reached(rho_given.hi));
    const gs_vp half = gs_vp_load(gs_div(gs_v_of(0.5), shot.plain.inverse_most));
    const gs_vp rho = gs_vp_select(here, rho_given, half);
    gs_v low, high;
    gs_starts_of(&shot.plain, rho.hi, &low, &high);
    const gs_vp_angles angles = {gs_vp_elevation(low, &shot, rho, 1), gs_vp_elevation(high, &shot, rho, 0)};
    *good = here;
    return angles;
}

#endif
