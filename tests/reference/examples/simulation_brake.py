"""A rotor with viscous drag and a constant brake: J w' = -Mb - c w."""
from printing import *

J, Mb, c, w0 = mpf("0.8"), mpf(15), mpf("0.05"), rpm(1200)
t = J / c * mp.log(1 + c * w0 / Mb)
angle = (J * w0 - Mb * t) / c
print(f"expect time(stands) = {digits(t)} s within 1e-11")
print(f"expect time(half) = {digits(J / c * mp.log((Mb + c * w0) / (Mb + c * w0 / 2)))} s within 1e-11")
print(f"expect angle(rotor) = {digits(angle)} rad within 1e-11 at event end")
print(f"expect integral(power(B)) = {digits(-Mb * angle)} J within 1e-10")
