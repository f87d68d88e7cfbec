#include "judge.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define LANES REFERENCE_LANES
#define EACH for (int i = 0; i < LANES; i++)

enum { WRONG, UNDECIDED, RIGHT, REFUSED };

static void list(uint32_t *inputs, uint64_t *count, uint32_t bits)
{
    if (*count < LISTED)
        inputs[*count] = bits;
    ++*count;
}

static inline double widened(uint32_t bits) /* what would be infinite is the next power of two */
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x > FLT_MAX ? 0x1p128 : x < -FLT_MAX ? -0x1p128 : x;
}

static uint32_t next_up(uint32_t bits)
{
    return bits == 0x80000000 ? 1 : bits >> 31 ? bits - 1 : bits + 1; /* from -0, as from 0 */
}

static uint32_t next_down(uint32_t bits) { return next_up(bits ^ 0x80000000) ^ 0x80000000; }

/* The finite value hi + lo is nearest to the float y, if it lies between the midpoints around y. */
static int finite_verdict(uint32_t y, double hi, double lo, double *distance)
{
    const double here = widened(y), margin = DECISION * fabs(hi);
    const double above = 0.5 * (here + widened(next_up(y))) - hi - lo;
    const double below = hi - 0.5 * (here + widened(next_down(y))) + lo;
    *distance = (above < below ? above : below) / fabs(hi);
    if (here != here || above < -margin || below < -margin || (here == 0.0 && (y >> 31) != (hi < 0.0)))
        return WRONG;
    return above > margin && below > margin ? RIGHT : UNDECIDED; /* lo NaN: undecided */
}

static int verdict(uint32_t bits, float y, double hi, double lo, double *distance)
{
    *distance = INFINITY;
    if (hi != hi)
        return y != y ? REFUSED : WRONG;
    if (isinf(hi) || hi == 0.0)
        return y == hi && !signbit(y) == !signbit(hi) ? RIGHT : WRONG;
    return finite_verdict(bits, hi, lo, distance);
}

/* No argument among them: NaN is due, and no reference needed. */
static int nothing_due(const reference *of, const float *x)
{
    const double lower = of->least, upper = of->greatest;
    int arguments = 0;
    EACH arguments += (x[i] >= lower) & (x[i] <= upper);
    return arguments == 0;
}

static void judge_one(uint32_t x, uint32_t y_bits, float y, double hi, double lo, report *found)
{
    double distance;
    switch (verdict(y_bits, y, hi, lo, &distance)) {
    case RIGHT:
        found->right++;
        if (distance < found->nearest)
            found->nearest = distance, found->nearest_input = x;
        break;
    case REFUSED:
        found->refused++;
        break;
    case UNDECIDED:
        list(found->undecided_inputs, &found->undecided, x);
        break;
    default:
        list(found->wrong_inputs, &found->wrong, x);
    }
}

/* Whether all values are finite and right, none nearer to a midpoint than what was found: the usual case, vectorised. */
static int all_right(const uint32_t *y, const double *hi, const double *lo, double nearest)
{
    int doubtful = 0;
    EACH
    {
        const uint32_t size = y[i] & 0x7fffffff;
        const double sign = hi[i] < 0.0 ? -1.0 : 1.0, head = sign * hi[i], rest = sign * lo[i];
        const double here = widened(size), margin = nearest * head;
        const double above = 0.5 * (here + widened(size + 1)) - head - rest;
        const double below = head - 0.5 * (here + widened(size - 1)) + rest;
        const int usual = (size - 1 < 0x7f7fffff) & (y[i] >> 31 == (hi[i] < 0.0)); /* neither 0 nor infinity */
        doubtful += !(usual & (above > margin) & (below > margin));
    }
    return doubtful == 0 && nearest > DECISION;
}

static void judge_lanes(const reference *of, const uint32_t *x_bits, const float *x, const float *y, report *found)
{
    double wide[LANES], hi[LANES], lo[LANES];
    uint32_t y_bits[LANES];
    memcpy(y_bits, y, sizeof y_bits);
    EACH wide[i] = x[i];
    reference_values(of, wide, hi, lo);
    if (all_right(y_bits, hi, lo, found->nearest))
        found->right += LANES;
    else
        EACH judge_one(x_bits[i], y_bits[i], y[i], hi[i], lo[i], found);
}

static void judge_refusals(const uint32_t *x_bits, const float *y, report *found)
{
    EACH if (y[i] != y[i]) found->refused++;
    else list(found->wrong_inputs, &found->wrong, x_bits[i]);
}

static void compare(const uint32_t *x_bits, const float *y, const float *other, report *found)
{
    if (memcmp(y, other, LANES * sizeof *y))
        EACH if (memcmp(&y[i], &other[i], sizeof *y)) list(found->differing_inputs, &found->differing, x_bits[i]);
}

void judge(const reference *of, const array_function *tested, int versions, uint32_t first, uint64_t count, report *found)
{
    uint32_t bits[LANES];
    float x[LANES], y[LANES], other[LANES];
    for (uint64_t done = 0; done < count; done += LANES) {
        EACH bits[i] = first + (uint32_t)done + (uint32_t)i;
        memcpy(x, bits, sizeof x);
        tested[0](LANES, x, y);
        if (nothing_due(of, x)) {
            judge_refusals(bits, y, found);
            continue;
        }
        judge_lanes(of, bits, x, y, found);
        for (int k = 1; k < versions && done / LANES % SPARSELY == 0; k++) {
            tested[k](LANES, x, other);
            compare(bits, y, other, found);
        }
    }
}
