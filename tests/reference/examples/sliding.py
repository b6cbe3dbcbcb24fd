"""Motions with friction in several pairs: from one change of the senses of sliding to the next.

`motion(senses, t, y)` returns the second derivatives of the coordinates, and for every pair how it accelerates, what friction
it needs and the most that friction at rest gives; a sense is 1, -1, or 0 for a pair that is held. `speeds(y)` are the sliding
speeds."""
from itertools import product

from dynamics import integrate


def choose(motion, t, y, open_pairs, senses):
    """Senses of the open pairs that fit: as many as can be held."""
    ways = sorted(product((0, 1, -1), repeat=len(open_pairs)), key=lambda way: sum(map(abs, way)))
    for way in ways:
        trial = list(senses)
        for pair, sense in zip(open_pairs, way):
            trial[pair] = sense
        _, each = motion(trial, t, y)
        fits = [abs(need) <= most if s == 0 else p not in open_pairs or a * s > 0.0
                for p, (s, (a, need, most)) in enumerate(zip(trial, each))]
        if all(fits):
            return trial
    raise ValueError("no way")


def follow(motion, speeds, y, end, h=0.002, at=()):
    """Returns the state at the end, those at the instants `at`, and all changes: (t, pair, senses before and after)."""
    t, n = 0.0, len(y) // 2
    zero = [p for p, v in enumerate(speeds(y)) if v == 0.0]
    senses = [(v > 0.0) - (v < 0.0) for v in speeds(y)]
    senses = choose(motion, t, y, zero, senses)
    changes, there = [], {}
    while t < end:
        def f(s, u):
            return [*u[n:], *motion(senses, s, u)[0]]

        def left(pair):
            def g(s, u):
                if senses[pair]:
                    return senses[pair] * speeds(u)[pair]
                _, need, most = motion(senses, s, u)[1][pair]
                return 1.0 - abs(need) / most
            return g

        stop = min([s for s in at if s > t] + [end])
        # one that has just begun to slide does not turn where it begins
        late = t + 1e-5
        _, begun, _ = integrate(f, y, t, late, 1e-5)
        events = [(pair, left(pair)) for pair in range(len(senses))]
        _, last, found = integrate(f, begun, late, stop, h, events=events)
        found = sorted((zeros[0][0], pair, zeros[0][1]) for pair, zeros in found.items() if zeros)
        if not found:
            t, y = stop, last
            there[t] = y
            continue
        t, pair, y = found[0]
        before = list(senses)
        if senses[pair] == 0:
            _, need, _ = motion(senses, t, y)[1][pair]
            senses = list(senses)
            senses[pair] = -1 if need > 0.0 else 1
            others = [p for p in range(len(senses)) if senses[p] == 0 and p != pair]
        else:
            others = [pair, *(p for p in range(len(senses)) if senses[p] == 0)]
        senses = choose(motion, t, y, others, senses)
        if not any(senses):
            y = [*y[:n], *[0.0] * n]
        changes += [(t, p, b, a) for p, (b, a) in enumerate(zip(before, senses)) if a != b]
    return y, there, changes
