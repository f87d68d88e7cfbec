/* The references by name, and their values where there is nothing to solve. */
#include "reference.h"

#include <string.h>

#include "solve.h"

#define HALF_PI_BELOW 0x1.921fb54442d18p+0 /* the doubles within the domains of sine and cosine, and of W */
#define BRANCH_ABOVE -0x1.78b56362cef37p-2

static const reference REFERENCES[] = {
    {"phi1m", phi1m, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, 0.0},
    {"phi2m", phi2m, 0, 0.0, INFINITY, 1.0, 0.5, 0.5, 0.0},
    {"descent_factor", descent_factor, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, INFINITY},
    {"flight_factor", flight_factor, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, 0.5},
    {"range_factor", range_factor, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, 0.0},
    {"best_sine", best_sine, 0, 0.0, INFINITY, 1.0, 0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0},
    {"best_angle", best_angle, 0, 0.0, INFINITY, 1.0, 0x1.921fb54442d18p-1, 0x1.921fb54442d18p-1, 0.0},
    {"max_range_factor", max_range_factor, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, 0.0},
    {"w0_offset", w0_offset, 0, 0.0, INFINITY, 1.0, 0.0, -0.0, 1.0},
    {"wm1_offset", wm1_offset, 0, 0.0, INFINITY, 1.0, 0.0, 0.0, -INFINITY},
    {"w0", w0, 0, BRANCH_ABOVE, INFINITY, 1.0, 0.0, -0.0, INFINITY},
    {"wm1", wm1, 0, BRANCH_ABOVE, 0.0, -0.25, -INFINITY, -INFINITY, NAN},
    {"exp_minus", exp_minus, 0, 0.0, INFINITY, 1.0, 1.0, 1.0, 0.0},
    {"sin", sine, -1, -HALF_PI_BELOW, HALF_PI_BELOW, 1.0, 0.0, -0.0, NAN},
    {"cos", cosine, 1, -HALF_PI_BELOW, HALF_PI_BELOW, 1.0, 1.0, 1.0, NAN},
    {"arctan", arctangent, -1, -INFINITY, INFINITY, 1.0, 0.0, -0.0, 0x1.921fb54442d18p+0},
};

const reference *reference_of(const char *name)
{
    for (size_t k = 0; k < sizeof REFERENCES / sizeof *REFERENCES; k++)
        if (!strcmp(REFERENCES[k].name, name))
            return &REFERENCES[k];
    return NULL;
}

static inline int is_argument(const reference *of, double x) { return (x >= of->least) & (x <= of->greatest); }

/* at an argument where there is something to solve */
static inline int is_regular(const reference *of, double x)
{
    const double size = fabs(x);
    return is_argument(of, x) & (size > 0.0) & (size < INFINITY);
}

static inline double sign_of(const reference *of, double x) { return of->parity < 0 ? copysign(1.0, x) : 1.0; }

void reference_values(const reference *of, const double *x, double *hi, double *lo)
{
    double inside[LANES];
    pairs value;
    int rest = 0;
    EACH
    {
        const int regular = is_regular(of, x[i]);
        const double in = of->parity ? fabs(x[i]) : x[i];
        inside[i] = regular ? in : of->ordinary;
        rest += !regular;
    }
    of->values(inside, &value);
    EACH
    {
        const double sign = sign_of(of, x[i]);
        hi[i] = sign * value.hi[i];
        lo[i] = sign * value.lo[i];
    }
    for (int i = 0; i < LANES && rest; i++)
        if (!is_regular(of, x[i])) {
            const double at_zero = signbit(x[i]) ? of->at_minus_zero : of->at_zero;
            const double limit = x[i] == 0.0 ? at_zero : sign_of(of, x[i]) * of->at_infinity;
            hi[i] = is_argument(of, x[i]) ? limit : NAN;
            lo[i] = 0.0;
        }
#ifdef REFERENCE_SHIFT /* a negative control */
    EACH hi[i] += hi[i] * REFERENCE_SHIFT;
#endif
}
