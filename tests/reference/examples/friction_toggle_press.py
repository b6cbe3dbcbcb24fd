"""Toggle press with friction, working and return stroke, and with the knee's pin in the lower link."""
from planar import *
from friction import with_friction

for speed, knee in ((1, ("rod", "upper", "lower")), (-1, ("rod", "upper", "lower")), (1, ("lower", "upper", "rod"))):
    m = Mechanism().ground(A=(mpf("-0.45"), mpf("0.3")), D=(0, mpf("0.6")), E0=(0, 0))
    m.line("ground.guide", "E0", deg(90))
    m.bar("crank", "A-B", mpf("0.1"))
    m.bar("rod", "B-C", mpf("0.4"))
    m.bar("upper", "D-C", mpf("0.3"))
    m.bar("lower", "C-E", mpf("0.3"))
    m.link("ram", E=(0, 0))
    m.revolute("A", "ground", "crank")
    m.revolute("B", "crank", "rod")
    m.revolute("C", *knee)
    m.revolute("D", "ground", "upper")
    m.revolute("E", "lower", "ram")
    m.prismatic("G", "ram.E", "ground.guide")
    m.drive("crank", deg(5), mpf(speed))
    m.force("ram", "E", (mpf(0), mpf(50000)))
    m.balance_torque("Mb", "crank")
    s = m.solve(right_of("C", "B", "D"), near={"ram.E": (0, mpf("0.008"))})
    balance, _ = with_friction(s, {name: mpf("0.004") for name in "ABCDE"} | {"G": mpf("0.1")})
    key(f"Mb at {speed} rad/s, pin in {knee[0]}", balance["Mb"], "N*m")
