#include "search.h"

#include <math.h>
#include <string.h>

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

void random_inputs(uint64_t *state, size_t n, double low, double high, int dense, double *x)
{
    const double from = fabs(low), to = fabs(high); /* bits are in the order of sizes */
    uint64_t first, last;
    memcpy(&first, &from, sizeof first);
    memcpy(&last, &to, sizeof last);
    for (size_t i = 0; i < n; i++) {
        const uint64_t random = next(state);
        const uint64_t bits = first + random % (last - first + 1);
        memcpy(&x[i], &bits, sizeof bits);
        x[i] = high < 0.0 ? -x[i] : x[i];
        if (dense)
            x[i] = low + (high - low) * ((double)(random >> 11) * 0x1p-53);
    }
}

void errors(const reference *of, double_function tested, size_t n, const double *x, double *ulp)
{
    double y[REFERENCE_LANES], hi[REFERENCE_LANES], lo[REFERENCE_LANES];
    for (; n >= REFERENCE_LANES; n -= REFERENCE_LANES, x += REFERENCE_LANES, ulp += REFERENCE_LANES) {
        tested(REFERENCE_LANES, x, y);
        reference_values(of, x, hi, lo);
        for (int i = 0; i < REFERENCE_LANES; i++)
            ulp[i] = fabs((y[i] - hi[i]) - lo[i]) / ldexp(1.0, ilogb(hi[i]) - 52);
    }
}

static void keep(worst_found *found, double ulp, double input)
{
    int least = 0;
    for (int k = 1; k < WORST; k++)
        if (found->ulp[k] < found->ulp[least])
            least = k;
    if (ulp > found->ulp[least])
        found->ulp[least] = ulp, found->input[least] = input;
}

void search(const reference *of, double_function tested, uint64_t *state, uint64_t count, double low, double high, int dense,
            worst_found *found)
{
    double x[REFERENCE_LANES], ulp[REFERENCE_LANES];
    for (uint64_t done = 0; done < count; done += REFERENCE_LANES) {
        random_inputs(state, REFERENCE_LANES, low, high, dense, x);
        errors(of, tested, REFERENCE_LANES, x, ulp);
        for (int i = 0; i < REFERENCE_LANES; i++) {
            found->undecided += ulp[i] != ulp[i];
            keep(found, ulp[i], x[i]);
        }
        found->tried += REFERENCE_LANES;
    }
}
