"""Radii of curvature of the shaper's two cams, in 50 digits: derivatives of the pitch curve by mpmath's own differences.

The exercises' values at 47 deg and 114.75 deg came from differences in double precision and differ from these by
parts in 1e8; by symmetry the follower that turns against the cam has the same radius at 83 deg and 35.25 deg.
"""
from mpmath import mp, mpf, cos, sin, acos, pi, radians, diff, findroot, expj, im, conj

mp.dps = 50


def cam(turn, lift, L, a, r0, sigma):
    turn, lift = radians(mpf(turn)), radians(mpf(lift))
    psi0 = acos((a * a + L * L - r0 * r0) / (2 * a * L))
    dwell = radians(mpf(10))

    def s(phi, part):
        if phi < turn:
            x = phi / turn
            return lift * (2 * x * x if part == 0 else 1 - 2 * (1 - x) ** 2)
        x = (phi - turn - dwell) / turn
        return lift * (1 - (2 * x * x if part == 0 else 1 - 2 * (1 - x) ** 2))

    def curvature_radius(phi, part):
        def P(t):
            psi = psi0 + s(t, part)
            return expj(t) * (a - L * cos(psi) + 1j * sigma * L * sin(psi))
        first = diff(P, phi)
        second = diff(P, phi, 2)
        return abs(first) ** 3 / im(conj(first) * second)

    return curvature_radius


one = cam(60, 18, mpf("0.13"), mpf("0.14"), mpf("0.05"), 1)
print("cam 1, with, 47 deg:", mp.nstr(one(radians(mpf(47)), 1), 20))
other = cam(60, 18, mpf("0.13"), mpf("0.14"), mpf("0.05"), -1)
print("cam 1, against, 83 deg:", mp.nstr(other(radians(mpf(83)), 0), 20))
t = findroot(lambda t: diff(lambda u: one(u, 1), t), radians(mpf(47)))
print("cam 1, with, least near 47 deg:", mp.nstr(one(t, 1), 20), "at", mp.nstr(t * 180 / pi, 20), "deg")
two = cam(70, 15, mpf("0.12"), mpf("0.136"), mpf("0.05"), 1)
print("cam 2, with, 114.75 deg:", mp.nstr(two(radians(mpf("114.75")), 0), 20))
print("cam 2, with, 115 deg, before the middle of the fall:", mp.nstr(two(radians(mpf(115)), 0), 20))
print("cam 2, with, 35 deg, behind the middle of the rise:", mp.nstr(two(radians(mpf(35)), 1), 20))
against = cam(70, 15, mpf("0.12"), mpf("0.136"), mpf("0.05"), -1)
print("cam 2, against, 35 deg, behind the middle of the rise:", mp.nstr(against(radians(mpf(35)), 1), 20))
