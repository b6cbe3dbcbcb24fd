"""The three machines in Exudyn: one step of the trapezoidal rule from position to position; joints are constraints, one
more turns the crank uniformly. Sensors keep the forces of all joints and the torque on the crank."""
import exudyn
import numpy
from exudyn import itemInterface as item
from machines import COUNT, CUTS, SPEED, STEP, TREES, mass


class Machine:
    def __init__(self, name, pose):
        self.name, self.pose = name, pose
        self.settings = s = exudyn.SimulationSettings()
        s.timeIntegration.numberOfSteps = COUNT
        s.timeIntegration.endTime = COUNT * STEP
        s.timeIntegration.newton.useModifiedNewton = True
        s.timeIntegration.generalizedAlpha.useIndex2Constraints = True
        s.timeIntegration.generalizedAlpha.useNewmark = True
        s.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
        s.solution.file.write = False
        s.solution.sensors.writePeriod = STEP
        s.linearSolver.solverType = exudyn.LinearSolverType.EXUdense
        s.parallel.numberOfThreads = 1

    def ready(self):
        """Builds the machine anew: a turn ends elsewhere than it began. Not timed."""
        self.container = exudyn.SystemContainer()
        self.system = system = self.container.AddSystem()
        bodies, nodes = {"ground": system.AddObject(item.ObjectGround())}, {}
        for _, _, link in TREES[self.name].values():
            m, _, inertia = mass(link)
            points, turned = self.pose["points"], self.pose["links"][link]
            centre = points["piston.C" if link == "piston" else f"{link}.S"]
            node = system.AddNode(item.Rigid2D(
                referenceCoordinates=[*centre["position"], turned["angle"]],
                initialVelocities=[*centre["velocity"], turned["omega"]]))
            nodes[link] = node
            bodies[link] = system.AddObject(item.RigidBody2D(mass=m, inertia=inertia, nodeNumber=node))
            at = system.AddMarker(item.MarkerBodyPosition(bodyNumber=bodies[link]))
            system.AddLoad(item.Force(markerNumber=at, loadVector=[0, -9.81 * m, 0]))

        def marker(link, x, y):
            back = mass(link)[1] if link != "ground" else 0.0
            return system.AddMarker(item.MarkerBodyPosition(bodyNumber=bodies[link], localPosition=[x - back, y, 0]))

        def sensor(joint):
            force = exudyn.OutputVariableType.Force
            return system.AddSensor(item.SensorObject(objectNumber=joint, storeInternal=True, outputVariableType=force))

        self.forces = {}
        for pair, (before, (x, y), link) in TREES[self.name].items():
            if link == "piston":
                on = [system.AddMarker(item.MarkerBodyRigid(bodyNumber=bodies[b])) for b in ("ground", "piston")]
                # it gives no force of a guide
                system.AddObject(item.PrismaticJoint2D(markerNumbers=on, axisMarker0=[1, 0, 0], normalMarker1=[0, 1, 0]))
            else:
                on = [marker(before, x, y), marker(link, 0, 0)]
                self.forces[pair] = sensor(system.AddObject(item.RevoluteJoint2D(markerNumbers=on)))
        for pair, (one, p, two, q) in CUTS[self.name].items():
            self.forces[pair] = sensor(system.AddObject(item.RevoluteJoint2D(markerNumbers=[marker(one, *p), marker(two, *q)])))
        fixed = system.AddMarker(item.MarkerNodeCoordinate(nodeNumber=system.AddNode(item.PointGround()), coordinate=0))
        angle = system.AddMarker(item.MarkerNodeCoordinate(nodeNumber=nodes["crank"], coordinate=2))
        drive = item.CoordinateConstraint(markerNumbers=[fixed, angle], velocityLevel=True, offset=SPEED)
        self.torque = sensor(system.AddObject(drive))
        system.Assemble()

    def turn(self):
        self.system.SolveDynamic(self.settings)

    def answers(self):
        of = lambda sensor: self.system.GetSensorStoredData(sensor)[:COUNT, 1:]
        return {pair: of(sensor)[:, :2] for pair, sensor in self.forces.items()}, of(self.torque)[:, 0]
