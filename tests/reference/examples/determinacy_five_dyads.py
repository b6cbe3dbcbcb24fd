"""A30: the five dyads of class II, each standing on the ground as a structure; every dyad is solved alone."""
from planar import *


def rrr():
    m = Mechanism().ground(A=(0, 0), B=(mpf("0.3"), 0))
    m.bar("a1", "A-C", mpf("0.2"), K=(mpf("0.1"), mpf("0.02"))).bar("a2", "B-C", mpf("0.25"))
    m.revolute("A", "ground", "a1")
    m.revolute("B", "ground", "a2")
    m.revolute("C", "a1", "a2")
    m.force("a1", "K", (mpf(20), mpf(-60)))
    m.torque("a2", mpf(5))
    return m.solve(left_of("C", "A", "B")), (("A", "a1"), ("C", "a2"), ("B", "a2"))


def rrp():
    m = Mechanism().ground(E=(mpf("1.0"), 0), G=(mpf("1.2"), mpf("0.05")))
    m.line("ground.guide1", "G", deg(10))
    m.bar("b1", "E-F", mpf("0.3"), K=(mpf("0.12"), mpf("0.03"))).link("b2", F=(0, 0), K=(mpf("0.02"), mpf("0.04")))
    m.revolute("E", "ground", "b1")
    m.revolute("F", "b1", "b2")
    m.prismatic("G", "b2.F", "ground.guide1")
    m.force("b1", "K", (mpf(-10), mpf(-30)))
    m.force("b2", "K", (mpf(-70), mpf(15)))
    return m.solve(ahead("F", "E", "G")), (("E", "b1"), ("F", "b2"), ("G", "b2"))


def rpr():
    m = Mechanism().ground(H=(2, 0), I=(mpf("2.3"), mpf("0.1")))
    m.link("c1", I=(0, 0)).link("c2", H=(0, 0), T=(0, mpf("0.02")), K=(mpf("0.4"), 0))
    m.line("c2.slot", "T", 0)
    m.revolute("H", "ground", "c2")
    m.revolute("I", "ground", "c1")
    m.prismatic("J", "c1.I", "c2.slot")
    m.force("c2", "K", (mpf(0), mpf(-45)))
    m.torque("c1", mpf(2))
    return m.solve(positive("J")), (("H", "c2"), ("I", "c1"), ("J", "c1"))


def prp():
    m = Mechanism().ground(U=(3, 0), V=(mpf("3.2"), mpf("0.1")))
    m.line("ground.guide2", "U", deg(20))
    m.line("ground.guide3", "V", deg(100))
    m.link("d1", L=(0, 0), K=(mpf("0.03"), mpf("0.05"))).link("d2", L=(0, 0), K=(mpf("-0.04"), mpf("0.02")))
    m.prismatic("M", "d1.L", "ground.guide2")
    m.revolute("L", "d1", "d2")
    m.prismatic("N", "d2.L", "ground.guide3")
    m.force("d1", "K", (mpf(35), mpf(-80)))
    m.force("d2", "K", (mpf(-25), mpf(10)))
    return m.solve(), (("M", "d1"), ("L", "d2"), ("N", "d2"))


def rpp():
    m = Mechanism().ground(P=(4, mpf("0.1")), W=(mpf("4.1"), 0))
    m.line("ground.guide4", "W", 0)
    m.link("e1", P=(0, 0)).link("e2", W=(0, 0), K=(mpf("0.15"), mpf("0.05")))
    m.line("e2.slot", "W", deg(60))
    m.revolute("P", "ground", "e1")
    m.prismatic("Q", "e1.P", "e2.slot")
    m.prismatic("R", "e2.W", "ground.guide4")
    m.torque("e1", mpf("1.5"))
    m.force("e2", "K", (mpf(-90), mpf(-20)))
    return m.solve(), (("P", "e1"), ("Q", "e2"), ("R", "e2"))


for dyad in (rrr, rrp, rpr, prp, rpp):
    s, wanted = dyad()
    for pair, link in wanted:
        key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
        if s.m.pair(pair).kind == "prismatic":
            key(f"moment({pair}, {link})", s.moment(pair, link), "N*m")
