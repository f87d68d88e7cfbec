/* exp(-s) and the first two exponential integrator functions of -s as pairs, for the equations that a solver meets. */
#include "galileo_support.h"

#define GS_HALVINGS 8
#define GS_FADED 75.0 /* exp(-s) is below 2^-108 of what it is added to */

static gs_pair gs_times(double factor, gs_pair a)
{
    const gs_pair r = {factor * a.hi, factor * a.lo};
    return r;
}

/* 1 + a. */
static gs_pair gs_one_and(gs_pair a)
{
    const gs_pair one = {1.0, 0.0};
    return gs_pair_add(one, a);
}

/* The power series at z = -s/2^8, then eight times phi2(2z) = (phi1(z)^2 + 2 phi2(z))/4,
 * phi1(2z) = phi1(z) (1 + exp(z))/2 and exp(2z) = exp(z)^2: relative error about 2^-96.
 */
gs_decay_values gs_decay(gs_scaled s)
{
    gs_pair x = gs_plain(s), phi2 = {gs_decay_series[GS_DECAY_SERIES_TERMS - 1][0], 0.0};
    if (x.hi >= GS_FADED) {
        const gs_scaled inverse = gs_div(gs_constant(1.0), s);
        const gs_decay_values far = {gs_zero(), inverse, gs_mul(gs_sub(gs_constant(1.0), inverse), inverse)};
        return far;
    }
    x = gs_times(1.0 / (1 << GS_HALVINGS), x);
    for (int k = GS_DECAY_SERIES_TERMS - 2; k >= GS_DECAY_PAIRS; k--)
        phi2.hi = phi2.hi * x.hi + gs_decay_series[k][0];
    for (int k = GS_DECAY_PAIRS - 1; k >= 0; k--) {
        const gs_pair row = {gs_decay_series[k][0], gs_decay_series[k][1]};
        phi2 = gs_pair_add(gs_pair_mul(phi2, x), row);
    }
    gs_pair phi1 = gs_one_and(gs_times(-1.0, gs_pair_mul(phi2, x)));
    gs_pair fading = gs_one_and(gs_times(-1.0, gs_pair_mul(phi1, x)));
    for (int k = 0; k < GS_HALVINGS; k++) {
        phi2 = gs_pair_add(gs_times(0.25, gs_pair_mul(phi1, phi1)), gs_times(0.5, phi2));
        phi1 = gs_times(0.5, gs_pair_mul(phi1, gs_one_and(fading)));
        fading = gs_pair_mul(fading, fading);
    }
    const gs_decay_values near = {gs_make(fading, 0), gs_make(phi1, 0), gs_make(phi2, 0)};
    return near;
}
