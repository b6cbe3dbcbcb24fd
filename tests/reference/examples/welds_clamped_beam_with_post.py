"""A clamped beam with a post: sums of forces and of moments about B of the post, and about A of both."""
from printing import *

P, H, middle, end, height = mpf(3), mpf(2), mpf(1), mpf(2), mpf("1.2")
print(f"expect reaction(A, beam).x = {mp.nstr(-H, 14)} kN within 1e-12")
print(f"expect reaction(A, beam).y = {mp.nstr(P, 14)} kN within 1e-12")
print(f"expect moment(A, beam) = {mp.nstr(middle * P + height * H, 14)} kN*m within 1e-12")
print(f"expect reaction(B, post).x = {mp.nstr(-H, 14)} kN within 1e-12")
print("expect reaction(B, post).y = 0 N within 1e-9 N")
print(f"expect moment(B, post) = {mp.nstr(height * H, 14)} kN*m within 1e-12")
