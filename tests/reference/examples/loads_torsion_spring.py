"""Springs in hinges: an arm of two bars by Newton and Euler, bar by bar."""
from planar import *

g = mpf("9.81")
l, s_1, m_1, J_1 = mpf("0.4"), mpf("0.18"), mpf(6), mpf("0.09")
s_2, m_2, J_2 = mpf("0.15"), mpf(3), mpf("0.035")
phi, omega = deg(40), mpf("1.5")
theta, rate, second = deg(50), mpf(-2), mpf(3)
psi, w, e = phi + theta, omega + rate, second          # of the fore bar: angle, speed, acceleration


def at(r, angle, w, e):
    """Acceleration of the end of a bar from its other end."""
    c, s = mp.cos(angle) * r, mp.sin(angle) * r
    return (-e * s - w**2 * c, e * c - w**2 * s)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


a_B = at(l, phi, omega, mpf(0))
a_2 = add(a_B, at(s_2, psi, w, e))
a_1 = at(s_1, phi, omega, mpf(0))
F_B = (m_2 * a_2[0], m_2 * (a_2[1] + g))               # on the fore bar
arm = (s_2 * mp.cos(psi), s_2 * mp.sin(psi))
M_B = J_2 * e + cross(arm, F_B)                        # on the fore bar, of motor, spring and damper
F_O = (m_1 * a_1[0] + F_B[0], m_1 * (a_1[1] + g) + F_B[1])
end, centre = (l * mp.cos(phi), l * mp.sin(phi)), (s_1 * mp.cos(phi), s_1 * mp.sin(phi))
M_O = M_B + cross(end, F_B) + cross(centre, (m_1 * a_1[0], m_1 * (a_1[1] + g)))
key("effort(upper)", M_O - 20 * (deg(90) - phi), "N*m")
key("effort(B)", M_B - 8 * (deg(20) - theta) + mpf("0.6") * rate, "N*m")
key("reaction(O, upper)", F_O, "N")
key("reaction(B, fore)", F_B, "N")
