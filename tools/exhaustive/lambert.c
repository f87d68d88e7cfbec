/* W on both branches, and its distances from -1: 1 + W(-exp(-1 - x)), of x > 0. */
#include "solve.h"

/* 1 - exp(-t) = t A with t - 1 + exp(-t) = t^2 B = x; its derivative in t is E. Where x > 64 it is 1. */
void w0_offset(const double *x, pairs *value)
{
    double t[LANES];
    plain_decay near;
    decay d;
    EACH
    {
        const double goal = nearer(x[i], FAR);
        t[i] = sqrt(2.0 * goal * (1.0 + 0.5 * goal));
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(t, &near);
        far = 0;
        EACH
        {
            const double step = (t[i] * t[i] * near.b[i] - nearer(x[i], FAR)) / (t[i] * near.a[i]);
            t[i] -= step;
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const double goal = nearer(x[i], FAR);
        const dd excess = dd_add_double(dd_mul(dd_product(t[i], t[i]), pair(&d.b, i)), -goal);
        const double step = -excess.hi / (t[i] * d.a.hi[i]);
        const dd lost = dd_mul_double(pair(&d.a, i), t[i]);
        const dd near_value = dd_fast_sum(lost.hi, lost.lo + checked(step, t[i]) * d.e.hi[i]);
        put(value, i, chosen(x[i] < FAR, near_value, ONE));
    }
}

/* -sigma with sigma - log(1 + sigma) = x: sigma = exp(t) - 1 = t A/E, exp(t) - 1 - t = t^2 (A - B)/E = x. */
void wm1_offset(const double *x, pairs *value)
{
    double t[LANES];
    plain_decay near;
    decay d;
    EACH t[i] = plain_log1p(sqrt(2.0 * x[i]) + x[i]);
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(t, &near);
        far = 0;
        EACH
        { /* in logarithms, which are nearly straight */
            const double between = near.a[i] - near.b[i];
            const double excess = t[i] + plain_log(between * (t[i] * t[i] / x[i]));
            const double step = excess * t[i] * between / near.a[i];
            t[i] = least(t[i] - step, LARGEST_DECAY);
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const dd between = dd_add(pair(&d.a, i), dd_minus(pair(&d.b, i))), lost = dd_mul_double(pair(&d.a, i), t[i]);
        const dd goal = dd_mul_double(pair(&d.e, i), x[i]);
        const dd excess = dd_add(dd_mul(dd_product(t[i], t[i]), between), dd_minus(goal));
        const double step = checked(-excess.hi / lost.hi, least(t[i], 1.0));
        put(value, i, dd_minus(dd_div(dd_fast_sum(lost.hi, lost.lo + step), pair(&d.e, i))));
    }
}

#define BRANCH -0.25
static const double INVERSE_E[3] = {0x1.78b56362cef38p-2, -0x1.ca8a4270fadf5p-57, -0x1.837912b3fd2aap-111};
static const dd E = {0x1.5bf0a8b145769p+1, 0x1.4d57ee2b1013ap-53};

/* 1 + e x where x < BRANCH, something harmless elsewhere; whether there is such an x */
static int branch_squares(const double *x, pairs *square)
{
    int some = 0;
    EACH
    {
        const double m = x[i] < BRANCH ? x[i] : BRANCH;
        const dd sum = dd_sum(INVERSE_E[0], m);
        const dd beyond = dd_add_double(dd_sum(sum.lo, INVERSE_E[1]), INVERSE_E[2]);
        put(square, i, dd_mul(dd_add(dd_sum(sum.hi, beyond.hi), (dd){beyond.lo, 0.0}), E));
        some |= x[i] < BRANCH;
    }
    return some;
}

/* t = |w|, t = |x| E(t) for x > 0 and t E(t) = |x| for x < 0: log(t/|x|) + t, or - t, is 0 */
static void w0_plainly(const double *x, pairs *value)
{
    double t[LANES];
    decay d;
    EACH
    {
        const double m = fabs(x[i]);
        t[i] = x[i] > 0.0 ? plain_log1p(m / (1.0 + plain_log1p(m))) : m / (1.0 - m);
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        far = 0;
        EACH
        {
            const double sign = x[i] > 0.0 ? 1.0 : -1.0;
            const double step = (plain_log(t[i] / fabs(x[i])) + sign * t[i]) * t[i] / (1.0 + sign * t[i]);
            t[i] -= step;
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const int above = x[i] > 0.0;
        const double m = fabs(x[i]);
        const dd root = {t[i], 0.0}, e = pair(&d.e, i);
        const dd product = dd_mul_double(e, above ? m : t[i]);
        const dd excess = chosen(above, dd_add(root, dd_minus(product)), dd_add_double(product, -m));
        const dd size = improved(t[i], -excess.hi / (above ? 1.0 + t[i] : (1.0 - t[i]) * e.hi));
        put(value, i, chosen(above, size, dd_minus(size)));
    }
}

/* s - 1 with 1 + (s - 1) exp(s) = 1 + e x near the branch point, where t - 1 would cancel in that equation */
void w0(const double *x, pairs *value)
{
    double s[LANES], lacking[LANES], plain[LANES];
    pairs square, far;
    decay d;
    EACH plain[i] = x[i] < BRANCH ? 1.0 : x[i];
    w0_plainly(plain, &far);
    const int branch = branch_squares(x, &square);
    if (branch)
        launch(&square, s, &d, lacking);
    EACH
    {
        const dd near_value = branch ? dd_add_double(dd_sum(s[i], lacking[i]), -1.0) : ONE;
        put(value, i, chosen(x[i] < BRANCH, near_value, pair(&far, i)));
    }
}

/* v = -w > 1, v E(v) = |x|: v - log(v) = -log|x| */
static void wm1_plainly(const double *x, pairs *value)
{
    double v[LANES], goal[LANES];
    decay d;
    EACH
    {
        goal[i] = -plain_log(-x[i]);
        v[i] = goal[i] + plain_log(goal[i] + plain_log(1.0 + goal[i]));
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        far = 0;
        EACH
        {
            const double step = (v[i] - plain_log(v[i]) - goal[i]) * v[i] / (v[i] - 1.0);
            v[i] -= step;
            far |= too_long(step, v[i]);
        }
    }
    decays(v, &d);
    EACH
    {
        const dd e = pair(&d.e, i);
        const dd excess = dd_add_double(dd_mul_double(e, v[i]), x[i]);
        put(value, i, dd_minus(improved(v[i], excess.hi / ((v[i] - 1.0) * e.hi))));
    }
}

/* t = -1 - w with 1 - (1 + t) exp(-t) = t^2 (A - B) = 1 + e x; its derivative is t E. */
static void wm1_branch(const pairs *square, pairs *value)
{
    double t[LANES];
    plain_decay near;
    decay d;
    EACH
    {
        const double p = sqrt(2.0 * square->hi[i]);
        t[i] = p * (1.0 + p / 3.0);
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(t, &near);
        far = 0;
        EACH
        {
            const double step = (t[i] * t[i] * (near.a[i] - near.b[i]) - square->hi[i]) / (t[i] * near.e[i]);
            t[i] -= step;
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const dd between = dd_add(pair(&d.a, i), dd_minus(pair(&d.b, i)));
        const dd excess = dd_add(dd_mul(dd_product(t[i], t[i]), between), dd_minus(pair(square, i)));
        put(value, i, dd_minus(dd_add(ONE, improved(t[i], -excess.hi / (t[i] * d.e.hi[i])))));
    }
}

void wm1(const double *x, pairs *value)
{
    double plain[LANES];
    pairs square, near;
    EACH plain[i] = x[i] < BRANCH ? BRANCH : x[i];
    wm1_plainly(plain, value);
    if (!branch_squares(x, &square))
        return;
    wm1_branch(&square, &near);
    EACH put(value, i, chosen(x[i] < BRANCH, pair(&near, i), pair(value, i)));
}
