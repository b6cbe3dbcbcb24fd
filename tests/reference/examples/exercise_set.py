"""The answer keys of `examples/exercise-set`: one column per quantity, behind the givens of every row.

    python3 exercise_set.py ../../../examples/exercise-set            # holds the tables against its own answers
    python3 exercise_set.py ../../../examples/exercise-set --write    # writes the columns and the expectations

Mechanisms are solved by planar.py; friction by the textbook's formulas below.
"""
import re
import sys
from pathlib import Path

from mpmath import atan, mp, mpf, pi, sin, sqrt, tan

import reader
from mechfile import File

mp.dps = 40
UNIT = {"": 1, "m": 1, "mm": mpf("1e-3"), "N": 1, "kN": 1000, "N*m": 1, "kg": 1, "kg*m^2": 1, "deg": pi / 180, "rad/s": 1,
        "rad/s^2": 1, "rpm": pi / 30, "m/s": 1, "m/s^2": 1, "W": 1, "N/m": 1}


def plane(G, al, f):
    """Horizontal force up a plane: G tan(al + phi); the normal force from the balance across the plane."""
    F = G * tan(al + atan(f))
    N = G * mp.cos(al) + F * sin(al)
    return {"F": F, "eta": tan(al) / tan(al + atan(f)), "N": N}


def groove(G, be, f):
    """A V-groove of half-angle be: f' = f / sin(be)."""
    return {"F": G * f / sin(be)}


def journal(G, r, f, n):
    """f G r run in; pi/2 of it for even pressure."""
    return {"M": f * G * r, "M_new": pi / 2 * f * G * r, "P": f * G * r * n}


def thrust(F, R, r, f):
    """Even pressure: 2/3 f F (R^3 - r^3)/(R^2 - r^2); worn: f F (R + r)/2."""
    return {"M_new": mpf(2) / 3 * f * F * (R ** 3 - r ** 3) / (R ** 2 - r ** 2), "M_worn": f * F * (R + r) / 2}


BY_FORMULA = {"17": plane, "18": groove, "19": journal, "20": thrust}
ITEM = re.compile(r"(\w+)(?: *= *.+?)? as ([^,\s]+)")


def table(text):
    head, rows, tail = re.search(r"variants \{\n( *[^\n]+)\n(.*?)\n(\})", text, re.S).groups()
    columns = [c.strip() for c in head.split(",")]
    return columns, [[c.strip() for c in r.split(",")] for r in rows.split("\n")]


def wanted(text):
    """Names and units of what is to be found."""
    found = []
    for line in text.split("\n"):
        if line.startswith("find "):
            depth, item, items = 0, "", []
            for c in line[5:]:
                depth += (c == "(") - (c == ")")
                if c == "," and depth == 0:
                    items.append(item)
                    item = ""
                else:
                    item += c
            for item in items + [item]:
                item = item.strip()
                if item == "reactions":
                    continue
                name = re.match(r"[\w']+", item)[0]
                unit = re.search(r" as (\S+)$", item)
                found.append((name, unit[1] if unit else ""))
    return found


def si(column, cell):
    unit = re.search(r"\[(.*)\]", column)
    return column.split()[0], mpf(cell) * UNIT[unit[1] if unit else ""]


def answers(path, columns, rows, names):
    formula = BY_FORMULA.get(path.name[:2])
    if formula:
        return [[formula(**dict(si(c, x) for c, x in zip(columns, row)))[n] for n, _ in names] for row in rows]
    f = File(path)
    out = []
    for row in f.variants:
        case = reader.Case(f, row)
        values = []
        for n, _ in names:
            e = f.find.get(n)
            values.append(case.value(e) if e is not None else case.s.balance[n])
        out.append(values)
    return out


def main(folder, write):
    good = True
    for path in sorted(Path(folder).glob("*.mech")):
        text = path.read_text(encoding="utf-8")
        columns, rows = table(text)
        givens = [i for i, c in enumerate(columns) if not c.split()[0].endswith("_key")]
        columns, rows = [columns[i] for i in givens], [[r[i] for i in givens] for r in rows]
        plain = re.sub(r"\n*expect \w+ = \w+_key[^\n]*", "", text)
        plain = re.sub(r"variants \{.*?\n\}", lambda _: block(columns, rows), plain, flags=re.S)
        names = wanted(plain)
        temporary = path if not write else path
        path.write_text(plain, encoding="utf-8") if write else None
        found = answers(temporary, columns, rows, names)
        keys = [f"{n}_key" + (f" [{u}]" if u else "") for n, u in names]
        cells = [[mp.nstr(v / UNIT[u], 17) for v, (_, u) in zip(row, names)] for row in found]
        if write:
            expects = "\n".join(f"expect {n} = {n}_key within 1e-9" for n, _ in names)
            full = block(columns + keys, [r + c for r, c in zip(rows, cells)])
            path.write_text(plain.replace(block(columns, rows), expects + "\n\n" + full), encoding="utf-8")
            continue
        stated, all_rows = table(text)
        for row, right in zip(all_rows, cells):
            given = row[len(columns):]
            for key, a, b in zip(keys, given, right):
                fine = abs(mpf(a) - mpf(b)) <= mpf("1e-12") * abs(mpf(b))
                good &= fine
                if not fine:
                    print(f"  WRONG {path.name} {key}: {a} in the table, {b}")
        print(f"{path}: {len(rows)} rows of {len(keys)}")
    return good


def block(columns, rows):
    lines = [", ".join(columns)] + [", ".join(r) for r in rows]
    return "variants {\n" + "\n".join("  " + line for line in lines) + "\n}"


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1], "--write" in sys.argv[2:]) else 1)
