"""`python with_exudyn.py SCENE gen-alpha STEP REPEATS`: Exudyn; rigid bodies in the plane, hinges as constraints of index 3 by
the generalised α method, of index 2 by the trapezoidal rule."""
import sys

import exudyn
from exudyn import itemInterface as item
from peer import report
from scenes import origins, scene, turn

found, method, step = scene(sys.argv[1]), sys.argv[2], float(sys.argv[3])
places = origins(found)
settings = exudyn.SimulationSettings()
integration = settings.timeIntegration
integration.numberOfSteps, integration.endTime = round(found.end / step), found.end
integration.newton.useModifiedNewton = True
integration.generalizedAlpha.computeInitialAccelerations = True
if method == "gen-alpha":
    integration.generalizedAlpha.spectralRadius = 0.9
else:
    integration.generalizedAlpha.useIndex2Constraints = True
    integration.generalizedAlpha.useNewmark = True
settings.solution.file.write = False
settings.solution.sensors.writePeriod = found.end
settings.show.computationTime = settings.show.statistics = False
integration.verboseMode = settings.staticSolver.verboseMode = 0
settings.linearSolver.solverType = exudyn.LinearSolverType.EXUdense if len(found.links) < 30 else exudyn.LinearSolverType.EigenSparse
settings.parallel.numberOfThreads = 1
state = {}


def ready():
    state["container"] = container = exudyn.SystemContainer()
    state["system"] = system = container.AddSystem()
    bodies, nodes = {"ground": system.AddObject(item.ObjectGround())}, {}
    rates = {link.name: link.rate for link in found.links}
    speeds = {"ground": (0.0, 0.0)}
    for link in found.links:
        x, y = turn(link.angle, *link.centre)
        before = found.links[found.index(link.before)] if link.before != "ground" else None
        # the pin moves with the link before
        vx, vy = speeds[link.before]
        if before:
            px, py = turn(before.angle, *before.points[link.pin[0]])
            vx, vy = vx - before.rate * py, vy + before.rate * px
        ox, oy = turn(link.angle, *link.points[link.pin[1]])
        speeds[link.name] = vx, vy = vx + link.rate * oy, vy - link.rate * ox
        place = [places[link.name][0] + x, places[link.name][1] + y, link.angle]
        nodes[link.name] = system.AddNode(item.Rigid2D(
            referenceCoordinates=place, initialVelocities=[vx - link.rate * y, vy + link.rate * x, rates[link.name]]))
        bodies[link.name] = system.AddObject(item.RigidBody2D(mass=link.mass, inertia=link.inertia, nodeNumber=nodes[link.name]))
        if found.gravity:
            at = system.AddMarker(item.MarkerBodyPosition(bodyNumber=bodies[link.name]))
            system.AddLoad(item.Force(markerNumber=at, loadVector=[0, -found.gravity * link.mass, 0]))

    def marker(name, point):
        if name == "ground":
            at = found.ground[point]
        else:
            link = found.links[found.index(name)]
            at = [a - b for a, b in zip(link.points[point], link.centre)]
        return system.AddMarker(item.MarkerBodyPosition(bodyNumber=bodies[name], localPosition=[*at, 0]))

    for link in found.links:
        system.AddObject(item.RevoluteJoint2D(markerNumbers=[marker(link.before, link.pin[0]), marker(link.name, link.pin[1])]))
    for one, p, two, q in found.loops:
        system.AddObject(item.RevoluteJoint2D(markerNumbers=[marker(one, p), marker(two, q)]))
    if found.spring:
        link, point, fixed, stiffness, free = found.spring
        on = [marker("ground", fixed), marker(link, point)]
        system.AddObject(item.SpringDamper(markerNumbers=on, stiffness=stiffness, referenceLength=free))
    if found.torque:
        on = system.AddMarker(item.MarkerBodyRigid(bodyNumber=bodies[found.torque[0]]))
        system.AddLoad(item.Torque(markerNumber=on, loadVector=[0, 0, found.torque[1]]))
    system.Assemble()
    state["nodes"] = nodes


def run():
    state["system"].SolveDynamic(settings)
    angle = lambda node: state["system"].GetNodeOutput(node, exudyn.OutputVariableType.Rotation)
    ends = {}
    for link in found.links:
        turned = angle(state["nodes"][link.name])
        ends[link.name] = float(turned if isinstance(turned, float) else turned[-1])
    return ends, integration.numberOfSteps


report(run, ready)
