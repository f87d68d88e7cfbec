/* Launch angles by the roots of range^2 = F(Z), Z the square of the time of flight; F is concave, so steps are safe.
 *
 * A step goes to the root of the parabola that osculates F (Cauchy's method, of third order, exact without resistance
 * and beside the maximum). From the starts below three steps leave what rounding leaves: below 2^-66 of the time beside
 * the maximum, 2^-90 elsewhere.
 */
#include "galileo_support.h"

#define GS_STEPS 3

/* Square root, 0 of what is not positive. */
static gs_scaled gs_root(gs_scaled a)
{
    return a.hi > 0.0 ? gs_sqrt(a) : gs_zero();
}

/* From Z to the lower or upper root of the osculating parabola, or to its vertex where that stays below level. */
static gs_scaled gs_step(gs_balance at, gs_scaled level, int low)
{
    const gs_scaled gap = gs_scale(gs_sub(at.square, level), 1);
    const gs_scaled square = gs_add(gs_mul(at.slope, at.slope), gs_mul(at.bend, gap));
    const gs_scaled turn = gs_root(square);
    const gs_scaled across = low ? gs_add(at.slope, turn) : gs_sub(at.slope, turn);
    if (square.hi > 0.0 && across.hi != 0.0)
        return gs_div(gs_neg(gap), across);
    return gs_div(at.slope, at.bend);
}

/* Time of flight after a step of its square, which is at most divided by 8. */
static gs_scaled gs_moved(gs_scaled z, gs_scaled step)
{
    const gs_scaled least = gs_constant(0.125);
    const gs_scaled share = gs_add(gs_constant(1.0), gs_div(step, gs_mul(z, z)));
    return gs_mul(z, gs_sqrt(gs_sub(share, least).hi > 0.0 ? share : least));
}

/* 1/sqrt(1 + 2p/3 + p^2). */
static gs_scaled gs_bent(gs_scaled p)
{
    const gs_scaled one = gs_constant(1.0);
    return gs_div(one, gs_sqrt(gs_add(one, gs_mul(p, gs_add(gs_constant(2.0 / 3.0), p)))));
}

/* Times of flight, low and high, within 12 percent of the distance to the best one. Both are exact without resistance.
 * The low one is quadratic in eta = sqrt(1 - level/top) as to (z phi1)^2, the high one as to z^2, with the slope at the
 * maximum and the value at eta = 1 right.
 */
static void gs_starts(gs_balance top, gs_scaled z_best, gs_scaled alpha, gs_scaled level, gs_scaled start[2])
{
    const gs_scaled one = gs_constant(1.0);
    const gs_scaled share = gs_div(level, top.square);
    const gs_scaled eta = gs_root(gs_div(gs_sub(top.square, level), top.square));
    const gs_scaled fading = top.rise, lost = gs_scale(top.lean, 1); /* exp(-s) and phi1(-s), s = alpha z_best */
    const gs_scaled bend = gs_add(gs_mul(lost, lost), gs_mul(gs_div(alpha, z_best), gs_mul(lost, fading)));
    const gs_scaled width = gs_scale(gs_sqrt(gs_div(top.square, bend)), 1);
    const gs_scaled best = gs_mul(z_best, z_best);
    const gs_scaled reach = gs_mul(best, gs_mul(lost, lost));
    const gs_scaled near = gs_mul(gs_mul(width, lost), fading);
    const gs_scaled far = gs_sub(reach, near);
    const gs_scaled chord =
        gs_sqrt(gs_mul(gs_div(share, gs_add(one, eta)), gs_add(reach, gs_mul(far, eta))));
    const gs_scaled gone = gs_mul(alpha, chord); /* 1 - exp(-s) at the start */
    const gs_scaled spare = gs_add(gs_mul(fading, gs_sub(gs_constant(2.0), fading)),
                                   gs_mul(gs_mul(alpha, alpha), gs_mul(eta, gs_add(near, gs_mul(far, eta)))));
    const double u = gs_plain(gone).hi;
    const double age = u < 0x1p-10 ? 1.0 + u * (0.5 + u / 3.0)
                                   : gs_log(gs_rounded(gs_div(gs_add(one, gone), spare))).hi / u;
    start[0] = gs_mul(chord, gs_load(age));
    const gs_scaled end = gs_scale(gs_flight_factor(alpha), 1);
    const gs_scaled growth = gs_sub(gs_sqrt(gs_div(one, fading)), one);
    const gs_scaled bent = gs_bent(gs_mul(eta, growth)), bent_end = gs_bent(growth);
    const gs_scaled rest = gs_sub(gs_sub(gs_mul(end, end), best), gs_mul(width, bent_end));
    start[1] = gs_sqrt(gs_add(best, gs_mul(eta, gs_add(gs_mul(width, bent), gs_mul(rest, eta)))));
}

gs_angles gs_launch(gs_balance (*balance)(gs_scaled z, gs_scaled alpha), gs_scaled reach, gs_scaled alpha)
{
    gs_angles angles = {gs_zero(), gs_right_angle()};
    if (reach.hi == 0.0)
        return angles;
    gs_scaled start[2], *const angle[2] = {&angles.high, &angles.low};
    const gs_scaled level = gs_mul(reach, reach), z_best = gs_best_time(alpha);
    gs_starts(balance(z_best, alpha), z_best, alpha, level, start);
    for (int low = 0; low < 2; low++) {
        gs_scaled z = start[1 - low];
        for (int k = 1; k < GS_STEPS; k++)
            z = gs_moved(z, gs_step(balance(z, alpha), level, low));
        const gs_balance at = balance(z, alpha);
        *angle[low] = gs_elevation_of(gs_add(at.rise, gs_mul(gs_step(at, level, low), at.lean)), reach);
    }
    return angles;
}
