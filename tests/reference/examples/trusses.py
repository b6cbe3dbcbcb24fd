"""A truss by the method of joints: the equilibrium of all its pins as one linear system in the bars and the supports."""
from printing import *


def solved(pins, bars, supports, loads):
    """Forces: of the bars, positive where they pull, then of the supports on the pins. A bar is a pair of pins, a support a pin and a direction."""
    names = list(pins)
    columns = []
    for one, two in bars:
        (x1, y1), (x2, y2) = pins[one], pins[two]
        length = mp.hypot(x2 - x1, y2 - y1)
        u = ((x2 - x1) / length, (y2 - y1) / length)
        columns.append({one: u, two: (-u[0], -u[1])})
    columns += [{pin: direction} for pin, direction in supports]
    a = [[mpf(column.get(pin, (0, 0))[k]) for column in columns] for pin in names for k in (0, 1)]
    b = [-mpf(loads.get(pin, (0, 0))[k]) for pin in names for k in (0, 1)]
    found = mp.lu_solve(mp.matrix(a), mp.matrix(b))
    return [digits(mpf(mp.nstr(x, 14))) for x in found]


X, Y = (1, 0), (0, 1)
