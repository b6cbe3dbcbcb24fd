"""The hard cases with 50 digits: what examples/hard asks, from closed forms of each problem on its decimal numbers.

    python3 tests/reference/hard/catalogue.py > tests/reference/hard/catalogue.csv

A row is: file, settings, pose (from 0), quantity, the value as a sum of two doubles, the magnitude the error is relative
to, and the power k of sigma in the bound c eps / sigma^k. All in SI and radians.
"""
from mpmath import mp, mpf, sqrt, sin, cos, tan, asin, acos, atan2, pi

mp.dps = 50
ROWS = []
deg = pi / 180


def row(file, settings, pose, name, value, scale, k):
    value = mpf(value)
    high = float(value)
    low = float(value - mpf(high))
    ROWS.append([file, settings, str(pose), name, repr(high), repr(low), repr(float(abs(scale))), str(k)])


def rates(f, t0, v, a=0):
    """First and second derivative in time of f(s) at s = t0, s' = v, s'' = a, by central differences with 200 digits."""
    with mp.workdps(200):
        h = mpf(10) ** -45
        up, mid, low = f(t0 + h), f(t0), f(t0 - h)
        one, two = (up - low) / (2 * h), (up - 2 * mid + low) / h**2
        return +(one * v), +(two * v * v + one * a)


def dead_centre():
    r, l = mpf("0.1"), mpf("0.35")

    def phi(x):
        return acos((x * x + r * r - l * l) / (2 * r * x))

    for d in ["10", "0.1", "1e-3", "1e-5", "1e-7", "1e-9", "4.5e-11"]:
        x, v = mpf("0.45") - mpf(d) / 1000, mpf("0.5")
        # near the dead centre the step of the difference must be small beside d
        p = phi(x)
        w, al = rates(phi, x, v)
        theta = asin(r * sin(p) / l)
        F = -w / v  # the moment of 1 N m and the force have no power together
        for name, value, scale, k in [("phi", p, 1, 1), ("w", w, w, 2), ("al", al, al, 3), ("F", F, F, 2),
                                      ("N", -F * tan(theta), F, 2)]:
            row("dead-centre", f"d={d}mm", 0, name, value, scale, k)


def toggle():
    for d in ["0.1", "1e-3", "1e-5", "1e-7", "1e-9", "1e-11"]:
        x = mpf(d)
        # virtual work: −1 N moves with the knee, F with the ram; s = 2 cos d, the knee at sin d
        F = -1 / (2 * tan(x))
        # of the rod: F along it, balanced at the ram by the guide
        N = F * tan(x)
        RA = sqrt((1 + N) ** 2 + F**2)
        row("toggle", f"d={d}rad", 0, "s", 2 * cos(x), 1, 1)
        row("toggle", f"d={d}rad", 0, "F", F, F, 2)
        row("toggle", f"d={d}rad", 0, "N", abs(N), F, 2)
        row("toggle", f"d={d}rad", 0, "RA", RA, F, 2)


def parallelogram():
    angles = [10 + 30 * k for k in range(24)] + [mpf("179.9999"), mpf("180.0001")]
    for pose, a in enumerate(angles):
        for name, value, scale, k in [("psi", a * deg, 1, 1), ("chi", 0, 1, 1), ("w", 10, 10, 2), ("al", 0, 100, 3),
                                      ("Mb", -1, 1, 2)]:
            row("parallelogram", "", pose, name, value, scale, k)


def equal_crank_slider():
    r, w, F = mpf("0.2"), 10, 100
    angles = ["80", "89.9", "89.99999", "90.00001", "100", "180", "269.999", "271", "440"]
    for pose, a in enumerate(angles):
        p = mpf(a) * deg
        for name, value, scale, k in [
            ("x", 2 * r * cos(p), r, 1), ("v", -2 * r * w * sin(p), r * w, 2),
            ("a", -2 * r * w * w * cos(p), r * w * w, 3), ("th", -p, 1, 1), ("Mb", -2 * r * F * sin(p), r * F, 2),
        ]:
            row("equal-crank-slider", "", pose, name, value, scale, k)


def trammel():
    for pose in range(24):
        t = 15 * pose * deg
        w = 2
        for name, value, scale, k in [
            ("xA", -cos(t), 1, 1), ("yB", sin(t), 1, 1), ("vA", w * sin(t), w, 2), ("aB", -w * w * sin(t), w * w, 3),
            ("px", mpf("-0.7") * cos(t), 1, 1), ("py", mpf("0.3") * sin(t), 1, 1), ("Mb", -sin(t), 1, 2),
        ]:
            row("trammel", "", pose, name, value, scale, k)


def trammel_slider():
    def y(x):
        return sqrt(1 - x * x)

    for d in ["0.5", "1e-3", "1e-6", "1e-9", "1e-12", "1e-14"]:
        x = mpf(d) - 1
        v, a = rates(y, x, 1)
        w = -1 / y(x)  # the end A moves along x: vA = ω × BA
        row("trammel-slider", f"d={d}m", 0, "yB", y(x), 1, 1)
        row("trammel-slider", f"d={d}m", 0, "vB", v, v, 2)
        row("trammel-slider", f"d={d}m", 0, "aB", a, a, 3)
        row("trammel-slider", f"d={d}m", 0, "w", abs(w), w, 2)


def near_grashof():
    for d in ["1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12"]:
        r, l, q, f = 1, 2, 3 + mpf(d), 4

        def psi(p):
            bx, by = r * cos(p) - f, r * sin(p)  # B from D
            s = sqrt(bx * bx + by * by)
            between = acos((q * q + s * s - l * l) / (2 * q * s))
            # C on the left of the way from B to D: clockwise of B seen from D
            return atan2(by, bx) - between

        before = None
        for pose in range(36):
            p = (5 + 10 * pose) * deg
            value = psi(p)
            if before is not None:
                while value - before > pi:
                    value -= 2 * pi
                while before - value > pi:
                    value += 2 * pi
            else:
                value = atan2(sin(value), cos(value))
            before = value
            w, al = rates(psi, p, 1)
            row("near-grashof", f"delta={d}m", pose, "psi", value, 1, 1)
            row("near-grashof", f"delta={d}m", pose, "w", w, 1, 2)
            row("near-grashof", f"delta={d}m", pose, "al", al, 1, 3)


def parallel_guides():
    for e, s in [("0.5", "1"), ("1e-2", "1e-2"), ("1e-4", "1e-4"), ("1e-6", "1e-6"), ("1e-9", "1e-9"), ("1e-11", "1e-11")]:
        x = -mpf(s) / 1000 / tan(mpf(e))
        v = -mpf("0.001") / tan(mpf(e))
        F = v / mpf("0.001")  # 1 N against x at v has the power of F on the wedge
        row("parallel-guides", f"e={e}rad h={s}mm", 0, "x", x, x, 1)
        row("parallel-guides", f"e={e}rad h={s}mm", 0, "v", v, v, 2)
        row("parallel-guides", f"e={e}rad h={s}mm", 0, "F", F, F, 2)


def crank_slider(r, l, phi, w):
    def x(p):
        return r * cos(p) + sqrt(l * l - (r * sin(p)) ** 2)

    def th(p):
        return asin(-r * sin(p) / l)

    return x(phi), *rates(x, phi, w), th(phi), *rates(th, phi, w)


def short_crank():
    r, l, w = mpf("1e-8"), mpf(1), mpf(100)
    for a in ["40", "0", "90", "215"]:
        p = mpf(a) * deg
        x, v, acc, th, om, al = crank_slider(r, l, p, w)
        for name, value, scale, k in [("v", v, r * w, 2), ("a", acc, r * w * w, 3), ("th", th, r / l, 1),
                                      ("Mb", acc * v / w, r * r * w * w, 3)]:
            row("short-crank", f"phi={a}deg", 0, name, value, scale, k)


def scales():
    p, w = 50 * deg, mpf(2)
    settings = [("1", "1", "1", "1")]
    for k in ["1e-9", "1e-3", "1e3", "1e9"]:
        settings += [(k, "1", "1", "1"), ("1", k, "1", "1"), ("1", "1", k, "1"), ("1", "1", "1", k), (k, k, k, k)]
    settings += [("1", "1e-9", "1e9", "1"), ("1", "1e9", "1e-9", "1e9"), ("1e-9", "1e9", "1", "1e-9")]
    for L_, m_, M_, F_ in settings:
        L, m, M, F = mpf(L_), mpf(m_), mpf(M_), mpf(F_)
        x, v, a, th, om, al = crank_slider(L, 3 * L, p, w)

        def sx(q):
            return L * cos(q) + L * cos(asin(-sin(q) / 3))

        def sy(q):
            return L * sin(q) + L * (-sin(q) / 3)

        vx, ax = rates(sx, p, w)
        vy, ay = rates(sy, p, w)
        J = m * L * L
        Mb = (m * (ax * vx + ay * vy) + J * al * om + M * a * v + F * v) / w
        # N on the piston: moments on the rod about B
        bx, by = L * cos(p), L * sin(p)
        rx, ry = 3 * L * cos(th), 3 * L * sin(th)
        s_x, s_y = rx / 3, ry / 3
        # forces of the rod at C on the rod: (fx, fy); piston: M a = -fx - F, 0 = N - fy
        fx = -(M * a + F)
        # rod about B: s × m a_S + J al = r × f
        fy = (s_x * m * ay - s_y * m * ax + J * al + ry * fx) / rx
        most = max(abs(M * a), F, abs(m * ax), abs(m * ay))
        name = f"L={L_}m m={m_}kg M={M_}kg F={F_}N"
        for what, value, scale, k in [("x", x, L, 1), ("a", a, L * w * w, 3), ("al", al, w * w, 3),
                                      ("Mb", Mb, most * L, 3), ("N", fy, most, 3)]:
            row("scales", name, 0, what, value, scale, k)


def locking():
    for f in ["0", "0.5", "0.9", "0.999", "0.999999", "0.999999999", "0.999999999999"]:
        S = 1 / (1 - mpf(f))
        row("locking", f"f={f}", 0, "F", S, S, 2)
        row("locking", f"f={f}", 0, "N", -S, S, 2)


def zero():
    for name in ["Mb", "RA", "RC"]:
        row("zero-loads", "", 0, name, 0, 1, 1)
    r, l = mpf("0.1"), mpf("0.35")
    for pose, a in enumerate([0, 30, 180]):
        p = a * deg
        x, v, acc, th, om, al = crank_slider(r, l, p, 10)
        # the rod pulls or presses with S along itself: S cos θ = 100 + T, N + S sin θ... with friction 0.2 |N| against v
        f = mpf("0.2")
        sense = 0 if a in (0, 180) else (1 if v > 0 else -1)
        # piston: Sx - 100 - sense f |N| = 0; Sy - 40 + N = 0, Sy = Sx tan θ
        N = 40
        for _ in range(200):
            Sx = 100 + sense * f * abs(N)
            N = 40 - Sx * tan(th)
        Sx = 100 + sense * f * abs(N)
        Mb = r * cos(p) * Sx * tan(th) - r * sin(p) * Sx
        row("zero-velocity", "", pose, "Mb", Mb, 10, 2)
        row("zero-velocity", "", pose, "N", N, 100, 2)
        row("zero-velocity", "", pose, "T", -sense * f * abs(N), 100, 2)


def passive():
    def psi(p):
        ex, ey = mpf("0.03") * cos(p) - mpf("0.2"), mpf("0.03") * sin(p)  # E from P
        s = sqrt(ex * ex + ey * ey)
        q, d = mpf("0.15"), mpf("0.07")
        return atan2(ey, ex), acos((q * q + s * s - d * d) / (2 * q * s))

    p = 70 * deg
    base, between = psi(p)
    for sign in (1, -1):
        angle = base + sign * between
        if sin(angle) > 0:  # left of the way from O to P: above
            def f(t, sign=sign):
                b, c = psi(t)
                return b + sign * c
            w, al = rates(f, p, 10)
            angle = atan2(sin(angle), cos(angle))
            row("passive", "", 0, "psi", angle, 1, 1)
            row("passive", "", 0, "w", w, w, 2)
            row("passive", "", 0, "al", al, al, 3)
            row("passive", "", 0, "Mb", -5 * w / 10, 5, 2)


def chain():
    """1000 dyads, each joined to the rocker before: tests/mechanics/hard/long.rs writes the same lengths."""
    w = mpf(2)
    r0 = mpf("0.05")
    p0 = 60 * deg
    T = [(r0 * cos(p0), r0 * sin(p0)), (-r0 * sin(p0) * w, r0 * cos(p0) * w)]
    for i in range(1, 1001):
        ox = mpf(100 * i) / 1000
        k = (100 + mpf((7 * i) % 11 - 5) / 10) / 1000
        h = (50 + mpf((5 * i) % 7 - 3) / 10) / 1000
        (bx, by), (vx, vy) = T
        dx, dy = ox - bx, -by
        s2 = dx * dx + dy * dy
        along = (s2 + k * k - h * h) / (2 * s2)
        across = sqrt(k * k / s2 - along * along)
        # left of the way from T to O
        cx, cy = bx + along * dx - across * dy, by + along * dy + across * dx
        (ax, ay), (gx, gy) = (cx - bx, cy - by), (cx - ox, cy)
        # v_C = ω (−gy, gx); (v_C − v_B) · a = 0
        om = (vx * ax + vy * ay) / (gx * -1 * 0 + (-gy * ax + gx * ay))
        T = [(cx, cy), (-gy * om, gx * om)]
        if i in (1, 10, 100, 1000):
            row("chain", str(i), 0, "angle", atan2(gy, gx), 1, 1)
            row("chain", str(i), 0, "omega", om, w, 2)


for case in [dead_centre, toggle, parallelogram, equal_crank_slider, trammel, trammel_slider, near_grashof,
             parallel_guides, short_crank, scales, locking, zero, passive, chain]:
    case()

print("file,settings,pose,quantity,high,low,scale,power")
for r in ROWS:
    print(",".join(r))
