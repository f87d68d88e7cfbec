/* Which loop serves which types: float64 for integers and bool, float32 for half precision, else as NumPy promotes. */
#include "extension.h"

static const char gs_unsupported[] = "arguments of type %S are not supported: convert them to float64 or float32";

/* The type that serves another one, borrowed; NULL if none does. */
static PyArray_DTypeMeta *gs_serving(PyArray_DTypeMeta *found)
{
    PyArray_DTypeMeta *const wide[] = {
        &PyArray_DoubleDType,  &PyArray_BoolDType, &PyArray_ByteDType,  &PyArray_UByteDType,    &PyArray_ShortDType,
        &PyArray_UShortDType,  &PyArray_IntDType,  &PyArray_UIntDType,  &PyArray_LongDType,     &PyArray_ULongDType,
        &PyArray_LongLongDType, &PyArray_ULongLongDType, &PyArray_PyLongDType, &PyArray_PyFloatDType,
    };
    if (found == &PyArray_FloatDType || found == &PyArray_HalfDType)
        return &PyArray_FloatDType;
    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++)
        if (found == wide[i])
            return &PyArray_DoubleDType;
    return NULL;
}

/* A type in words: the name of its numbers. */
static PyObject *gs_type_text(PyArray_DTypeMeta *type)
{
    PyObject *number = PyObject_GetAttrString((PyObject *)type, "type");
    PyObject *text = number == NULL ? NULL : PyObject_GetAttrString(number, "__name__");
    Py_XDECREF(number);
    return text;
}

static int gs_refuse(const char *message, PyArray_DTypeMeta *type)
{
    PyObject *text = gs_type_text(type);
    if (text != NULL)
        PyErr_Format(PyExc_TypeError, message, text);
    Py_XDECREF(text);
    return -1;
}

/* The type that dtype= or signature= asks for, borrowed; NULL if there is none, or with an exception set. */
static PyArray_DTypeMeta *gs_asked(PyArray_DTypeMeta *const signature[], int count)
{
    PyArray_DTypeMeta *asked = NULL;
    for (int i = 0; i < count; i++) {
        PyArray_DTypeMeta *one = signature[i];
        if (one == NULL)
            continue;
        if ((one != &PyArray_DoubleDType && one != &PyArray_FloatDType) || (asked != NULL && asked != one)) {
            gs_refuse("dtype=%S is not supported: ask for float64 or float32", one);
            return NULL;
        }
        asked = one;
    }
    return asked;
}

static int gs_promote(PyObject *ufunc, PyArray_DTypeMeta *const given[], PyArray_DTypeMeta *const signature[],
                      PyArray_DTypeMeta *chosen[])
{
    const int inputs = ((PyUFuncObject *)ufunc)->nin, count = ((PyUFuncObject *)ufunc)->nargs;
    for (int i = 0; i < inputs; i++)
        if (gs_serving(given[i]) == NULL)
            return gs_refuse(gs_unsupported, given[i]);
    PyArray_DTypeMeta *one = gs_asked(signature, count);
    if (one == NULL && PyErr_Occurred())
        return -1;
    if (one == NULL) {
        PyArray_DTypeMeta *common = PyArray_PromoteDTypeSequence(inputs, (PyArray_DTypeMeta **)given);
        if (common == NULL)
            return -1;
        one = gs_serving(common);
        Py_DECREF(common);
    }
    for (int i = 0; i < count; i++) {
        Py_INCREF(one);
        chosen[i] = one;
    }
    return 0;
}

int gs_add_promoter(PyObject *ufunc, int inputs, int outputs)
{
    PyObject *promoter = PyCapsule_New((void *)gs_promote, "numpy._ufunc_promoter", NULL);
    PyObject *types = PyTuple_New(inputs + outputs);
    int done = -1;
    if (promoter != NULL && types != NULL) {
        for (int i = 0; i < inputs + outputs; i++) {
            PyObject *any = i < inputs ? (PyObject *)&PyArrayDescr_Type : Py_None;
            Py_INCREF(any);
            PyTuple_SET_ITEM(types, i, any);
        }
        done = PyUFunc_AddPromoter(ufunc, types, promoter);
    }
    Py_XDECREF(promoter);
    Py_XDECREF(types);
    return done;
}
