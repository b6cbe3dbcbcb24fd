"""Gear pairs by other ways than the program's: the working pressure angle by bisection, the contact ratio by cutting
the line of contact with the tip circles, the overlap of pinion and ring by following the pinion's tip corners through
the spaces of the ring."""
from mpmath import mp, mpf, tan, cos, sin, pi, radians, sqrt, findroot, nstr

mp.dps = 40


def inv(a):
    return tan(a) - a


def pair(z1, z2, m, alpha, ha, c, x1, x2, internal=False):
    s = -1 if internal else 1
    alpha = radians(mpf(alpha))
    target = inv(alpha) + 2 * (x2 + s * x1) * tan(alpha) / (z2 + s * z1)
    aw = findroot(lambda t: inv(t) - target, (mpf("0.01"), mpf("1.2")), solver="anderson", tol=1e-60)
    rb1, rb2 = m * z1 * cos(alpha) / 2, m * z2 * cos(alpha) / 2
    # the line of contact touches both base circles: centre distance from their radii
    a = (rb2 + s * rb1) / cos(aw)
    y = (a - m * (z2 + s * z1) / 2) / m
    k = 0 if internal else x1 + x2 - y
    ra1 = m * z1 / 2 + m * (ha + x1 - k)
    ra2 = m * z2 / 2 + s * m * (ha + s * x2 - k)
    # points of the line of contact: pitch point P in the origin, t along the line; centre 1 at (0, -rw1)
    rw1 = rb1 / cos(aw)
    rw2 = rb2 / cos(aw)
    def reach(centre, radius, sign):
        # |P + t d - centre| = radius with d = (cos aw, sin aw)
        d = (cos(aw), sin(aw))
        b = -(d[1] * centre)
        return -b + sign * sqrt(b * b - centre * centre + radius * radius)
    t1 = reach(-rw1, ra1, 1)
    t2 = reach(rw2, ra2, -1) if not internal else reach(-rw2, ra2, 1)
    length = t1 - t2
    return dict(alpha_w=aw * 180 / pi, a=a * 1000, da1=2000 * ra1, da2=2000 * ra2, g=length * 1000,
                ratio=length / (pi * m * cos(alpha)))


def show(name, *args, **kw):
    got = pair(*args, **kw)
    print(name, {k: nstr(v, 20) for k, v in got.items()})


m2 = mpf("0.002")
show("18/42 m 16", 18, 42, mpf("0.016"), 20, 1, mpf("0.25"), 0, 0)
show("17/40 x 0.5 0.3", 17, 40, m2, 20, 1, mpf("0.25"), mpf("0.5"), mpf("0.3"))
show("20/60 ring", 20, 60, m2, 20, 1, mpf("0.25"), 0, 0, internal=True)
show("20/60 ring x 0.2 0.6", 20, 60, m2, 20, 1, mpf("0.25"), mpf("0.2"), mpf("0.6"), internal=True)


def overlaps(z1, z2, alpha=20.0, ha=1.0, steps=20000):
    """Whether a corner of a pinion's tooth enters the teeth of the ring: both turn together, the corner is looked at in
    the frame of the ring, where a tooth covers the angles between its two involutes."""
    import math as M
    al = M.radians(alpha)
    r1, r2 = z1 / 2, z2 / 2
    rb2 = r2 * M.cos(al)
    ra1, ra2 = r1 + ha, r2 - ha
    a = r2 - r1
    i = lambda t: M.tan(t) - t
    # half angle of the pinion's tooth at its tip, of a space of the ring at radius r
    aa1 = M.acos(r1 * M.cos(al) / ra1)
    half_tip = M.pi / (2 * z1) + i(al) - i(aa1)
    def half_space(r):
        return M.pi / (2 * z2) + i(al) - i(M.acos(rb2 / r))
    worst = 1e9
    for n in range(steps):
        t = -M.pi + 2 * M.pi * n / steps        # the pinion's tooth against the line of centres
        for side in (1, -1):
            corner = t + side * half_tip
            x, y = a + ra1 * M.cos(corner), ra1 * M.sin(corner)
            r, phi = M.hypot(x, y), M.atan2(y, x)
            if r <= ra2:
                continue
            # the space of the ring that meets this tooth stands at t z1 / z2
            worst = min(worst, half_space(r) - abs(phi - t * z1 / z2))
    return worst


for z1, z2 in [(z, z + d) for z in (40, 60, 90) for d in (6, 7, 8, 9)]:
    print("ring", z1, z2, "least gap, rad:", overlaps(z1, z2))
