"""Print answer keys as the `expect` lines of the language, every digit of a double."""
from taylor import *

UNITS = {"m": 1, "mm": mpf("1e-3"), "m/s": 1, "m/s^2": 1, "rad": 1, "deg": mp.pi / 180, "rad/s": 1, "rad/s^2": 1, "N": 1, "kN": 1000,
         "N*m": 1, "kN*m": 1000, "kg": 1, "kg*m^2": 1, "J": 1, "W": 1, "MPa": 1000000, "": 1}


def digits(x):
    """Shortest text that reads back to the same double."""
    x = mpf(x)
    if abs(x) < mpf(10) ** -25:
        return "0"
    text = repr(float(x))
    if text.endswith(".0"):
        text = text[:-2]
    return text.replace("e-0", "e-").replace("e+", "e")


def written(value, unit):
    scale = UNITS[unit]
    space = " " if unit else ""
    if isinstance(value, (tuple, list)):
        return "(" + ", ".join(written(v, unit) for v in value) + ")"
    v = mpf(value) / scale
    if unit in ("deg", "rad"):
        turn = 2 * pi / scale
        v -= turn * mp.nint(v / turn)
    return digits(v) + space + unit


def size(value):
    return mag(value) if isinstance(value, (tuple, list)) else abs(mpf(value))


def key(text, value, unit="", tail=""):
    """Print one `expect`: relative within 1e-9, an expected zero within an amount."""
    if size(value) < mpf(10) ** -25:
        zero = f"(0 {unit}, 0 {unit})" if isinstance(value, (tuple, list)) else f"0 {unit}"
        print(f"expect {text} = {zero} within 1e-9 {unit}{tail}")
    else:
        print(f"expect {text} = {written(value, unit)} within 1e-9{tail}")


def keys(text, values, unit, places=9):
    """Print a list of expected values, one per pose, within 1e-9 of the greatest, or to more places."""
    scale = max(size(v) for v in values) / UNITS[unit]
    cells = [written(v, unit) for v in values]
    lines = [", ".join(cells[i:i + 3]) for i in range(0, len(cells), 3)]
    tol = f"1e{int(mp.floor(mp.log10(scale))) - places} {unit}"
    print(f"expect {text} = " + ",\n            ".join(lines) + f" within {tol}")
