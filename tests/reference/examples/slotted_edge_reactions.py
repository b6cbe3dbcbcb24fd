"""B02: the slot's reaction at two edges, for several lengths; closed form beside the solved one."""
from planar import *
from slotted_first_kind import group

print("variants {\n  l1 [mm], l2 [mm], R1_key [N], R2_key [N]")
for l1, l2 in ((40, 30), (30, 30), (60, 20), (20, 60)):
    s = group((mpf(l1) / 1000, -mpf(l2) / 1000))
    R, M = s.normal("s", "slider"), s.moment("s", "slider")
    a, b = mpf(l1) / 1000, mpf(l2) / 1000
    assert abs(s.contact_force("s", 1) - (M + R * b) / (a + b)) < mpf(10) ** -28
    assert abs(s.contact_force("s", 2) - (R * a - M) / (a + b)) < mpf(10) ** -28
    print(f"  {l1}, {l2}, {digits(s.contact_force('s', 1))}, {digits(s.contact_force('s', 2))}")
print("}")
