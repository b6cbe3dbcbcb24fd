"""A free roller on a cam: the law and its derivatives by series, follower and roller one after the other by Newton, the torque by
the power of the cam's force."""
from mpmath import diff

from printing import *

h, b, d0 = mpf("0.02"), pi / 2, mpf("0.04")
m, mr, g, F, w = mpf("0.8"), mpf("0.15"), mpf("9.81"), mpf(60), rpm(300)


def rise(phi):
    return h * (phi / b - mp.sin(2 * pi * phi / b) / (2 * pi))


N, on_roller, pin, M, a = [], [], [], [], []
for degrees in (30, 60, 105, 150):
    phi = deg(degrees)
    if degrees < 90:
        s, s1, s2 = rise(phi), diff(rise, phi), diff(rise, phi, 2)
    elif degrees < 120:
        s, s1, s2 = h, mpf(0), mpf(0)
    else:
        fall = lambda x: h - rise(x - 2 * pi / 3)
        s, s1, s2 = fall(phi), diff(fall, phi), diff(fall, phi, 2)
    up = m * s2 * w**2 + m * g + F                    # of the pin on the rod, along the guide
    push = up + mr * (s2 * w**2 + g)                  # of the cam on the roller, along the guide
    side = -push * s1 / (d0 + s)                      # the tangent has s' along the guide for d0 + s across it
    # the cam turns counter-clockwise: what pushes the follower up presses it to the left
    N.append(sqrt(push**2 + side**2))
    on_roller.append((side, push))
    pin.append((-side, -up))
    M.append(push * s1)
    a.append((mpf(0), s2 * w**2))
keys("acceleration(rod.R)", a, "m/s^2")
keys("normal(K, roller)", N, "N")
keys("reaction(K, roller)", on_roller, "N")
keys("reaction(R, roller)", pin, "N")
keys("reaction(R, rod)", [(-x, -y) for x, y in pin], "N")
keys("M", M, "N*m")
