"""A flap with two rates far apart: two exponentials."""
from printing import *

fast, slow, start = mpf(5000000), mpf("0.4"), deg(60)
for t in ("1", "2.5", "5"):
    x = -slow * mpf(t)
    # the other exponential is below 10^-1000000 by then
    value = start * fast * mp.exp(x) / (fast - slow)
    print(f"expect angle(flap) = {digits(value)} rad within 1e-9 at time = {t} s")
    print(f"expect omega(flap) = {digits(-slow * value)} rad/s within 1e-9 rad/s at time = {t} s")
