/* Public functions called with single numbers or plain arrays; all else is left to Python. */
#include "extension.h"

#include <fenv.h>
#include <math.h>
#include <stddef.h>

/* How a number takes part in the choice of a type: Python's follow the others, and are float64 among themselves. */
typedef enum { GS_NO_NUMBER, GS_WEAK, GS_STRONG_SINGLE, GS_STRONG_DOUBLE, GS_ERROR } gs_strength;

enum { GS_OPTIONS = 4, GS_MOST_OPERANDS = GS_MOST_INPUTS };

typedef struct {
    PyObject_HEAD
    vectorcallfunc call;
    const gs_function *row;
    PyObject *otherwise;
    PyObject *ufuncs[1 << GS_MOST_FORCES];
} gs_entry;

static PyObject *gs_same_kind;

static gs_strength gs_read_number(PyObject *given, double *value)
{
    if (PyFloat_CheckExact(given)) {
        *value = PyFloat_AS_DOUBLE(given);
        return GS_WEAK;
    }
    if (Py_IS_TYPE(given, &PyDoubleArrType_Type)) {
        *value = PyArrayScalar_VAL(given, Double);
        return GS_STRONG_DOUBLE;
    }
    if (Py_IS_TYPE(given, &PyFloatArrType_Type)) {
        *value = PyArrayScalar_VAL(given, Float);
        return GS_STRONG_SINGLE;
    }
    if (PyLong_CheckExact(given)) {
        *value = PyLong_AsDouble(given);
        return *value == -1.0 && PyErr_Occurred() ? GS_ERROR : GS_WEAK;
    }
    return GS_NO_NUMBER;
}

/* None but a plain array for the only result. */
static int gs_plain_options(const gs_function *row, PyObject *const *options)
{
    const int no_target = options[0] == Py_None || (row->forms[0]->outputs == 1 && PyArray_CheckExact(options[0]));
    return no_target && options[1] == Py_True && options[2] == Py_None && options[3] == gs_same_kind;
}

/* Bits of the forces that are not 0, of the numbers of all operands. */
static unsigned gs_acting(const gs_function *row, const double *values)
{
    unsigned acting = 0;
    for (int i = 0; i < row->forces; i++)
        acting |= (unsigned)(values[row->operands - row->forces + i] != 0.0) << i;
    return acting;
}

static int gs_takes_part(const gs_function *row, unsigned acting, int operand)
{
    const int force = operand - (row->operands - row->forces);
    return force < 0 || acting >> force & 1;
}

static const int gs_reported = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW;

static void gs_lower_flags(void)
{
    if (fetestexcept(gs_reported)) /* clearing takes many times as long as looking */
        feclearexcept(gs_reported);
}

static PyObject *gs_number(gs_strength strength, const void *value, int place)
{
    PyObject *made;
    if (strength == GS_STRONG_SINGLE) {
        made = PyArrayScalar_New(Float);
        if (made != NULL)
            PyArrayScalar_VAL(made, Float) = ((const float *)value)[place];
    } else {
        made = PyArrayScalar_New(Double);
        if (made != NULL)
            PyArrayScalar_VAL(made, Double) = ((const double *)value)[place];
    }
    return made;
}

/* Results for numbers: NULL without an exception if a flag is up, which the ufunc is to report, or a number too large. */
static PyObject *gs_of_numbers(const gs_function *row, const double *values, gs_strength strength)
{
    union {
        double wide[GS_MOST_OPERANDS];
        float narrow[GS_MOST_OPERANDS];
    } in;
    union {
        double wide[GS_MOST_OUTPUTS];
        float narrow[GS_MOST_OUTPUTS];
    } out;
    const unsigned acting = gs_acting(row, values);
    const gs_form *form = row->forms[acting];
    const int single = strength == GS_STRONG_SINGLE;
    for (int i = 0, count = 0; i < row->operands; i++) {
        if (!gs_takes_part(row, acting, i))
            continue;
        if (single) {
            in.narrow[count] = (float)values[i];
            if (isinf(in.narrow[count]) && !isinf(values[i]))
                return NULL;
        } else {
            in.wide[count] = values[i];
        }
        count++;
    }
    gs_lower_flags();
    form->numbers[single ? GS_SINGLE : GS_DOUBLE](&in, &out);
    if (fetestexcept(gs_reported))
        return NULL;
    if (form->outputs == 1)
        return gs_number(strength, &out, 0);
    PyObject *results = PyTuple_New(form->outputs);
    for (int o = 0; results != NULL && o < form->outputs; o++) {
        PyObject *one = gs_number(strength, &out, o);
        if (one == NULL)
            Py_CLEAR(results);
        else
            PyTuple_SET_ITEM(results, o, one);
    }
    return results;
}

static int gs_plain_array(PyObject *given)
{
    if (!PyArray_CheckExact(given))
        return 0;
    const int type = PyArray_TYPE((PyArrayObject *)given);
    return type == NPY_DOUBLE || type == NPY_FLOAT;
}

/* Results for arrays, of the ufunc; an int goes as a float, as it may be beyond every integer type. */
static PyObject *gs_of_arrays(const gs_entry *entry, PyObject *const *args, const double *values, unsigned acting)
{
    PyObject *passed[GS_MOST_OPERANDS + 1], *const target = args[entry->row->operands], *results = NULL;
    size_t count = 0, known = 0;
    for (int i = 0; i < entry->row->operands; i++)
        if (gs_takes_part(entry->row, acting, i)) {
            passed[count] = PyLong_CheckExact(args[i]) ? PyFloat_FromDouble(values[i]) : Py_NewRef(args[i]);
            known += passed[count++] != NULL;
        }
    if (target != Py_None) {
        passed[count++] = Py_NewRef(target);
        known++;
    }
    if (known == count)
        results = PyObject_Vectorcall(entry->ufuncs[acting], passed, count, NULL);
    while (count > 0)
        Py_XDECREF(passed[--count]);
    return results;
}

static PyObject *gs_call(PyObject *self, PyObject *const *args, size_t flags, PyObject *names)
{
    const gs_entry *entry = (const gs_entry *)self;
    const gs_function *row = entry->row;
    const Py_ssize_t given = PyVectorcall_NARGS(flags);
    double values[GS_MOST_OPERANDS];
    gs_strength strengths[GS_MOST_OPERANDS], strongest = GS_WEAK;
    int numbers = 0;
    PyObject *const target = given > row->operands ? args[row->operands] : Py_None;
    if (names != NULL || given != row->operands + GS_OPTIONS || !gs_plain_options(row, args + row->operands))
        return PyObject_Vectorcall(entry->otherwise, args, flags, names);
    for (int i = 0; i < row->operands; i++) {
        const gs_strength one = strengths[i] = gs_read_number(args[i], values + i);
        const int force = i >= row->operands - row->forces;
        if (one == GS_ERROR)
            return NULL;
        /* a force that is an array of no dimension may be 0, and one that is 0 of a type of its own decides the type */
        if (one == GS_NO_NUMBER) {
            values[i] = 1.0;
            if (!gs_plain_array(args[i]) || (force && PyArray_NDIM((PyArrayObject *)args[i]) == 0))
                return PyObject_Vectorcall(entry->otherwise, args, flags, names);
        }
        numbers += one != GS_NO_NUMBER;
        strongest = one > strongest ? one : strongest;
    }
    if (numbers == row->operands && target != Py_None)
        return PyObject_Vectorcall(entry->otherwise, args, flags, names);
    if (numbers == row->operands) {
        PyObject *results = gs_of_numbers(row, values, strongest);
        if (results != NULL || PyErr_Occurred())
            return results;
        return PyObject_Vectorcall(entry->otherwise, args, flags, names);
    }
    const unsigned acting = gs_acting(row, values);
    for (int i = 0; i < row->operands; i++)
        if (!gs_takes_part(row, acting, i) && strengths[i] != GS_WEAK)
            return PyObject_Vectorcall(entry->otherwise, args, flags, names);
    return gs_of_arrays(entry, args, values, acting);
}

static void gs_dealloc(PyObject *self)
{
    gs_entry *entry = (gs_entry *)self;
    for (int i = 0; i < 1 << GS_MOST_FORCES; i++)
        Py_CLEAR(entry->ufuncs[i]);
    Py_CLEAR(entry->otherwise);
    Py_TYPE(self)->tp_free(self);
}

static PyTypeObject gs_entry_type = {
    PyVarObject_HEAD_INIT(NULL, 0)
    .tp_name = "galileo_sym.generated._ufuncs.Entry",
    .tp_basicsize = sizeof(gs_entry),
    .tp_dealloc = gs_dealloc,
    .tp_vectorcall_offset = offsetof(gs_entry, call),
    .tp_call = PyVectorcall_Call,
    .tp_flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_VECTORCALL,
    .tp_doc = "A public function on all its operands, out, where, dtype and casting, by position.",
};

PyObject *gs_new_entry(PyObject *module, PyObject *args)
{
    const char *name;
    PyObject *otherwise;
    const gs_function *row = NULL;
    if (!PyArg_ParseTuple(args, "sO:entry", &name, &otherwise))
        return NULL;
    for (int i = 0; i < GS_FUNCTIONS; i++)
        if (strcmp(gs_functions[i].name, name) == 0)
            row = gs_functions + i;
    if (row == NULL)
        return PyErr_Format(PyExc_KeyError, "%s", name);
    gs_entry *entry = PyObject_New(gs_entry, &gs_entry_type);
    if (entry == NULL)
        return NULL;
    entry->call = gs_call;
    entry->row = row;
    entry->otherwise = Py_NewRef(otherwise);
    for (int i = 0; i < 1 << GS_MOST_FORCES; i++)
        entry->ufuncs[i] = NULL;
    for (int i = 0; i < 1 << row->forces; i++) {
        entry->ufuncs[i] = PyObject_GetAttrString(module, gs_ufuncs[row->ufuncs[i]].name);
        if (entry->ufuncs[i] == NULL) {
            Py_DECREF(entry);
            return NULL;
        }
    }
    return (PyObject *)entry;
}

int gs_ready_entries(PyObject *module)
{
    gs_same_kind = PyUnicode_InternFromString("same_kind");
    return gs_same_kind == NULL || PyType_Ready(&gs_entry_type) < 0
        || PyModule_AddObjectRef(module, "Entry", (PyObject *)&gs_entry_type) < 0 ? -1 : 0;
}
