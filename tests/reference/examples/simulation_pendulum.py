"""A pendulum from the horizontal: period by the arithmetic-geometric mean, place by the elliptic functions of Jacobi."""
from printing import *


def means(k):
    """Arithmetic-geometric means from 1 and k', with half the differences."""
    a, b, c = mpf(1), mp.sqrt(1 - k * k), k
    out = [(a, c)]
    while abs(c) > mpf(10) ** -35:
        a, b, c = (a + b) / 2, mp.sqrt(a * b), (a - b) / 2
        out.append((a, c))
    return out


def sn_dn(u, k):
    """sn and dn by descending transformations of Landen."""
    all_means = means(k)
    phi = 2 ** (len(all_means) - 1) * all_means[-1][0] * u
    for a, c in reversed(all_means[1:]):
        phi = (phi + mp.asin(c / a * mp.sin(phi))) / 2
    s = mp.sin(phi)
    return s, mp.sqrt(1 - k * k * s * s)


g, k = mpf("9.81"), mp.sin(pi / 4)
T = 2 * pi / means(k)[-1][0] / mp.sqrt(g)
# from the lowest place theta: sin(theta/2) = k sn(sqrt(g) (T/4 + t)); k sn at the first instant is k
s, d = sn_dn(mp.sqrt(g) * (10 + T / 4), k)
half = k * s
theta = 2 * mp.asin(half)
for text, n in (("time(back)", 1), ("time(rest, 7)", mpf("3.5")), ("time(lowest)", mpf("0.25")), ("time(lowest, 4)", mpf("3.25"))):
    print(f"expect {text} = {digits(n * T)} s within 1e-11")
print(f"expect position(P) = ({digits(mp.sin(theta))} m, {digits(-mp.cos(theta))} m) within 1e-11 m at time = 10 s")
print(f"expect abs(omega(bar)) = {digits(mp.sqrt(2 * g * mp.cos(theta)))} rad/s within 1e-11 at time = 10 s")
