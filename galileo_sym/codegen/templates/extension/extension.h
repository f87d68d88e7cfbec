/* What the sources of the Python extension share: the tables of what is emitted, and NumPy's C API. */
#ifndef GALILEO_EXTENSION_H
#define GALILEO_EXTENSION_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#define PY_ARRAY_UNIQUE_SYMBOL gs_array_api
#define PY_UFUNC_UNIQUE_SYMBOL gs_ufunc_api
#ifndef GS_IMPORTS_NUMPY
#define NO_IMPORT_ARRAY
#define NO_IMPORT_UFUNC
#endif
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <numpy/dtype_api.h>
#include <numpy/ufuncobject.h>

@SIZES@

/* Index of what comes for both types. */
enum { GS_DOUBLE, GS_SINGLE, GS_KINDS };

/* A C function on arrays or on single numbers, whatever its number of arguments: pointers to these in order. */
typedef void gs_arrays(size_t n, const void *const *in, void *const *out);
typedef void gs_numbers(const void *in, void *out);

typedef struct {
    double low[GS_KINDS], high;
} gs_interval;

/* A function with one set of forces. `matters` has, for each output, a bit for each argument that it depends on; `values`
 * take one value for each argument from `keywords` on, and are NULL where there is no such function. */
typedef struct {
    int inputs, outputs, keywords;
    unsigned matters[GS_MOST_OUTPUTS];
    const gs_interval *domain[GS_MOST_INPUTS];
    gs_arrays *arrays[GS_KINDS];
    gs_arrays *values[GS_KINDS];
    gs_numbers *numbers[GS_KINDS];
} gs_form;

/* A ufunc: a form, and which of its outputs it gives, GS_EVERY or one. */
enum { GS_EVERY = -1 };
typedef struct {
    const char *name, *doc;
    const gs_form *form;
    int output;
} gs_ufunc;

/* A public function: its forms by the forces that act (a bit for each, in the order of the arguments), and the indices
 * of their ufuncs. */
typedef struct {
    const char *name;
    int operands, forces;
    const gs_form *forms[1 << GS_MOST_FORCES];
    int ufuncs[1 << GS_MOST_FORCES];
} gs_function;

extern const gs_ufunc gs_ufuncs[];
extern const gs_function gs_functions[];
extern const char gs_sources[];

/* Inner loops of ufuncs; data points to a gs_ufunc. */
void gs_loop_double(char **args, const npy_intp *counts, const npy_intp *steps, void *data);
void gs_loop_single(char **args, const npy_intp *counts, const npy_intp *steps, void *data);

/* Lets a ufunc of so many inputs and outputs serve integers, half precision and mixtures; -1 with an exception set. */
int gs_add_promoter(PyObject *ufunc, int inputs, int outputs);

/* Add the ufuncs of scenes to the module: of sums at points, of steps; -1 with an exception set. */
int gs_add_sums(PyObject *module);
int gs_add_steps(PyObject *module);

/* What calls public functions: entry(name, otherwise), a method of the module. */
PyObject *gs_new_entry(PyObject *module, PyObject *args);
int gs_ready_entries(PyObject *module);

#endif
