/* Inner loops: whatever the steps, the array functions of C see contiguous arguments. */
#include "extension.h"

#include <fenv.h>

enum { GS_BLOCK = 512 };

static int gs_given(int wanted, int output) { return wanted == GS_EVERY || wanted == output; }

/* Where an output is among the arguments of a loop. */
static int gs_place(const gs_form *form, int wanted, int output)
{
    return form->inputs + (wanted == GS_EVERY ? output : 0);
}

/* Arguments on which an output of a loop depends. */
static unsigned gs_matter(const gs_form *form, int wanted)
{
    unsigned found = 0;
    for (int o = 0; o < form->outputs; o++)
        found |= gs_given(wanted, o) ? form->matters[o] : 0;
    return found;
}

/* Nothing varies that a result depends on. */
static int gs_constant(const gs_form *form, int wanted, const npy_intp *steps)
{
    const unsigned matter = gs_matter(form, wanted);
    for (int i = 0; i < form->inputs; i++)
        if (matter >> i & 1 && steps[i] != 0)
            return 0;
    return 1;
}

/* None of the keyword arguments varies. */
static int gs_uniform(const gs_form *form, const npy_intp *steps)
{
    for (int i = form->keywords; i < form->inputs; i++)
        if (steps[i] != 0)
            return 0;
    return 1;
}

#define GS_REAL double
#define GS_KIND GS_DOUBLE
#define GS_OF(name) name##_double
#include "loops_of_type.h"
#undef GS_REAL
#undef GS_KIND
#undef GS_OF

#define GS_REAL float
#define GS_KIND GS_SINGLE
#define GS_OF(name) name##_single
#include "loops_of_type.h"
