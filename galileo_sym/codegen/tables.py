"""The tables in both languages."""

from galileo_sym.primitives.fit import PER_BINADE
from galileo_sym.primitives.tables import (
    ANGLE_STEPS,
    DEGREE,
    TABLES,
    angle_rows,
    constants,
    pair_rows,
    pieces,
    series_rows,
)

_SERIES_TERMS = 9
_PAIR_TERMS = {"atanh": 21, "growth": 10, "decay_series": 22}
_DECAY_PAIRS = 11  # terms after these are below 2**-50 of the sum


def _numbers(values, indent, per_line):
    chunks = [values[i : i + per_line] for i in range(0, len(values), per_line)]
    return ",\n".join(indent + ", ".join(repr(v) for v in chunk) for chunk in chunks)


def _parts(column, part):
    return [row[column][part] for row in angle_rows()]


def numpy_tables():
    """Return the source of the NumPy tables: coefficients by column, then by piece."""
    out = ['"""Tables of the primitives, of sine and cosine, and constants."""\n\nimport numpy as np\n\n']
    out.append(f"PER_BINADE = {PER_BINADE}\nANGLE_STEPS = {ANGLE_STEPS}\n")
    values = constants()
    out += [f"{name.upper()} = {parts!r}\n" for name, parts in values.items()]
    for name, key in (("SINC", "sinc"), ("COSM1", "cosm1")):
        out.append(f"{name} = {series_rows(key, _SERIES_TERMS)!r}\n")
    for name, count in _PAIR_TERMS.items():
        out.append(f"{name.upper()} = {pair_rows(name, count)!r}\n")
    out.append(f"DECAY_PAIRS = {_DECAY_PAIRS}\n")
    for name, column in (("SINE", 0), ("COSINE", 1)):
        rows = "".join(f"        [\n{_numbers(_parts(column, part), ' ' * 12, 4)},\n        ],\n" for part in range(3))
        out.append(f"{name} = np.array(\n    [\n{rows}    ]\n)\n")
    out.append("TABLES = {\n")
    for name, table in TABLES.items():
        fitted = pieces(name)
        far = table.far
        out.append(f'    "{name}": {{\n        "doc": {table.doc!r},\n        "x_max": {table.x_max!r},\n')
        if far:
            out.append(f'        "power": {far.power}, "shift": {far.shift}, ')
            out.append(f'"correction": {far.correction!r}, "order": {far.order},\n')
        out.append(
            f'        "centres": np.array(\n            [\n{_numbers([p.centre for p in fitted], " " * 16, 6)},\n'
        )
        out.append('            ]\n        ),\n        "coefficients": np.array(\n            [\n')
        for column in range(DEGREE + 3):
            row = [p.coefficients[column] for p in fitted]
            out.append(f"                [\n{_numbers(row, ' ' * 20, 4)},\n                ],\n")
        out.append("            ]\n        ),\n    },\n")
    out.append("}\n")
    return "".join(out)


def c_tables():
    """Return the source of the C tables: one row a piece, its centre first."""
    values = constants()
    out = ['#include "galileo_support.h"\n\n']

    def pairs(rows):
        return ",\n".join("    {" + ", ".join(map(repr, row)) + "}" for row in rows)

    for name, key in (("gs_sinc", "sinc"), ("gs_cosm1", "cosm1")):
        out.append(f"const double {name}[GS_SERIES_TERMS][3] = {{\n{pairs(series_rows(key, _SERIES_TERMS))}\n}};\n\n")
    for name, count in _PAIR_TERMS.items():
        out.append(f"const double gs_{name}[{count}][2] = {{\n{pairs(pair_rows(name, count))}\n}};\n\n")
    for name, column in (("gs_sine_table", 0), ("gs_cosine_table", 1)):
        rows = pairs(row[column] for row in angle_rows())
        out.append(f"const double {name}[{len(angle_rows())}][3] = {{\n{rows}\n}};\n\n")
    for name, parts in values.items():
        out.append(f"const double gs_{name}[{len(parts)}] = {{{', '.join(map(repr, parts))}}};\n\n")
    for name, table in TABLES.items():
        rows = ",\n".join(
            "    {\n" + _numbers([p.centre, *p.coefficients], " " * 8, 4) + "\n    }" for p in pieces(name)
        )
        out.append(f"static const double {name}_rows[{table.count}][GS_ROW] = {{\n{rows}\n}};\n\n")
        far = table.far
        tail = f"{far.power}, {far.shift}, {far.correction!r}, {far.order}" if far else "0, 0, 0.0, 1"
        out.append(f"/* {table.doc} */\n")
        out.append(f"const gs_table gs_{name}_table = {{{name}_rows, {table.count}, {table.x_max!r}, {tail}}};\n\n")
    return "".join(out).rstrip("\n") + "\n"


def c_sizes():
    """Return the macros that give the tables' shapes."""
    return (
        f"#define GS_PER_BINADE {PER_BINADE}\n#define GS_ANGLE_STEPS {ANGLE_STEPS}\n#define GS_DEGREE {DEGREE}\n"
        f"#define GS_ROW {DEGREE + 4}\n#define GS_SERIES_TERMS {_SERIES_TERMS}\n"
        + "".join(f"#define GS_{name.upper()}_TERMS {count}\n" for name, count in _PAIR_TERMS.items())
        + f"#define GS_DECAY_PAIRS {_DECAY_PAIRS}\n"
    )
