/* The angle of a direction in the first quadrant. */
#include "galileo_support.h"

/* Arctangent of opposite/adjacent, both >= 0 and not both 0: in [0, pi/2], as a pair with relative error 2^-65. The
 * smaller share t = tan(angle) is turned back by the nearest table step i: tan(angle - i/64) is below 0.013.
 */
gs_scaled gs_elevation_of(gs_scaled opposite, gs_scaled adjacent)
{
    const int steep = gs_sub(opposite, adjacent).hi > 0.0;
    const gs_scaled t = steep ? gs_div(adjacent, opposite) : gs_div(opposite, adjacent);
    const double u = gs_plain(t).hi;
    const int i = (int)rint(GS_ANGLE_STEPS * (u / (1.0 + 0.28125 * u * u)));
    const gs_scaled s = {gs_sine_table[i][0], gs_sine_table[i][1], i == 0 ? GS_ZERO_EXPONENT : 0};
    const gs_scaled c = {gs_cosine_table[i][0], gs_cosine_table[i][1], 0};
    const gs_scaled rest = gs_div(gs_sub(gs_mul(t, c), s), gs_add(c, gs_mul(t, s)));
    const double w = gs_plain(rest).hi;
    const double y = w * w;
    const double bend = -y * (1.0 / 3.0 - y * (1.0 / 5.0 - y * (1.0 / 7.0 - y * (1.0 / 9.0))));
    const gs_scaled turned = gs_mul(rest, gs_make(gs_fast_two_sum(1.0, bend), 0));
    const gs_scaled angle = gs_add(gs_load((double)i / GS_ANGLE_STEPS), turned);
    return steep ? gs_sub(gs_right_angle(), angle) : angle;
}

gs_scaled gs_arctangent(gs_scaled x) { return gs_elevation_of(x, gs_constant(1.0)); }
