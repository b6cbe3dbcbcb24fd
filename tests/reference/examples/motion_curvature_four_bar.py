"""The coupler curve as a complex function of the crank angle, differentiated by Taylor's series."""
from printing import *

a, b, c, d = mpf("0.15"), mpf("0.4"), mpf("0.3"), mpf("0.4")


def point(q):
    """E at a crank angle; C lies left of the line from B to D."""
    B = a * mp.expj(q)
    to_d = d - B
    u = to_d / abs(to_d)
    along = (b * b - c * c + abs(to_d) ** 2) / (2 * abs(to_d))
    C = B + (along + 1j * mp.sqrt(b * b - along * along)) * u
    return B + (mpf("0.2") + mpf("0.1") * 1j) * (C - B) / b


def rates(q):
    """First and second derivative by the crank angle."""
    return mp.diff(point, q), mp.diff(point, q, 2)


def bend(q):
    first, second = rates(q)
    return (mp.conj(first) * second).imag


mp.dps = 40
q = mp.radians(60)
E, (first, second) = point(q), rates(q)
rho = abs(first) ** 3 / bend(q)
centre = E + rho * 1j * first / abs(first)
for name, z in (("position(coupler.E)", E), ("curvature_centre(coupler.E)", centre)):
    print(f"expect {name} = ({mp.nstr(z.real, 14)} m, {mp.nstr(z.imag, 14)} m) within 1e-13 at pose asked")
print(f"expect rho = {mp.nstr(rho, 14)} m within 1e-13 at pose asked")
for name, near in (("drive(flat)", 331), ("drive(flat, 2)", 347)):
    at = mp.findroot(bend, mp.radians(near))
    print(f"expect {name} = {mp.nstr(mp.degrees(at), 13)} deg within 1e-12")
