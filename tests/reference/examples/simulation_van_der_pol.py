"""Van der Pol's oscillator: Newton's method on the speed with which it passes its middle, differences of one swing each."""
from dynamics import *


def f(_, y):
    return [y[1], (1.0 - y[0] ** 2) * y[1] - y[0]]


def half(v):
    """From the middle to the next time: the speed there, the duration, the place where it turns."""
    events = [("middle", lambda _, y: y[0]), ("turn", lambda _, y: y[1])]
    t, y, found = integrate(f, [0.0, v], 0.0, 20.0, 0.01, events=events, stop="middle")
    return y[1], t, found["turn"][0][1][0]


def swing(v):
    there, t1, _ = half(v)
    back, t2, most = half(there)
    return back, t1 + t2, most


v = -2.1727
for _ in range(6):
    end, period, most = swing(v)
    slope = (swing(v + 1e-6)[0] - end) / 1e-6
    v += (end - v) / (1.0 - slope)
end, period, most = swing(v)
key("period()", period, "s", "1e-10")
key("max(displacement(G))", most, "m", "1e-10")
key("relative_velocity(G)", v, "m/s", "1e-10", " at event begin")
