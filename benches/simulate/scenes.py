"""Andrews' squeezing mechanism and chains of N four-bars: data, references, and the files that assur solves.

A link's frame has its origin at its first point. A tree joins every link to one before it; loops close it."""
import math
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


@dataclass
class Link:
    name: str
    mass: float
    inertia: float
    centre: tuple
    points: dict
    before: str   # the link that it hangs on, or "ground"
    pin: tuple    # point on that link, point on this one
    angle: float  # at the first instant
    rate: float = 0.0


@dataclass
class Scene:
    name: str
    end: float
    links: list
    ground: dict
    loops: list   # (link, point, link, point)
    gravity: float = 0.0
    torque: tuple = ()   # link, N m
    spring: tuple = ()   # link, point, ground point, stiffness, free length
    reference: dict = field(default_factory=dict)

    def index(self, name):
        return next(i for i, link in enumerate(self.links) if link.name == name)


BETA, GAMMA, PHI = -0.0617138900142764496358948458001, 0.455279819163070380255912382449, 0.222668390165885884674473185609
DELTA, EPSILON = 0.487364979543842550225598953530, 1.23054744454982119249735015568
# at 0.03 s: Hairer and Wanner's β, Θ, γ, Φ, δ, ε, from two computations with 50 digits and in quadruple precision
ANDREWS = (15.81077119515370709711938730, -15.75637105841183946972775, 0.04082224011964580485828232,
           -0.5347301163420795937701850, 0.5244099658799540693716558, 1.048080741041937873068515)


def turn(angle, x, y):
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y


def andrews():
    ground = {"O": (0, 0), "A": (-0.06934, -0.00227), "B": (-0.03635, 0.03273), "C": (0.014, 0.072)}
    bde, eg, ag, ah = GAMMA - math.pi / 2, PHI + DELTA + math.pi / 2, DELTA, EPSILON - math.pi / 2
    # H from A, E from B: the direction from E to H
    e = [a + b for a, b in zip(ground["B"], turn(bde, 0.035, 0))]
    h = [a + b for a, b in zip(ground["A"], turn(ah, 0.04, 0))]
    eh = math.atan2(h[1] - e[1], h[0] - e[0])
    links = [
        Link("OF", 0.04325, 2.194e-6, (0.00092, 0), {"O": (0, 0), "F": (0.007, 0)}, "ground", ("O", "O"), BETA),
        Link("FE", 0.00365, 4.410e-7, (0.0115, 0), {"F": (0, 0), "E": (0.028, 0)}, "OF", ("F", "F"), BETA + math.pi),
        Link("BDE", 0.02373, 5.255e-6, (0.01874, 0.01043), {"B": (0, 0), "E": (0.035, 0), "D": (0.018, 0.02)}, "ground", ("B", "B"), bde),
        Link("AG", 0.07050, 1.169e-5, (0.02308, 0.00916), {"A": (0, 0), "G": (0.04, 0)}, "ground", ("A", "A"), ag),
        Link("EG", 0.00706, 5.667e-7, (0.01421, 0), {"E": (0, 0), "G": (0.02, 0)}, "AG", ("G", "G"), eg),
        Link("AH", 0.05498, 1.912e-5, (0.01228, -0.00449), {"A": (0, 0), "H": (0.04, 0)}, "ground", ("A", "A"), ah),
        Link("EH", 0.00706, 5.667e-7, (0.01421, 0), {"E": (0, 0), "H": (0.02, 0)}, "AH", ("H", "H"), eh),
    ]
    loops = [("FE", "E", "BDE", "E"), ("EG", "E", "BDE", "E"), ("EH", "E", "BDE", "E")]
    beta, theta, gamma, phi, delta, epsilon = ANDREWS
    reference = {
        "OF": beta, "FE": beta + theta + math.pi, "BDE": gamma - math.pi / 2, "EG": phi + delta + math.pi / 2,
        "AG": delta, "AH": epsilon - math.pi / 2,
    }
    return Scene("andrews", 0.03, links, ground, loops, torque=("OF", 0.033), spring=("BDE", "D", "C", 4530.0, 0.07785), reference=reference)


# the common angle after 10 s
BARS = {1: -30.343944970943127889, 10: -30.050933495986975996}


def bars(n):
    """n four-bars in a row, every bar 1 m and 1 kg; all cranks turn together."""
    ground = {f"A{i}": (float(i), 0.0) for i in range(n + 1)}
    bar = lambda name, a, b, before, at, angle, rate: Link(
        name, 1.0, 1 / 12, (0.5, 0.0), {a: (0.0, 0.0), b: (1.0, 0.0)}, before, (at, a), angle, rate)
    links = [bar(f"c{i}", f"A{i}", f"B{i}", "ground", f"A{i}", math.pi / 2, -1.0) for i in range(n + 1)]
    links += [bar(f"k{i}", f"B{i - 1}", f"B{i}", f"c{i - 1}", f"B{i - 1}", 0.0, 0.0) for i in range(1, n + 1)]
    loops = [(f"k{i}", f"B{i}", f"c{i}", f"B{i}") for i in range(1, n + 1)]
    return Scene(f"bars-{n}", 10.0, links, ground, loops, gravity=9.81, reference={"c0": BARS.get(n) or shared_angle(n)})


def shared_angle(n):
    """The angle after 10 s from the equation of all bars together, by Taylor series in exact steps: 15 digits."""
    pull = 9.81 * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)
    angle, rate, steps, order = math.pi / 2, -1.0, 200, 40
    h = 10.0 / steps
    for _ in range(steps):
        # of the angle, its sine and its cosine
        q, s, c = [angle, rate], [math.sin(angle)], [math.cos(angle)]
        for k in range(1, order):
            s.append(sum((j + 1) * q[j + 1] * c[k - 1 - j] for j in range(k)) / k)
            c.append(-sum((j + 1) * q[j + 1] * s[k - 1 - j] for j in range(k)) / k)
            q.append(-pull * c[k - 1] / ((k + 1) * k))
        angle = math.fsum(x * h**i for i, x in enumerate(q))
        rate = math.fsum(i * x * h**(i - 1) for i, x in enumerate(q) if i)
    return angle


def scene(name):
    return andrews() if name == "andrews" else bars(int(name.split("-")[1]))


def origins(scene):
    """The place of every link's origin at the first instant."""
    found = {"ground": (0.0, 0.0)}
    for link in scene.links:
        x, y = point_at(scene, found, link.before, link.pin[0])
        a, b = turn(link.angle, *link.points[link.pin[1]])
        found[link.name] = (x - a, y - b)
    return found


def point_at(scene, found, name, point):
    if name == "ground":
        return scene.ground[point]
    link = scene.links[scene.index(name)]
    (x, y), (a, b) = found[name], turn(link.angle, *link.points[point])
    return x + a, y + b


def error(scene, angles):
    """The greatest |Δq|/(1 + |q|) of the angles at the end; all but those of cranks without whole turns."""
    worst = 0.0
    for name, exact in scene.reference.items():
        off = angles[name] - exact
        if name not in ("OF", "c0"):
            off = math.remainder(off, 2 * math.pi)
        worst = max(worst, abs(off) / (1 + abs(exact)))
    return worst if worst == worst else math.inf


def mech(scene, within="1e-9"):
    """The file that assur solves: the last instant alone is asked for."""
    if scene.name == "andrews":
        text = (ROOT / "examples" / "simulation" / "andrews.mech").read_text()
        kept = [line for line in text.splitlines() if not line.startswith(("find", "expect", "simulate", "//"))]
        kept += [f"simulate 0.03 s within {within}", "find " + ", ".join(f"angle({name})" for name in scene.reference)]
        return "\n".join(kept) + "\n"
    n = sum(link.name.startswith("c") for link in scene.links) - 1
    bar = "1 m { S (500 mm, 0); mass 1 kg at S; inertia (1/12)*(1 kg*m^2) }"
    lines = ["mech 1", f'mechanism "{n} four-bars in a row"', "gravity 9.81 m/s^2"]
    lines.append("ground { " + "; ".join(f"A{i} ({i} m, 0)" for i in range(n + 1)) + " }")
    lines += [f"link c{i} A{i}-B{i} {bar}" for i in range(n + 1)]
    lines += [f"link k{i} B{i - 1}-B{i} {bar}" for i in range(1, n + 1)]
    lines += [f"revolute A{i}: ground - c{i}" for i in range(n + 1)]
    on = lambda i: " - ".join([f"c{i}"] + ([f"k{i}"] if i else []) + ([f"k{i + 1}"] if i < n else []))
    lines += [f"revolute B{i}: {on(i)}" for i in range(n + 1)]
    lines.append("assemble " + ", ".join(f"B{i} left of B{i - 1}-A{i}" for i in range(1, n + 1)))
    lines += ["start c0 = 90 deg at 1 rad/s cw", f"simulate 10 s within {within}", "find angle(c0) as rad, energy()"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    import sys
    sys.stdout.write(mech(scene(sys.argv[1]), *sys.argv[2:]))
