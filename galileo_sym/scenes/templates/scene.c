/* What the code of a scene needs beside the arithmetic of the library. */

/* Raises 'invalid' for an argument outside its domain. */
static int gs_refused(void)
{
    feraiseexcept(FE_INVALID);
    return 0;
}

/* The double of a factor; 0, and odd set, where a product of two such might leave the range. */
static double gs_factor(gs_scaled a, int *odd)
{
    if (a.hi == 0.0)
        return a.hi;
    if (a.e < -500 || a.e > 500) {
        *odd = 1;
        return 0.0;
    }
    return ldexp(a.hi, a.e);
}

/* A factor in two parts, the first of 26 bits. */
static gs_pair gs_halves(gs_scaled a, int *odd)
{
    const double scaled = 134217729.0 * a.hi, high = scaled - (scaled - a.hi);
    const gs_scaled one = {high, 0.0, a.e}, rest = {(a.hi - high) + a.lo, 0.0, a.e};
    const gs_pair parts = {gs_factor(one, odd), gs_factor(rest, odd)};
    return parts;
}

/* A factor in two parts, the first rounded to nearest. */
static gs_pair gs_parts(gs_scaled a, int *odd)
{
    const gs_scaled one = {a.hi, 0.0, a.e}, rest = {a.lo, 0.0, a.e};
    const gs_pair parts = {gs_factor(one, odd), gs_factor(rest, odd)};
    return parts;
}

/* A position between 0 and where it ends. */
static double gs_between(double value, double limit)
{
    const double least = limit < 0.0 ? limit : 0.0, most = limit < 0.0 ? 0.0 : limit;
    return isless(value, least) ? least : isgreater(value, most) ? most : value;
}
