"""The three machines in Drake: a plant of the tree. At every angle the cut pins are closed by Newton's method from the last
position, with Drake's points and Jacobians; velocities and accelerations follow from the same matrix, and from Drake's inverse
dynamics the forces in the cut pins and the torque on the crank. Numpy solves the two or four equations."""
import numpy
from machines import COUNT, CUTS, SPEED, STEP, TREES, angles, mass, start
from pydrake.math import RigidTransform
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (
    FixedOffsetFrame, JacobianWrtVariable, MultibodyForces, PrismaticJoint, RevoluteJoint, RotationalInertia, SpatialInertia)

V = JacobianWrtVariable.kV


class Machine:
    def __init__(self, name, pose):
        self.name = name
        self.plant = plant = MultibodyPlant(0.0)
        plant.mutable_gravity_field().set_gravity_vector([0, -9.81, 0])
        frames, joints = {"ground": plant.world_frame()}, {}
        for pair, (before, (x, y), link) in TREES[name].items():
            m, centre, inertia = mass(link)
            # the moments about the other two axes have no effect
            about = RotationalInertia(0.5 * inertia, 0.5 * inertia, inertia)
            body = plant.AddRigidBody(link, SpatialInertia.MakeFromCentralInertia(m, [centre, 0, 0], about))
            frames[link] = body.body_frame()
            at = plant.AddFrame(FixedOffsetFrame(pair, frames[before], RigidTransform([x, y, 0])))
            kind, axis = (PrismaticJoint, [1, 0, 0]) if link == "piston" else (RevoluteJoint, [0, 0, 1])
            joints[pair] = plant.AddJoint(kind(f"joint {pair}", at, frames[link], axis))
        plant.Finalize()
        self.context = plant.CreateDefaultContext()
        self.external = MultibodyForces(plant)
        self.columns = [joints[pair].position_start() for pair in TREES[name]]
        self.crank = joints["A"].position_start()
        self.others = [c for c in range(plant.num_positions()) if c != self.crank]
        self.first = numpy.zeros(plant.num_positions())
        for column, (place, _) in zip(self.columns, start(name, pose).values()):
            self.first[column] = place
        self.cuts = [(frames[one], numpy.array([*p, 0.0]), frames[two], numpy.array([*q, 0.0]))
                     for one, p, two, q in CUTS[name].values()]

    def at(self, angle, q):
        """Places, velocities, accelerations, forces in the cut pins and torque; the search begins at q."""
        plant, context, cuts, others = self.plant, self.context, self.cuts, self.others
        q[self.crank] = angle
        for _ in range(9):
            plant.SetPositions(context, q)
            gap = numpy.concatenate([(plant.CalcPointsPositions(context, one, p, two)[:, 0] - o)[:2] for one, p, two, o in cuts])
            jacobian = numpy.vstack(
                [plant.CalcJacobianTranslationalVelocity(context, V, one, p, two, two)[:2] for one, p, two, _ in cuts])
            inverse = numpy.linalg.inv(jacobian[:, others])
            if abs(gap).max() < 1e-13:
                break
            q[others] -= inverse @ gap
        v = numpy.empty_like(q)
        v[self.crank] = SPEED
        v[others] = inverse @ (jacobian[:, self.crank] * -SPEED)
        plant.SetVelocities(context, v)
        bias = numpy.concatenate(
            [plant.CalcBiasTranslationalAcceleration(context, V, one, p, two, two)[:2, 0] for one, p, two, _ in cuts])
        a = numpy.zeros_like(q)
        a[others] = inverse @ -bias
        plant.CalcForceElementsContribution(context, self.external)
        effort = plant.CalcInverseDynamics(context, a, self.external)
        force = effort[others] @ inverse
        return q, v, a, force, effort[self.crank] - force @ jacobian[:, self.crank]

    def turn(self):
        """A revolution."""
        q, self.found = self.first.copy(), []
        for i in range(COUNT):
            found = self.at(i * STEP * SPEED, q)
            self.found.append(found)
            q = found[0] + STEP * found[1] + 0.5 * STEP**2 * found[2]

    def answers(self):
        """Forces of the cut pins in the frame of the ground, and the torque."""
        turned = angles(self.name, numpy.array([f[0] for f in self.found])[:, self.columns])
        forces = {}
        for i, (pair, cut) in enumerate(CUTS[self.name].items()):
            x, y = numpy.array([f[3][2 * i:2 * i + 2] for f in self.found]).T
            c, s = numpy.cos(turned[cut[2]]), numpy.sin(turned[cut[2]])
            forces[pair] = numpy.stack([c * x - s * y, s * x + c * y], axis=1)
        return forces, numpy.array([f[4] for f in self.found])
