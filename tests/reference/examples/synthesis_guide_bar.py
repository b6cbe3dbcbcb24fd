"""Synthesis of a guide-bar mechanism: the greatest speeds of the ram both ways, from its coordinate as a closed formula of the
crank angle, differentiated by mpmath."""
from mpmath import mp, mpf, acos, atan2, cos, diff, findroot, linspace, nstr, pi, sin, sqrt

mp.dps = 30
STROKE, K, CENTRES = mpf(400), mpf("1.5"), mpf(300)
psi = pi * (K - 1) / (K + 1)
BAR = STROKE / (2 * sin(psi / 2))
CRANK = CENTRES * sin(psi / 2)
GUIDE = BAR * (1 + cos(psi / 2)) / 2
ROD = mpf("0.3") * BAR


def ram(phi):
    beta = atan2(CENTRES + CRANK * sin(phi), CRANK * cos(phi))
    x, y = BAR * cos(beta), BAR * sin(beta)
    return x - sqrt(ROD**2 - (y - GUIDE) ** 2)


def speed(phi):
    """m/s: the crank goes clockwise at 60 rpm."""
    return diff(ram, phi) * -2 * pi / 1000


rough = [(speed(2 * pi * i / 72), 2 * pi * i / 72) for i in range(72)]
for name, (_, near) in (("max", max(rough)), ("min", min(rough))):
    phi = findroot(lambda t: diff(ram, t, 2), near)
    print(f"expect {name}(relative_velocity(G)) = {nstr(speed(phi), 20)} m/s within 1e-12")
