"""The three machines as trees of links for the peers that build on trees: bars of 2 kg/m and a piston of 0.5 kg, cut open at
one pin of every loop. A link's origin is the pin that joins it to the link before it."""
import math

SPEED = 30.0
COUNT = 360
STEP = 2 * math.pi / (SPEED * COUNT)  # s from one position to the next
LENGTHS = {"crank": 0.1, "rod": 0.35, "coupler": 0.35, "rocker": 0.3, "link5": 0.3, "link6": 0.25}
PISTON = 0.5
# pair: link before, point on it, link
FOUR_BAR = {"A": ("ground", (0, 0), "crank"), "B": ("crank", (0.1, 0), "coupler"), "D": ("ground", (0.4, 0), "rocker")}
TREES = {
    "crank-slider": {"A": ("ground", (0, 0), "crank"), "B": ("crank", (0.1, 0), "rod"), "D": ("ground", (0, 0), "piston")},
    "four-bar": FOUR_BAR,
    "six-bar": {**FOUR_BAR, "E": ("coupler", (0.2, 0.15), "link5"), "G": ("ground", (0.35, 0.35), "link6")},
}
# pair: link, point on it, link, point on it
CUTS = {
    "crank-slider": {"C": ("rod", (0.35, 0), "piston", (0, 0))},
    "four-bar": {"C": ("coupler", (0.35, 0), "rocker", (0.3, 0))},
    "six-bar": {"C": ("coupler", (0.35, 0), "rocker", (0.3, 0)), "F": ("link5", (0.3, 0), "link6", (0.25, 0))},
}


def mass(link):
    """Mass, distance of its centre from the origin, moment of inertia about the centre; the piston does not turn."""
    if link == "piston":
        return PISTON, 0.0, 1e-3
    length = LENGTHS[link]
    return 2 * length, length / 2, 2 * length**3 / 12


def start(name, pose):
    """Of every joint of the tree its coordinate and speed at a position that assur gives: angles between links, the way of
    the piston."""
    found = {}
    for pair, (before, _, link) in TREES[name].items():
        if link == "piston":
            found[pair] = [pose["points"]["piston.C"][what][0] for what in ("position", "velocity")]
        else:
            of = lambda what: pose["links"][link][what] - (pose["links"][before][what] if before != "ground" else 0.0)
            found[pair] = [of("angle"), of("omega")]
    return found


def angles(name, coordinates):
    """The angles of the links from the coordinates of the joints, column by column."""
    found = {"ground": 0.0 * coordinates[:, 0]}
    for (before, _, link), column in zip(TREES[name].values(), coordinates.T):
        found[link] = found["ground"] if link == "piston" else found[before] + column
    return found
