/* The steps of scenes as ufuncs: arithmetic on scaled pairs (hi, lo, e), with the bits of the NumPy modules. */
#include "extension.h"

#include "galileo_versions.h"

#define GS_SUFFIX _plain
#include "steps.h"

/* A ufunc: the operation, and the types of what it takes and gives. */
#define GS_STEPS(row)                                                                                                  \
    row(load, "d", "ddi") row(angle, "d", "ddd?dddiddi") row(driving, "ddd?dddiddiddi", "ddi")                         \
    row(mul, "ddiddi", "ddi") row(div, "ddiddi", "ddi") row(add, "ddiddi", "ddi") row(sub, "ddiddi", "ddi")            \
    row(sqrt, "ddi", "ddi") row(phi0m, "ddi", "ddi") row(phi1m, "ddi", "ddi") row(phi2m, "ddi", "ddi")                 \
    row(descent_factor, "ddi", "ddi") row(flight_factor, "ddi", "ddi") row(range_factor, "ddi", "ddi")                 \
    row(round, "ddi", "d?") row(halves, "ddi", "dd?") row(parts, "ddi", "dd?")

typedef struct {
    const char *name, *inputs, *outputs;
    PyUFuncGenericFunction loop;
} gs_step;

#define GS_DECLARED(name, inputs, outputs)                                                                             \
    void gs_step_##name##_fma(char **args, const ptrdiff_t *counts, const ptrdiff_t *steps, void *data);
#define GS_ROW_OF(name, inputs, outputs) {"_step_" #name, inputs, outputs, GS_CHOOSE_SINGLE(gs_step_##name)},

GS_STEPS(GS_DECLARED)

enum { GS_COUNT = 17, GS_MOST_OPERANDS = 17 };

static char gs_type_of(char letter) { return letter == 'd' ? NPY_DOUBLE : letter == 'i' ? NPY_INT : NPY_BOOL; }

int gs_add_steps(PyObject *module)
{
    static PyUFuncGenericFunction loops[GS_COUNT];
    static void *data[GS_COUNT];
    static char types[GS_COUNT][GS_MOST_OPERANDS];
    const gs_step steps[GS_COUNT] = {GS_STEPS(GS_ROW_OF)};
    for (int k = 0; k < GS_COUNT; k++) {
        const gs_step *row = steps + k;
        const int inputs = (int)strlen(row->inputs), outputs = (int)strlen(row->outputs);
        for (int j = 0; j < inputs + outputs; j++)
            types[k][j] = gs_type_of(j < inputs ? row->inputs[j] : row->outputs[j - inputs]);
        loops[k] = row->loop;
        PyObject *made = PyUFunc_FromFuncAndData(loops + k, data + k, types[k], 1, inputs, outputs, PyUFunc_None, row->name,
                                                 "A step of a scene, on scaled pairs.", 0);
        const int done = made == NULL ? -1 : PyModule_AddObjectRef(module, row->name, made);
        Py_XDECREF(made);
        if (done < 0)
            return -1;
    }
    return 0;
}
