/* Factors of the best launch, of a > 0: s with 1 + (s - 1) exp(s) = a^2. */
#include "solve.h"
#include "trigonometry.h"

void launch(const pairs *square, double *s, decay *d, double *lacking)
{
    plain_decay near;
    EACH
    {
        const double a = sqrt(square->hi[i]);
        s[i] = plain_log1p(1.4142135623730951 * a + a * a / (3.0 + 2.0 * plain_log1p(a)));
    }
    for (int k = 0, far = 1; k < STEPS && far; k++) {
        plain_decays(s, &near);
        far = 0;
        EACH
        { /* in logarithms, which are nearly straight */
            const double excess = s[i] + plain_log(near.b[i] * (s[i] * s[i] / square->hi[i]));
            const double step = excess / (1.0 + near.a[i] / (s[i] * near.b[i]));
            s[i] = least(s[i] - step, LARGEST_DECAY);
            far |= too_long(step, s[i]);
        }
    }
    decays(s, d);
    EACH
    {
        const dd drag = dd_mul(pair(square, i), pair(&d->e, i));
        const dd excess = dd_add(dd_mul(dd_product(s[i], s[i]), pair(&d->b, i)), dd_minus(drag));
        const double step = -excess.hi / (s[i] * d->a.hi[i] + drag.hi);
        lacking[i] = checked(step, least(s[i], 1.0));
    }
}

static void squares(const double *x, pairs *square) { EACH put(square, i, dd_product(x[i], x[i])); }

/* a/(exp(s) - 1) = a E/(s A); its logarithmic derivative in s is -1/(s A). */
void best_sine(const double *x, pairs *value)
{
    double s[LANES], lacking[LANES];
    pairs square;
    decay d;
    squares(x, &square);
    launch(&square, s, &d, lacking);
    EACH
    {
        const dd lost = dd_mul_double(pair(&d.a, i), s[i]);
        const dd sine = dd_div(dd_mul_double(pair(&d.e, i), x[i]), lost);
        put(value, i, dd_fast_sum(sine.hi, sine.lo - sine.hi * (lacking[i] / lost.hi)));
    }
}

/* its arcsine: one step from the double with nearly that tangent */
void best_angle(const double *x, pairs *value)
{
    pairs wanted;
    best_sine(x, &wanted);
    EACH
    {
        const double sine = wanted.hi[i];
        const double angle = plain_arctan(sine / sqrt((1.0 - sine) * (1.0 + sine)));
        const turn here = turned((dd){angle, 0.0});
        const dd excess = dd_add(pair(&wanted, i), dd_minus(here.sine));
        put(value, i, improved(angle, excess.hi / here.cosine.hi));
    }
}

/* sqrt(1 - (1 + s) E)/a = sqrt(s^2 (A - B))/a; the derivative under the root is s E. */
void max_range_factor(const double *x, pairs *value)
{
    double s[LANES], lacking[LANES];
    pairs square;
    decay d;
    squares(x, &square);
    launch(&square, s, &d, lacking);
    EACH
    {
        const dd between = dd_add(pair(&d.a, i), dd_minus(pair(&d.b, i)));
        const dd gained = dd_mul(dd_product(s[i], s[i]), between);
        const double root = sqrt(gained.hi);
        const double rest = fma(-root, root, gained.hi) + gained.lo + lacking[i] * s[i] * d.e.hi[i];
        put(value, i, dd_div(dd_fast_sum(root, rest / (2.0 * root)), (dd){x[i], 0.0}));
    }
}
