"""The three machines in KinePy: positions; reactions in all pairs with the torque on the crank.

Bars weigh 2 kg/m. KinePy differentiates positions by central differences over the given ones, so that the first and the
last have no accelerations: one position more is given on either side of the turn.
"""
import contextlib
import io
import itertools
import math

import numpy
from kinepy.interface.system import System
from kinepy.units import SI, set_unit_system

SPEED = 30.0
set_unit_system(SI)


def bar(system, name, length):
    mass = 2.0 * length
    return system.add_solid(name, mass, mass * length**2 / 12, (length / 2, 0.0))


class Machine:
    def __init__(self, name):
        self.system = s = System()
        s.add_gravity((0.0, -9.81))
        ground, crank = s.ground, bar(s, "crank", 0.1)
        self.crank = s.add_revolute(ground, crank)
        # pair of the file: joint, and +1 where the file's `on` is its second solid
        self.pins = {"A": self.crank}
        if name == "crank-slider":
            rod, piston = bar(s, "rod", 0.35), s.add_solid("piston", 0.5)
            self.pins["B"] = s.add_revolute(crank, rod, (0.1, 0.0), (0.0, 0.0))
            self.pins["C"] = s.add_revolute(rod, piston, (0.35, 0.0), (0.0, 0.0))
            s.add_prismatic(ground, piston)
            self.places = {"rod.C": (rod, (0.35, 0.0))}
        else:
            coupler, rocker = bar(s, "coupler", 0.35), bar(s, "rocker", 0.3)
            self.pins["B"] = s.add_revolute(crank, coupler, (0.1, 0.0), (0.0, 0.0))
            self.pins["C"] = s.add_revolute(coupler, rocker, (0.35, 0.0), (0.3, 0.0))
            self.pins["D"] = s.add_revolute(ground, rocker, (0.4, 0.0), (0.0, 0.0))
            self.places = {"coupler.C": (coupler, (0.35, 0.0))}
        if name == "six-bar":
            link5, link6 = bar(s, "link5", 0.3), bar(s, "link6", 0.25)
            self.pins["E"] = s.add_revolute(coupler, link5, (0.2, 0.15), (0.0, 0.0))
            self.pins["F"] = s.add_revolute(link5, link6, (0.3, 0.0), (0.25, 0.0))
            self.pins["G"] = s.add_revolute(ground, link6, (0.35, 0.35), (0.0, 0.0))
            self.places["link5.F"] = (link5, (0.3, 0.0))
        with contextlib.redirect_stdout(io.StringIO()):
            s.pilot(self.crank)
            s.compile()

    def inputs(self, count):
        return numpy.arange(-1, count + 1) * (2 * math.pi / count)

    def positions(self, count):
        self.system.solve_kinematics(self.inputs(count))

    def dynamics(self, count):
        given = self.inputs(count)
        self.system.solve_dynamics(given, len(given) * 2 * math.pi / (count * SPEED))

    def place(self, name):
        solid, at = self.places[name]
        return numpy.array(solid.get_point(at))[:, 1:-1].T

    def assemble(self, wanted):
        """Chooses the signs that put the points where they are wanted: name → positions."""
        count = len(next(iter(wanted.values())))
        for signs in itertools.product((1, -1), repeat=len(self.system._object.signs)):
            self.system.change_signs(list(signs))
            self.positions(count)
            if all(numpy.abs(self.place(name) - numpy.array(wanted[name])).max() < 1e-6 for name in self.places):
                return
        raise ValueError("no assembly is the file's")

    def reactions(self, pair):
        return numpy.array(self.pins[pair].force)[:, 1:-1].T

    def torque(self):
        return numpy.array(self.crank.torque)[1:-1]
