"""Andrews' squeezing mechanism: three dyads on one crank, with masses, a spring and a torque."""
from planar import *

OMEGA = mpf("1139.920302259106")                              # as the file writes it
LINKS = {                                                     # ends, length, mass centre, mass, moment of inertia
    "OF": ("O-F", "0.007", ("0.00092", "0"), "0.04325", "2.194e-6"),
    "FE": ("F-E", "0.028", ("0.0115", "0"), "0.00365", "4.410e-7"),
    "BDE": ("B-E", "0.035", ("0.01874", "0.01043"), "0.02373", "5.255e-6"),
    "EG": ("E-G", "0.02", ("0.01421", "0"), "0.00706", "5.667e-7"),
    "AG": ("A-G", "0.04", ("0.02308", "0.00916"), "0.07050", "1.169e-5"),
    "EH": ("E-H", "0.02", ("0.01421", "0"), "0.00706", "5.667e-7"),
    "AH": ("A-H", "0.04", ("0.01228", "-0.00449"), "0.05498", "1.912e-5"),
}
m = Mechanism().ground(O=(0, 0), A=(mpf("-0.06934"), mpf("-0.00227")), B=(mpf("-0.03635"), mpf("0.03273")),
                       C=(mpf("0.014"), mpf("0.072")))
for name, (ends, length, centre, mass, inertia) in LINKS.items():
    points = {"D": (mpf("0.018"), mpf("0.02"))} if name == "BDE" else {}
    m.bar(name, ends, mpf(length), S=tuple(map(mpf, centre)), **points)
    m.mass(name, mpf(mass), "S", J=mpf(inertia))
for pair in (("O", "ground", "OF"), ("F", "OF", "FE"), ("E", "FE", "BDE", "EG", "EH"), ("B", "ground", "BDE"),
             ("A", "ground", "AG", "AH"), ("G", "EG", "AG"), ("H", "EH", "AH")):
    m.revolute(*pair)
m.spring("BDE.D", "ground.C", 4530, mpf("0.07785"))
m.torque("OF", mpf("0.033"))
m.drive("OF", mpf(0), OMEGA)
m.balance_torque("Mb", "OF")
PINS = (("O", "OF"), ("F", "FE"), ("E", "BDE"), ("E", "EG"), ("E", "EH"), ("B", "BDE"), ("A", "AG"), ("A", "AH"), ("G", "AG"),
        ("H", "AH"))

first = m.solve(left_of("BDE.E", "FE.F", "BDE.B"), lambda s: not left_of("AG.G", "BDE.E", "AG.A")(s),
                left_of("AH.H", "BDE.E", "AH.A"), starts=600)
turn = m.sweep(first, "OF", [deg(30 * i) for i in range(12)])
for link in list(LINKS)[1:]:
    keys(f"angle({link})", [s.angle(link) for s in turn], "rad", 12)
    keys(f"omega({link})", [s.omega(link) for s in turn], "rad/s", 12)
    keys(f"alpha({link})", [s.alpha(link) for s in turn], "rad/s^2", 12)
keys("Mb", [s.balance["Mb"] for s in turn], "N*m", 12)
for pair, link in PINS:
    keys(f"reaction({pair}, {link})", [s.reaction(pair, link) for s in turn], "N", 12)
s = m.there(turn, "OF", mpf("15.81077119515370709711938730"))
for link in list(LINKS)[1:]:
    key(f"angle({link})", s.angle(link), "rad", " at OF = 15.810771195153707 rad")
    key(f"omega({link})", s.omega(link), "rad/s", " at OF = 15.810771195153707 rad")
