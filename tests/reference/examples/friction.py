"""Friction in the pairs of a solved pose: Newton's method on the whole Newton-Euler system at once.

Unknowns are all reaction components and balances. The friction of each pair, minus the sense of its relative motion
times rho |R| (a couple, revolute) or f |N| (a force along the guide), is a function of the unknowns of that pair.
"""
from taylor import *


def with_friction(s, laws, start=None):
    """`laws`: {pair: rho or f}. Returns the balances, and the total force on each link of each pair: {(pair, link)}."""
    m = s.m
    rows = {k.name: 3 * i for i, k in enumerate(m.moving())}
    n = 3 * len(rows)
    balances = dict(m.balances) or {f"effort({w})": ("torque", w) for w, *_ in m.drives}

    def vector(wrenches):
        v = mp.matrix(n, 1)
        for link, force, place, couple in wrenches:
            if link in rows:
                i = rows[link]
                v[i] += force[0]
                v[i + 1] += force[1]
                v[i + 2] += cross(place, force) + couple
        return v

    columns, rubs, forces = [], [], []
    for p in m.pairs:
        first = len(columns)
        for on, other, force, place, couple in p.wrenches(s.f):
            columns.append(vector([(on, force, place, couple), (other, times(-1, force), place, -couple)]))
            forces.append((p, on, other, force, couple))
        factor = mpf(laws.get(p.name, 0))
        if not factor:
            continue
        if p.kind == "revolute":
            speed = s.omega(p.b) - s.omega(p.a)
            unit = vector([(p.b, (0, 0), (0, 0), mpf(1)), (p.a, (0, 0), (0, 0), mpf(-1))])
            rubs.append((p, -mp.sign(speed) * factor, [first, first + 1], unit, None))
        else:
            _, u = p.line(s.f)
            place = s.position(f"{p.a}.{p.pa}")
            unit = vector([(p.a, u, place, 0), (p.b, times(-1, u), place, 0)])
            normal = [j for j in range(first, len(columns)) if forces[j][4] == 0]
            rubs.append((p, -mp.sign(s.relative_velocity(p.name)) * factor, normal, unit, u))
    for b in balances.values():
        columns.append(vector(s._unit(b)))
    a = mp.matrix(n, n)
    for j, c in enumerate(columns):
        for i in range(n):
            a[i, j] = c[i]
    b = vector(s.applied())
    x = mp.lu_solve(a, -b) if start is None else mp.matrix(start)
    for _ in range(60):
        r, jac = a * x + b, a.copy()
        for _, factor, parts, unit, _ in rubs:
            size = mp.sqrt(sum(x[j] ** 2 for j in parts))
            r += unit * (factor * size)
            for j in parts:
                for i in range(n):
                    jac[i, j] += unit[i] * factor * x[j] / size
        if max(abs(e) for e in r) < mpf(10) ** -30 * (1 + max(abs(e) for e in b)):
            break
        x -= mp.lu_solve(jac, r)
    else:
        raise ValueError("friction: no convergence")
    total = {}
    for value, (p, on, other, force, couple) in zip(x, forces):
        for link, sign in ((on, 1), (other, -1)):
            f0 = total.get((p.name, link), (mpf(0), mpf(0)))
            total[(p.name, link)] = add(f0, times(sign * value, force))
    for p, factor, parts, _, u in rubs:
        if u is not None:
            along = times(factor * mp.sqrt(sum(x[j] ** 2 for j in parts)), u)
            total[(p.name, p.a)] = add(total[(p.name, p.a)], along)
            total[(p.name, p.b)] = add(total[(p.name, p.b)], times(-1, along))
    return dict(zip(balances, list(x)[len(forces):])), total
