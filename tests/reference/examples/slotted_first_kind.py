"""B01: slotted group of the first kind, alone; loads at absolute places."""
from planar import *

phi, e, l_BD, l21 = deg(60), mpf("0.03"), mpf("0.3"), mpf("0.02")


def group(contacts=None):
    m = Mechanism()
    m.link("crank", A=(0, 0)).link("slider", B=(0, 0), A=(-l21, 0)).link("bar", C=(0, 0), D=(0, e)).link("arm", C=(0, 0))
    m.line("bar.slot", "D", 0)
    m.revolute("A", "crank", "slider")
    m.revolute("C", "arm", "bar")
    m.prismatic("s", "slider.B", "bar.slot", contacts=contacts)
    m.drive("crank.A", add(at(l_BD - l21, phi), at(e, phi + pi / 2)))
    m.drive("arm.C", (mpf(0), mpf(0)))
    B = add(at(l_BD, phi), at(e, phi + pi / 2))
    m.force("slider", add(B, (mpf("0.01"), mpf("0.005"))), (mpf(-40), mpf(15)))
    m.torque("slider", mpf("-1.5"))
    m.force("bar", (mpf("0.08"), mpf("0.2")), (mpf(120), mpf(-60)))
    m.torque("bar", mpf(-25))
    return m.solve(positive("s"))


if __name__ == "__main__":
    s = group()
    key("reaction(s, bar)", s.reaction("s", "bar"), "N")
    key("position(slider.B)", s.position("slider.B"), "mm")
