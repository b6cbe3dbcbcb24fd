"""The three machines in pylinkage, compiled by numba: positions; velocities and accelerations. It knows no forces."""
import math

import pylinkage.actuators as actuators
import pylinkage.components as components
import pylinkage.dyads as dyads
from pylinkage.simulation import Linkage

SPEED = 30.0
COUNT = 360


class Machine:
    def __init__(self, name):
        ground = components.Ground(0.0, 0.0, name="A")
        # it turns before it solves: the first position it gives is the second of the file
        self.crank = actuators.Crank(anchor=ground, radius=0.1, angular_velocity=2 * math.pi / COUNT)
        parts = [ground, self.crank]
        pin = self.crank.output
        if name == "crank-slider":
            line = [components.Ground(0.0, 0.0, name="P"), components.Ground(1.0, 0.0, name="Q")]
            slider = dyads.RRPDyad(pin, *line, distance=0.35, x=0.45, y=0.0)
            parts += [*line, slider]
            self.points = {"rod.C": slider}
        else:
            foot = components.Ground(0.4, 0.0, name="D")
            first = dyads.RRRDyad(pin, foot, distance1=0.35, distance2=0.3, x=0.33, y=0.28)
            parts += [foot, first]
            self.points = {"coupler.C": first}
        if name == "six-bar":
            point = dyads.FixedDyad(pin, first, distance=math.hypot(0.2, 0.15), angle=math.atan2(0.15, 0.2))
            foot = components.Ground(0.35, 0.35, name="G")
            second = dyads.RRRDyad(point, foot, distance1=0.3, distance2=0.25, x=0.2, y=0.6)
            parts += [point, foot, second]
            self.points["link5.F"] = second
        self.parts = parts
        self.linkage = Linkage(parts)
        self.linkage.set_input_velocity(self.crank, SPEED)
        self.linkage.compile()

    def positions(self, count):
        return self.linkage.step_fast(count)

    def kinematics(self, count):
        return self.linkage.step_fast_with_kinematics(count)

    def index(self, name):
        return self.linkage.components.index(self.points[name])
