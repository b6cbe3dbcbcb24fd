"""A robot arm of two links by the inverse of its Jacobian, and its torques by Lagrange's equations."""
from printing import *

g, l1, l2, m1, m2 = mpf("9.81"), mpf("0.5"), mpf("0.4"), mpf(3), mpf(2)


def arm(tip, v, a, g):
    """Angles to the ground, rates, accelerations, torques; the elbow left of the line to the tip."""
    x, y = tip
    d2 = x * x + y * y
    elbow = mp.acos((d2 - l1**2 - l2**2) / (2 * l1 * l2))
    q1 = mp.atan2(y, x) + mp.atan2(l2 * mp.sin(elbow), l1 + l2 * mp.cos(elbow))
    q2 = q1 - elbow
    (c1, s1), (c2, s2) = (mp.cos(q1), mp.sin(q1)), (mp.cos(q2), mp.sin(q2))
    det = l1 * l2 * mp.sin(q2 - q1)
    solve = lambda bx, by: ((l2 * (c2 * bx + s2 * by)) / det, -(l1 * (c1 * bx + s1 * by)) / det)
    w1, w2 = solve(*v)
    a1, a2 = solve(
        a[0] + l1 * w1**2 * c1 + l2 * w2**2 * c2,
        a[1] + l1 * w1**2 * s1 + l2 * w2**2 * s2,
    )
    # by angles to the ground: T = 1/2 A w1^2 + B cos(q1 - q2) w1 w2 + 1/2 C w2^2
    A, B, C = m1 * l1**2 / 3 + m2 * l1**2, m2 * l1 * l2 / 2, m2 * l2**2 / 3
    c, s = mp.cos(q1 - q2), mp.sin(q1 - q2)
    of_upper = A * a1 + B * (c * a2 + s * w2**2) + (m1 / 2 + m2) * g * l1 * c1
    of_fore = C * a2 + B * (c * a1 - s * w1**2) + m2 * g * l2 / 2 * c2
    # the motor in the elbow turns the fore arm and holds against the upper one
    return q1, q2, w1, w2, a1, a2, of_upper + of_fore, of_fore


def degrees(x):
    return mp.nstr(x * 180 / pi, 14)


if __name__ == "__main__":
    q1, q2, w1, w2, a1, a2, M1, M2 = arm((mpf("0.6"), mpf("0.3")), (mpf("0.2"), -mpf("0.1")), (mpf(1), mpf("0.5")), g)
    print(f"expect angle(upper) = {degrees(q1)} deg within 1e-12")
    print(f"expect angle(fore) = {degrees(q2)} deg within 1e-12")
    print(f"expect omega(upper) = {mp.nstr(w1, 14)} rad/s within 1e-12")
    print(f"expect omega(fore) = {mp.nstr(w2, 14)} rad/s within 1e-12")
    print(f"expect alpha(upper) = {mp.nstr(a1, 14)} rad/s^2 within 1e-12")
    print(f"expect alpha(fore) = {mp.nstr(a2, 14)} rad/s^2 within 1e-12")
    print(f"expect M1 = {mp.nstr(M1, 14)} N*m within 1e-12")
    print(f"expect M2 = {mp.nstr(M2, 14)} N*m within 1e-12")
