/* The loops for GS_REAL. */

static GS_REAL GS_OF(gs_read)(const char *place) { return *(const GS_REAL *)place; }

/* Blocks of which inputs without a step are filled once, others gathered unless contiguous; outputs likewise. Keyword
 * arguments that do not vary go by value, if there is a function for that. */
static void GS_OF(gs_blocks)(const gs_form *form, int wanted, char **args, const npy_intp *steps, npy_intp n)
{
    GS_REAL inputs[GS_MOST_INPUTS][GS_BLOCK], outputs[GS_MOST_OUTPUTS][GS_BLOCK];
    const void *in[GS_MOST_INPUTS];
    void *out[GS_MOST_OUTPUTS];
    const npy_intp most = n < GS_BLOCK ? n : GS_BLOCK, dense = sizeof(GS_REAL);
    const int by_value = form->values[GS_KIND] != NULL && gs_uniform(form, steps);
    gs_arrays *const evaluate = by_value ? form->values[GS_KIND] : form->arrays[GS_KIND];
    npy_intp at_once = n;
    for (int i = 0; i < form->inputs; i++) {
        const int is_value = by_value && i >= form->keywords;
        if (steps[i] == 0)
            for (npy_intp j = 0; j < (is_value ? 1 : most); j++)
                inputs[i][j] = GS_OF(gs_read)(args[i]);
        if (steps[i] != dense && !is_value)
            at_once = most;
    }
    for (int o = 0; o < form->outputs; o++)
        if (!gs_given(wanted, o) || steps[gs_place(form, wanted, o)] != dense)
            at_once = most;
    for (npy_intp begin = 0; begin < n; begin += at_once) {
        const npy_intp count = n - begin < at_once ? n - begin : at_once;
        for (int i = 0; i < form->inputs; i++) {
            const char *from = args[i] + begin * steps[i];
            in[i] = steps[i] == dense ? (const void *)from : inputs[i];
            if (steps[i] != dense && steps[i] != 0)
                for (npy_intp j = 0; j < count; j++)
                    inputs[i][j] = GS_OF(gs_read)(from + j * steps[i]);
        }
        for (int o = 0; o < form->outputs; o++) {
            const int place = gs_place(form, wanted, o);
            const int direct = gs_given(wanted, o) && steps[place] == dense;
            out[o] = direct ? (void *)(args[place] + begin * dense) : outputs[o];
        }
        evaluate((size_t)count, in, out);
        for (int o = 0; o < form->outputs; o++) {
            const int place = gs_place(form, wanted, o);
            if (gs_given(wanted, o) && steps[place] != dense)
                for (npy_intp j = 0; j < count; j++)
                    *(GS_REAL *)(args[place] + (begin + j) * steps[place]) = outputs[o][j];
        }
    }
}

/* All outputs at one element. */
static void GS_OF(gs_one)(const gs_form *form, char **args, const npy_intp *steps, npy_intp element, GS_REAL *value)
{
    const void *in[GS_MOST_INPUTS];
    void *out[GS_MOST_OUTPUTS];
    for (int i = 0; i < form->inputs; i++)
        in[i] = args[i] + element * steps[i];
    for (int o = 0; o < form->outputs; o++)
        out[o] = value + o;
    form->arrays[GS_KIND](1, in, out);
}

/* All arguments that vary are inside their domains. A NaN is not, of which no flag is left. */
static int GS_OF(gs_inside)(const gs_form *form, char **args, const npy_intp *steps, npy_intp begin, npy_intp count)
{
    const int before = fetestexcept(FE_INVALID);
    int inside = 1;
    for (int i = 0; i < form->inputs; i++) {
        if (steps[i] == 0)
            continue;
        const GS_REAL low = (GS_REAL)form->domain[i]->low[GS_KIND], high = (GS_REAL)form->domain[i]->high;
        const char *from = args[i] + begin * steps[i];
        if (steps[i] == (npy_intp)sizeof(GS_REAL))
            for (npy_intp j = 0; j < count; j++)
                inside &= ((const GS_REAL *)from)[j] >= low && ((const GS_REAL *)from)[j] <= high;
        else
            for (npy_intp j = 0; j < count; j++) {
                const GS_REAL x = GS_OF(gs_read)(from + j * steps[i]);
                inside &= x >= low && x <= high;
            }
    }
    if (!inside && !before)
        feclearexcept(FE_INVALID);
    return inside;
}

static void GS_OF(gs_put)(const gs_form *form, int wanted, char **args, const npy_intp *steps, npy_intp begin,
                          npy_intp count, const GS_REAL *value)
{
    for (int o = 0; o < form->outputs; o++) {
        if (!gs_given(wanted, o))
            continue;
        const int place = gs_place(form, wanted, o);
        char *to = args[place] + begin * steps[place];
        if (steps[place] == (npy_intp)sizeof(GS_REAL))
            for (npy_intp j = 0; j < count; j++)
                ((GS_REAL *)to)[j] = value[o];
        else
            for (npy_intp j = 0; j < count; j++)
                *(GS_REAL *)(to + j * steps[place]) = value[o];
    }
}

/* One evaluation for all elements inside the domains of what varies; the others are evaluated each. */
static void GS_OF(gs_spread)(const gs_form *form, int wanted, char **args, const npy_intp *steps, npy_intp n)
{
    GS_REAL shared[GS_MOST_OUTPUTS], single[GS_MOST_OUTPUTS];
    int known = 0;
    for (npy_intp begin = 0; begin < n; begin += GS_BLOCK) {
        const npy_intp count = n - begin < GS_BLOCK ? n - begin : GS_BLOCK;
        if (GS_OF(gs_inside)(form, args, steps, begin, count)) {
            if (!known)
                GS_OF(gs_one)(form, args, steps, begin, shared);
            known = 1;
            GS_OF(gs_put)(form, wanted, args, steps, begin, count, shared);
            continue;
        }
        for (npy_intp j = begin; j < begin + count; j++) {
            GS_OF(gs_one)(form, args, steps, j, single);
            GS_OF(gs_put)(form, wanted, args, steps, j, 1, single);
        }
    }
}

void GS_OF(gs_loop)(char **args, const npy_intp *counts, const npy_intp *steps, void *data)
{
    const gs_ufunc *ufunc = data;
    if (gs_constant(ufunc->form, ufunc->output, steps))
        GS_OF(gs_spread)(ufunc->form, ufunc->output, args, steps, counts[0]);
    else
        GS_OF(gs_blocks)(ufunc->form, ufunc->output, args, steps, counts[0]);
}
