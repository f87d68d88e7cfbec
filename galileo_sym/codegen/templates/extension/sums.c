/* The ufunc for outputs of scenes that are sums: a b + c d over a grid in one pass, each operand in two parts. */
#include "extension.h"

#include "galileo_versions.h"

#define GS_LANES 1
#define GS_SUFFIX _plain
#include "sums.h"

enum { GS_PARTS = 8, GS_GATHERED = 256 };

typedef void gs_summing(size_t n, unsigned varying, const double *const *in, double *out);
gs_summing gs_sums_avx512, gs_sums_avx2;

/* Elements that do not follow each other, through blocks of those that do. */
static void gs_scattered(gs_summing *sums, char **args, const npy_intp *steps, npy_intp n)
{
    double block[GS_PARTS][GS_GATHERED], found[GS_GATHERED];
    const double *in[GS_PARTS];
    for (npy_intp begin = 0; begin < n; begin += GS_GATHERED) {
        const npy_intp count = n - begin < GS_GATHERED ? n - begin : GS_GATHERED;
        for (int k = 0; k < GS_PARTS; k++) {
            for (npy_intp j = 0; j < count; j++)
                block[k][j] = *(const double *)(args[k] + (begin + j) * steps[k]);
            in[k] = block[k];
        }
        sums((size_t)count, 15, in, found);
        for (npy_intp j = 0; j < count; j++)
            *(double *)(args[GS_PARTS] + (begin + j) * steps[GS_PARTS]) = found[j];
    }
}

static void gs_sums_loop(char **args, const npy_intp *counts, const npy_intp *steps, void *data)
{
    const npy_intp n = counts[0], dense = sizeof(double);
    gs_summing *const sums = GS_CHOOSE(gs_sums);
    const double *in[GS_PARTS];
    unsigned varying = 0;
    int direct = steps[GS_PARTS] == dense;
    (void)data;
    for (int k = 0; k < GS_PARTS; k += 2) {
        const npy_intp step = steps[k];
        direct &= step == steps[k + 1] && (step == 0 || step == dense);
        varying |= (unsigned)(step != 0) << k / 2;
        in[k] = (const double *)args[k];
        in[k + 1] = (const double *)args[k + 1];
    }
    if (n > 0 && direct)
        sums((size_t)n, varying, in, (double *)args[GS_PARTS]);
    else
        gs_scattered(sums, args, steps, n);
}

int gs_add_sums(PyObject *module)
{
    static PyUFuncGenericFunction loops[] = {gs_sums_loop};
    static void *data[] = {NULL};
    static const char types[GS_PARTS + 1] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE,
                                             NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
    PyObject *made = PyUFunc_FromFuncAndData(
        loops, data, types, 1, GS_PARTS, 1, PyUFunc_None, "_sum_of_products",
        "a b + c d of operands in two parts, a, its rest, b, its rest, ...; products of first parts must be exact.", 0);
    if (made == NULL)
        return -1;
    const int done = PyModule_AddObjectRef(module, "_sum_of_products", made);
    Py_DECREF(made);
    return done;
}
