"""Translating followers: tan(pressure angle) = (s' - e)/(d0 + s), flat face: contact s' beside the axis; the greatest
pressure angle and the smallest base circle by root finding on those formulas in 30 digits."""
from mpmath import mp, mpf, sin, cos, pi, radians, degrees, atan, tan, sqrt, diff, findroot, nstr

mp.dps = 30
H, B = mpf("0.02"), radians(mpf(90))
R0, E = mpf("0.05"), mpf("0.01")


def s(phi):
    x = phi / B
    return H * (x - sin(2 * pi * x) / (2 * pi))


def tan_rise(phi):
    return (diff(s, phi) - E) / (sqrt(R0**2 - E**2) + s(phi))


top = findroot(lambda p: diff(tan_rise, p), radians(mpf(40)))
print("rise", nstr(degrees(atan(tan_rise(top))), 20), "at", nstr(degrees(top), 20))
# the fall is the rise run back: tan = (-s' - e)/(d0 + s)
fall = lambda p: (diff(s, p) + E) / (sqrt(R0**2 - E**2) + s(p))
low = findroot(lambda p: diff(fall, p), radians(mpf(40)))
print("fall", nstr(degrees(atan(fall(low))), 20), "at", nstr(210 - degrees(low), 20))
for allowed in (30,):
    t = tan(radians(mpf(allowed)))
    need = lambda p: (diff(s, p) + E) / t - s(p)
    p = findroot(lambda p: diff(need, p), radians(mpf(40)))
    print("smallest base radius for", allowed, nstr(sqrt(need(p) ** 2 + E**2) * 1000, 20), "mm")
# flat face on the same law: contact s' beside the axis, radius r0 + s + s''
print("flat, 30 deg: s'", nstr(diff(s, radians(mpf(30))) * 1000, 20), "rho", nstr((R0 + s(radians(mpf(30))) + diff(s, radians(mpf(30)), 2)) * 1000, 20))
r = findroot(lambda p: diff(s, p) + diff(s, p, 3), radians(mpf(68)))
print("flat, least radius", nstr((R0 + s(r) + diff(s, r, 2)) * 1000, 20), "at", nstr(degrees(r), 20))
