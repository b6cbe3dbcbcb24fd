"""`python with_mujoco.py SCENE INTEGRATOR STEP REPEATS`: MuJoCo; a tree of hinges, its loops closed by soft constraints."""
import math
import sys

import mujoco
import numpy
from mujoco import rollout
from peer import report
from scenes import origins, scene, turn

found, integrator, step = scene(sys.argv[1]), sys.argv[2], float(sys.argv[3])
STATE = mujoco.mjtState.mjSTATE_FULLPHYSICS
places = origins(found)
angle_of = {"ground": 0.0} | {link.name: link.angle for link in found.links}


def sites(link):
    return "".join(f'<site name="{link.name}.{point}" pos="{x!r} {y!r} 0"/>' for point, (x, y) in link.points.items())


def bodies(before):
    text = ""
    for link in (link for link in found.links if link.before == before):
        base, angle = places[before], angle_of[before]
        x, y = turn(-angle, places[link.name][0] - base[0], places[link.name][1] - base[1])
        at = link.points[link.pin[1]]
        text += f'''<body pos="{x!r} {y!r} 0" euler="0 0 {link.angle - angle!r}">
            <inertial pos="{link.centre[0]!r} {link.centre[1]!r} 0" mass="{link.mass!r}" diaginertia="{link.inertia!r} {link.inertia!r} {link.inertia!r}"/>
            <joint name="{link.name}" axis="0 0 1" pos="{at[0]!r} {at[1]!r} 0"/>{sites(link)}{bodies(link.name)}</body>'''
    return text


ground = "".join(f'<site name="ground.{point}" pos="{x!r} {y!r} 0"/>' for point, (x, y) in found.ground.items())
loops = "".join(f'<connect site1="{one}.{p}" site2="{two}.{q}"/>' for one, p, two, q in found.loops)
tendon = ""
if found.spring:
    link, point, fixed, stiffness, free = found.spring
    tendon = f'''<tendon><spatial stiffness="{stiffness}" springlength="{free}"><site site="{link}.{point}"/><site site="ground.{fixed}"/></spatial></tendon>'''
motor = f'<actuator><motor joint="{found.torque[0]}"/></actuator>' if found.torque else ""
text = f'''<mujoco><compiler angle="radian" inertiafromgeom="false" balanceinertia="true" boundmass="0" boundinertia="0"/>
    <option timestep="{step!r}" integrator="{integrator}" gravity="0 {-found.gravity!r} 0" tolerance="1e-15"><flag contact="disable"/></option>
    <default><equality solref="{2 * step!r} 1" solimp="0.9999 0.9999 0.001"/></default>
    <worldbody>{ground}{bodies("ground")}</worldbody><equality>{loops}</equality>{tendon}{motor}</mujoco>'''
model = mujoco.MjModel.from_xml_string(text)
data = mujoco.MjData(model)
first = {link.name: link.rate - (found.links[found.index(link.before)].rate if link.before != "ground" else 0.0) for link in found.links}
for name, rate in first.items():
    data.qvel[model.joint(name).dofadr[0]] = rate
if found.torque:
    data.ctrl[0] = found.torque[1]
begin = numpy.zeros(mujoco.mj_stateSize(model, STATE))
mujoco.mj_getState(model, data, begin, STATE)
count = round(found.end / step)
control = numpy.full((1, count, model.nu), found.torque[1]) if found.torque else None


def run():
    states, _ = rollout.rollout(model, data, begin[None, :], control=control, nstep=count)
    q = states[0, -1, 1 : 1 + model.nq]
    ends = {"ground": 0.0}
    # a link stands behind the one it hangs on
    for link in found.links:
        before = angle_of[link.before]
        ends[link.name] = ends[link.before] + link.angle - before + q[model.joint(link.name).qposadr[0]]
    del ends["ground"]
    return ends, count * (4 if integrator == "RK4" else 1)


report(run)
