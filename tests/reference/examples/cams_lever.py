"""Cam and lever with inertia: the cam torque from the power balance, M omega = -(Q - J_P alpha) omega_lever, with the law
differentiated by mpmath; nothing of the geometry of the contact is used.

The pressure angle from the path of the roller's centre in the cam: the common normal is perpendicular to it, the centre
moves perpendicularly to the lever. The force in the contact from the moments about the lever's pivot."""
from mpmath import mp, mpf, acos, atan2, cos, sin, pi, radians, degrees, diff, nstr

mp.dps = 30
h, rise = radians(mpf(18)), radians(mpf(60))
dwell, fall = radians(mpf(10)), radians(mpf(70))
omega = mpf(300) * 2 * pi / 60
JP = mpf("0.01") + 2 * mpf("0.065") ** 2
Q = mpf(60)


def lift(phi):
    if phi < rise:
        x = phi / rise
        return h * (x - sin(2 * pi * x) / (2 * pi))
    if phi < rise + dwell:
        return h
    x = (phi - rise - dwell) / fall
    return h * (1 - (10 * x**3 - 15 * x**4 + 6 * x**5))


ARM, PIVOT, START = mpf(130), mpf(140), mpf(50)
start = acos((ARM**2 + PIVOT**2 - START**2) / (2 * ARM * PIVOT))


def centre(phi):
    """Roller's centre: the lever turns clockwise, away from the cam, as it rises; the pivot lies on the x axis. In the
    cam, which has turned clockwise by phi."""
    # seen from the pivot the arm points back to the cam's centre; clockwise is up there
    psi = pi - start - lift(phi)
    x, y = PIVOT + ARM * cos(psi), ARM * sin(psi)
    return x * cos(phi) - y * sin(phi), x * sin(phi) + y * cos(phi), psi


def pressure_angle(phi):
    dx, dy = diff(lambda t: centre(t)[0], phi), diff(lambda t: centre(t)[1], phi)
    psi = centre(phi)[2] + phi
    way = -sin(psi), cos(psi)
    normal = dy, -dx
    return atan2(abs(normal[0] * way[1] - normal[1] * way[0]), abs(normal[0] * way[0] + normal[1] * way[1]))


for deg in (15, 40, 65, 85, 120):
    phi = radians(mpf(deg))
    s1, s2 = diff(lift, phi), diff(lift, phi, 2)
    # the cam turns clockwise, and the rise turns the lever clockwise too
    w, a = -s1 * omega, -s2 * omega**2
    M = -(Q - JP * a) * w / -omega
    print(deg, "omega", nstr(w, 20), "alpha", nstr(a, 20), "M", nstr(M, 20))
    angle = pressure_angle(phi)
    # the lever is pressed clockwise by the cam, against the torque Q
    normal = (Q - JP * a) / (ARM / 1000 * cos(angle))
    print("    pressure angle", nstr(degrees(angle), 20), "normal", nstr(normal, 20))
