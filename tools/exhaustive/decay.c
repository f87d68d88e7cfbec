/* By B's series and doublings.
 *
 * Error of the pairs. At t/2^k: the terms kept in pairs err by 6 * 2^-102 in all, those of order 6 on, in doubles, by less
 * than 2^-24/8! * 2^-51 < 2^-90 of a B >= 0.48, the series is cut below 2^-104: B errs by 2^-88 of itself, A and E by
 * less. A doubling doubles E's error and adds 2^-102; A gains at most E's, weighted by E/(1 + E); B no more than twice A's
 * in all. With k <= 13 that is less than 2^-84 for A and B, and 2^-75 for E, relatively; below, 2^-72 is counted on.
 */
#include "decay.h"

/* (-1)^k/(k + 2)!, in pairs */
static const dd SERIES[TERMS] = {
    {0x1.0000000000000p-1, 0x0.0p+0},
    {-0x1.5555555555555p-3, -0x1.5555555555555p-57},
    {0x1.5555555555555p-5, 0x1.5555555555555p-59},
    {-0x1.1111111111111p-7, -0x1.1111111111111p-63},
    {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
    {-0x1.a01a01a01a01ap-13, -0x1.a01a01a01a01ap-73},
    {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76},
    {-0x1.71de3a556c734p-19, 0x1.c154f8ddc6c00p-73},
    {0x1.27e4fb7789f5cp-22, 0x1.cbbc05b4fa99ap-76},
    {-0x1.ae64567f544e4p-26, 0x1.c062e06d1f209p-80},
    {0x1.1eed8eff8d898p-29, -0x1.2aec959e14c06p-83},
    {-0x1.6124613a86d09p-33, -0x1.f28e0cc748ebep-87},
    {0x1.93974a8c07c9dp-37, 0x1.05d6f8a2efd1fp-92},
    {-0x1.ae7f3e733b81fp-41, -0x1.1d8656b0ee8cbp-97},
    {0x1.ae7f3e733b81fp-45, 0x1.1d8656b0ee8cbp-101},
    {-0x1.952c77030ad4ap-49, -0x1.ac981465ddc6cp-103},
};

static int doublings(const double *t)
{
    double most = 0.0;
    for (int i = 0; i < LANES; i++)
        most = t[i] > most ? t[i] : most;
    int k = 0;
    while (k < DOUBLINGS && ldexp(most, -k) > 0.0625)
        k++;
    return k;
}

void decays(const double *t, decay *d)
{
    const int times = doublings(t);
    const double part = ldexp(1.0, -times);
    for (int i = 0; i < LANES; i++) {
        const double r = t[i] * part;
        double tail = SERIES[TERMS - 1].hi;
        UNROLLED
        for (int k = TERMS - 2; k >= PAIRED; k--)
            tail = fma(tail, r, SERIES[k].hi);
        dd b = {tail, 0.0};
        UNROLLED
        for (int k = PAIRED - 1; k >= 0; k--)
            b = dd_add(dd_mul_double(b, r), SERIES[k]);
        const dd a = dd_add((dd){1.0, 0.0}, dd_minus(dd_mul_double(b, r)));
        put(&d->e, i, dd_add((dd){1.0, 0.0}, dd_minus(dd_mul_double(a, r))));
        put(&d->a, i, a);
        put(&d->b, i, b);
    }
    for (int k = 0; k < times; k++)
        for (int i = 0; i < LANES; i++) {
            const dd e = pair(&d->e, i), a = pair(&d->a, i), b = pair(&d->b, i);
            put(&d->b, i, dd_times_power(dd_add(dd_mul(a, a), dd_times_power(b, 2.0)), 0.25));
            put(&d->a, i, dd_times_power(dd_add(a, dd_mul(a, e)), 0.5));
            put(&d->e, i, dd_mul(e, e));
        }
}

void plain_decays(const double *t, plain_decay *d)
{
    const int times = doublings(t);
    const double part = ldexp(1.0, -times);
    for (int i = 0; i < LANES; i++) {
        const double r = t[i] * part;
        double b = SERIES[10].hi;
        UNROLLED
        for (int k = 9; k >= 0; k--)
            b = fma(b, r, SERIES[k].hi);
        const double a = fma(-b, r, 1.0);
        d->e[i] = fma(-a, r, 1.0);
        d->a[i] = a;
        d->b[i] = b;
    }
    for (int k = 0; k < times; k++)
        for (int i = 0; i < LANES; i++) {
            const double e = d->e[i], a = d->a[i];
            d->b[i] = 0.25 * fma(a, a, 2.0 * d->b[i]);
            d->a[i] = 0.5 * fma(a, e, a);
            d->e[i] = e * e;
        }
}
