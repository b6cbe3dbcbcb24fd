"""A V-belt about to slip (Euler and Eytelwein) and a screw jack: angles of lead and of friction added."""
from planar import *

T1, mu, wrap = mpf(900), mpf("0.3"), deg(170)
for name, sine in (("M_belt", mp.sin(deg(19))), ("M_flat", mpf(1))):
    key(name, (T1 - T1 / mp.exp(mu * wrap / sine)) * mpf("0.09"), "N*m")
F, d, f, flank = mpf(20000), mpf("0.0275"), mpf("0.12"), deg(15)
rho = mp.atan(f / mp.cos(flank))
for name, lead, sign in (("M_up", "0.005", 1), ("M_down", "0.005", -1), ("M_fast", "0.02", -1)):
    angle = mp.atan(mpf(lead) / (pi * d))
    alpha = angle + rho if sign > 0 else rho - angle
    key(name, F * d / 2 * mp.sin(alpha) / mp.cos(alpha), "N*m")
