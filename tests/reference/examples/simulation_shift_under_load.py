"""A gear shift: accelerations linear in time, by hand in three phases. Speeds of the rotor count in the sense of the motor."""
from printing import *

J_m, J_l, J_h, J_r, T, M, w = mpf("0.2"), mpf("0.05"), mpf("0.05"), mpf(2), mpf(2), mpf(20), rpm(1500)
# all that turns with the motor, of its speed
J = J_m + J_l / 4 + J_h


def C_k(t):
    return 40 * (1 - t / T)


def C_l(t):
    return 80 * t / T


# The first clutch holds: w_r = w_m/2 and M - C_l + C_l/2 = (J + J_r/4) a, as the second one slips at the speed w_m - w_r > 0.
def held(t):
    a = (M - C_l(t) / 2) / (J + J_r / 4)
    return J_r * a / 2 - C_l(t)


def a_1(t):
    return (M - C_l(t) / 2) / (J + J_r / 4)


# What it carries falls to nothing and on to minus its capacity: C_l = 40 t grows, C_k = 40 - 20 t falls.
off = mp.findroot(lambda t: held(t) + C_k(t), 0.7)
w_m = w + mp.quad(a_1, [0, off])
w_r = w_m / 2


# Both slip: the rotor now runs faster than the low wheel, which it drives.
def a_m(t):
    return (M - C_l(t) + C_k(t) / 2) / J


def a_r(t):
    return (C_l(t) - C_k(t)) / J_r


def apart(t):
    return w_m - w_r + mp.quad(lambda s: a_m(s) - a_r(s), [off, t])


on = mp.findroot(apart, 1.7)
w_on = w_r + mp.quad(a_r, [off, on])


# The second one holds.
def a_2(t):
    return (M - C_k(t) / 2) / (J + J_r)


end = w_on + mp.quad(a_2, [on, 2]) + M / (J + J_r)
print(f"expect time(lets_go) = {digits(off)} s within 1e-11")
print(f"expect time(takes_over) = {digits(on)} s within 1e-11")
print(f"expect omega(rotor) = {digits(-w_on)} rad/s within 1e-11 at event takes_over")
print(f"expect omega(motor) = {digits(end)} rad/s within 1e-11 at event end")
print(f"expect moment(l, rotor) = {digits(-M * J_r / (J + J_r))} N*m within 1e-11 at event end")
