"""Crank-slider with friction in all pairs: equilibria of the three links with friction torques rho |R| against the turning and
a friction force f |N| against the sliding, solved as one nonlinear system in 40 digits."""
from mpmath import asin, cos, diff, findroot, hypot, mp, mpf, nstr, radians, sign, sin

mp.dps = 40
r, l, S = mpf("0.15"), mpf("0.45"), mpf("0.15")
m2, J2, m3, P = mpf(3), mpf("0.06"), mpf(5), mpf(1000)
rho, f, w = mpf("0.004"), mpf("0.1"), mpf(20)


def rod(phi):
    return -asin(r * sin(phi) / l)


def block(phi):
    return r * cos(phi) + l * cos(rod(phi))


def centre(phi):
    return r * cos(phi) + S * cos(rod(phi)), r * sin(phi) + S * sin(rod(phi))


def torque(deg):
    phi = radians(mpf(deg))
    psi, turn, bend = rod(phi), diff(rod, phi) * w, diff(rod, phi, 2) * w**2
    ax, ay = (diff(lambda t: centre(t)[k], phi, 2) * w**2 for k in (0, 1))
    v, a = diff(block, phi) * w, diff(block, phi, 2) * w**2
    B = r * cos(phi), r * sin(phi)
    C = block(phi), mpf(0)

    def equations(Ax, Ay, Bx, By, Cx, Cy, N, M):
        # A on the crank, B on the rod, C on the block, N on the block; friction torques on the second link of each
        tA = -rho * hypot(Ax, Ay) * sign(w)
        tB = -rho * hypot(Bx, By) * sign(turn - w)
        tC = -rho * hypot(Cx, Cy) * sign(-turn)
        gx, gy = centre(phi)
        return (
            Ax - Bx,
            Ay - By,
            M + tA - tB - (B[0] * By - B[1] * Bx),
            Bx - Cx - m2 * ax,
            By - Cy - m2 * ay,
            tB - tC + (B[0] - gx) * By - (B[1] - gy) * Bx - ((C[0] - gx) * Cy - (C[1] - gy) * Cx) - J2 * bend,
            Cx + P - f * abs(N) * sign(v) - m3 * a,
            Cy + N,
        )

    start = [P, P / 5, P, P / 5, P, P / 5, -P / 5, -P * r]
    found = None
    for guess in (start, [-x for x in start]):
        try:
            found = findroot(equations, guess)
            break
        except (ValueError, ZeroDivisionError):
            continue
    # the moment on the block is carried by the guide
    return found[7]


for pose in (1, 10, 28):
    deg = 22 + 5 * (pose - 1)
    print(f"expect M = {nstr(torque(deg), 17)} N*m within 1e-9 at pose {pose}")
