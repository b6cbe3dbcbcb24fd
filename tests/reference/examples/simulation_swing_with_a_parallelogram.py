"""A parallelogram on a swing: places of all mass centres in the angles of bar and crank, the coupler parallel to the bar."""
from dynamics import *

g = 9.81


def scene(_, q):
    bar, crank = q
    b, c = (cos(bar), sin(bar)), (cos(crank), sin(crank))
    places = [(3.0, 0.5, 0.0), (1.0, 0.6, 0.15), (1.0, 1.0, 0.15), (2.0, 0.8, 0.3)]
    terms = [(0.25 + 0.03, bar, 0.0), (2 * 0.0075, crank, 0.0)]
    for m, along_bar, along_crank in places:
        terms.append((m, b[0] * along_bar + c[0] * along_crank, 0.0))
        terms.append((m, b[1] * along_bar + c[1] * along_crank, -m * g))
    return terms


f = rates(scene)
start = [math.radians(-60), math.radians(40), 0.0, 15.0]
for end, when in ((1.0, "time = 1 s"), (2.0, "event end")):
    t, y, _ = integrate(f, start, 0.0, end, 0.005)
    for text, x, unit in zip(("angle(bar)", "angle(right)", "omega(bar)", "omega(right)"), y, ("rad", "rad", "rad/s", "rad/s")):
        key(text, x, unit, "1e-9", f" at {when}")
t, y, found = integrate(f, start, 0.0, 2.0, 0.005, events=[("in_line", lambda _, y: math.sin(y[1] - y[0]))])
falling = [e for e in found["in_line"] if math.cos(e[1][1] - e[1][0]) < 0.0]
key("time(in_line)", falling[0][0], "s", "1e-9")
