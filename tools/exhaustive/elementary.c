/* exp(-z), sine, cosine, arctangent. */
#include "solve.h"
#include "trigonometry.h"

#define QUARTER_PI 0x1.921fb54442d18p-1

void exp_minus(const double *x, pairs *value)
{
    double t[LANES];
    decay d;
    EACH t[i] = least(x[i], LARGEST_DECAY); /* beyond, less than any float */
    decays(t, &d);
    *value = d.e;
}

/* HALF_PI - x, or x where that is less; whether it is x */
static inline int folded(double x, dd *y)
{
    const int below = x <= QUARTER_PI;
    *y = chosen(below, (dd){x, 0.0}, dd_add_double(dd_add_double(HALF_PI, -x), HALF_PI_REST));
    return below;
}

void sine(const double *x, pairs *value)
{
    EACH
    {
        dd y;
        const int below = folded(x[i], &y);
        const turn here = turned(y);
        put(value, i, chosen(below, here.sine, here.cosine));
    }
}

void cosine(const double *x, pairs *value)
{
    EACH
    {
        dd y;
        const int below = folded(x[i], &y);
        const turn here = turned(y);
        put(value, i, chosen(below, here.cosine, here.sine));
    }
}

/* of r = x or 1/x, one step from a double: (r cos - sin)/(cos + r sin) is the tangent of what that lacks */
void arctangent(const double *x, pairs *value)
{
    EACH
    {
        const int below = x[i] <= 1.0;
        const dd r = chosen(below, (dd){x[i], 0.0}, dd_div(ONE, (dd){x[i], 0.0}));
        const double angle = plain_arctan(r.hi);
        const turn here = turned((dd){angle, 0.0});
        const dd excess = dd_add(dd_mul(r, here.cosine), dd_minus(here.sine));
        const dd found = improved(angle, excess.hi / (here.cosine.hi + r.hi * here.sine.hi));
        put(value, i, chosen(below, found, dd_add(HALF_PI, dd_minus(found))));
    }
}
