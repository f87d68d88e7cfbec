/* Factors of drag: phi1m, phi2m, descent_factor, flight_factor, range_factor. */
#include "solve.h"

/* A = (1 - exp(-x))/x */
void phi1m(const double *x, pairs *value)
{
    double t[LANES];
    decay d;
    EACH t[i] = nearer(x[i], FAR);
    decays(t, &d);
    EACH put(value, i, chosen(x[i] < FAR, pair(&d.a, i), dd_div(ONE, (dd){x[i], 0.0})));
}

/* B = (x - 1 + exp(-x))/x^2 */
void phi2m(const double *x, pairs *value)
{
    double t[LANES];
    decay d;
    EACH t[i] = nearer(x[i], FAR);
    decays(t, &d);
    EACH
    {
        const dd inverse = dd_div(ONE, (dd){x[i], 0.0});
        put(value, i, chosen(x[i] < FAR, pair(&d.b, i), dd_mul(inverse, dd_add(ONE, dd_minus(inverse)))));
    }
}

/* tau with tau - 1 + exp(-tau) = tau^2 B = p^2/2; its derivative in tau is tau A. Where p > 16, tau = 1 + p^2/2. */
void descent_factor(const double *x, pairs *value)
{
    double t[LANES], half[LANES];
    plain_decay near;
    decay d;
    EACH
    {
        const double p = nearer(x[i], 16.0);
        half[i] = 0.5 * p * p;
        t[i] = p * sqrt(1.0 + p / 3.0 + 0.25 * p * p);
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(t, &near);
        far = 0;
        EACH
        {
            const double step = (t[i] * t[i] * near.b[i] - half[i]) / (t[i] * near.a[i]);
            t[i] -= step;
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const double p = nearer(x[i], 16.0);
        const dd excess = dd_add(dd_mul(dd_product(t[i], t[i]), pair(&d.b, i)), dd_times_power(dd_product(p, p), -0.5));
        const dd near_root = improved(t[i], -excess.hi / (t[i] * d.a.hi[i]));
        const dd far_value = dd_add(dd_product(x[i], 0.5), dd_div(ONE, (dd){x[i], 0.0}));
        put(value, i, chosen(x[i] < 16.0, dd_div(near_root, (dd){p, 0.0}), far_value));
    }
}

/* T with T = (1 + b)(1 - exp(-T)), that is T B = b A; the derivative of T B - b A in T is (1 + b)(A - B).
 * Where b > 64, T = 1 + b.
 */
static void flight(const double *x, pairs *root)
{
    double t[LANES];
    plain_decay near;
    decay d;
    EACH
    {
        const double b = nearer(x[i], FAR);
        t[i] = b * (2.0 + b) / (1.0 + b);
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(t, &near);
        far = 0;
        EACH
        {
            const double b = nearer(x[i], FAR);
            const double step = (t[i] * near.b[i] - b * near.a[i]) / ((1.0 + b) * (near.a[i] - near.b[i]));
            t[i] -= step;
            far |= too_long(step, t[i]);
        }
    }
    decays(t, &d);
    EACH
    {
        const double b = nearer(x[i], FAR);
        const dd excess = dd_add(dd_mul_double(pair(&d.b, i), t[i]), dd_minus(dd_mul_double(pair(&d.a, i), b)));
        const double step = -excess.hi / ((1.0 + b) * (d.a.hi[i] - d.b.hi[i]));
        put(root, i, chosen(x[i] < FAR, improved(t[i], step), dd_sum(1.0, x[i])));
    }
}

/* T/(2 b) */
void flight_factor(const double *x, pairs *value)
{
    pairs root;
    flight(x, &root);
    EACH put(value, i, dd_div(pair(&root, i), (dd){2.0 * x[i], 0.0}));
}

/* (1 - exp(-T))/(2 b) = T/(2 b (1 + b)) */
void range_factor(const double *x, pairs *value)
{
    pairs root;
    flight(x, &root);
    EACH put(value, i, dd_div(dd_div(pair(&root, i), (dd){2.0 * x[i], 0.0}), dd_sum(1.0, x[i])));
}
