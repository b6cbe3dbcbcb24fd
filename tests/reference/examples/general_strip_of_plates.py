"""Twenty plates in a strip: the torque on the crank from the equilibrium of all 21 links, in exact fractions.

The hinges lie at whole millimetres, so that no angle enters: two force equations and one of moments per link, for two
components per hinge and the torque.
"""
from fractions import Fraction

from printing import *

PLACES = {
    "O": (1060, 50), "F0": (1080, 50), "F1": (1335, -350), "F2": (-1643, -350),
    **{f"J{i}": at for i, at in enumerate([
        (1006, 207), (1165, 443), (887, 668), (479, 834), (192, 984), (-156, 1008), (-520, 871), (-964, 665), (-1031, 405),
        (-1006, 188), (-1239, -128), (-1009, -430), (-679, -739), (-562, -887), (-245, -943), (142, -931), (568, -869),
        (772, -741), (934, -449), (-94, 29), (258, 34), (-55, -10), (-44, -40), (-28, -13), (2, 33), (47, 32), (-227, -15)])},
}
GROUND, CRANK = -1, 20
HINGES = {"O": (GROUND, CRANK), "F0": (CRANK, 0), "F1": (GROUND, 19), "F2": (GROUND, 11),
          **{f"J{i}": (i, i + 1) for i in range(19)}, **{f"J{19 + i}": (1 + i, 11 + i) for i in range(8)}}


def equations(torque_on_p0):
    """Rows of 63 coefficients and a right side; forces of the first link on the second, moments about the origin."""
    rows = [[Fraction(0)] * 64 for _ in range(63)]
    for column, (name, links) in enumerate(HINGES.items()):
        x, y = PLACES[name]
        for link, sign in zip(links, (-1, 1)):
            if link != GROUND:
                rows[3 * link][2 * column] += sign
                rows[3 * link + 1][2 * column + 1] += sign
                rows[3 * link + 2][2 * column] -= sign * y
                rows[3 * link + 2][2 * column + 1] += sign * x
    rows[3 * CRANK + 2][62] = Fraction(1)
    rows[2][63] = -torque_on_p0
    return rows


def solved(rows):
    n = len(rows)
    for i in range(n):
        pivot = next(j for j in range(i, n) if rows[j][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [a / rows[i][i] for a in rows[i]]
        for j in range(n):
            if j != i and rows[j][i]:
                factor = rows[j][i]
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i])]
    return [row[n] for row in rows]


Mb = solved(equations(Fraction(-3)))[62]
key("Mb", mpf(Mb.numerator) / mpf(Mb.denominator), "N*m")
