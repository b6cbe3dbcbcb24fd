"""The three machines in MuJoCo: one step from position to position, soft constraints in the cut pins, a great inertia that
keeps the crank turning uniformly. Sensors give the forces in all pairs and the torque on the crank; `rollout` makes all steps
of a turn without Python between them."""
import mujoco
import numpy
from machines import COUNT, CUTS, LENGTHS, STEP, TREES, angles, mass, start
from mujoco import rollout

STATE = mujoco.mjtState.mjSTATE_FULLPHYSICS


def text(name):
    inner = {link: "" for link in LENGTHS} | {"piston": ""}
    for pair, (link, (x, y), other, (a, b)) in CUTS[name].items():
        # a body without mass: what it takes from its link is the force in the cut pin
        inner[link] += f'<body pos="{x} {y} 0"><site name="{pair}"/></body>'
        inner[other] += f'<site name="{pair}2" pos="{a} {b} 0"/>'

    def bodies(before):
        found = ""
        for pair, (parent, (x, y), link) in TREES[name].items():
            if parent == before:
                m, centre, inertia = mass(link)
                joint = 'type="slide" axis="1 0 0"' if link == "piston" else 'axis="0 0 1"'
                found += f'''<body pos="{x} {y} 0">
                    <inertial pos="{centre} 0 0" mass="{m}" diaginertia="{inertia} {inertia} {inertia}"/>
                    <joint name="{pair}" {joint} armature="{1e6 if link == "crank" else 0}"/>
                    <site name="{pair}"/>{inner[link]}{bodies(link)}</body>'''
        return found

    connects = "".join(f'<connect site1="{pair}" site2="{pair}2"/>' for pair in CUTS[name])
    forces = "".join(f'<force site="{pair}"/>' for pair in [*TREES[name], *CUTS[name]])
    return f'''<mujoco><option timestep="{STEP}" gravity="0 -9.81 0" tolerance="1e-15"><flag contact="disable"/></option>
        <default><equality solref="{2 * STEP} 1" solimp="0.9999 0.9999 0.001"/></default>
        <worldbody>{bodies("ground")}</worldbody><equality>{connects}</equality>
        <sensor>{forces}<torque site="A"/></sensor></mujoco>'''


class Machine:
    def __init__(self, name, pose):
        self.name = name
        self.model = mujoco.MjModel.from_xml_string(text(name))
        self.data = mujoco.MjData(self.model)
        self.columns = []
        for pair, (place, speed) in start(name, pose).items():
            column = self.model.joint(pair).qposadr[0]
            self.data.qpos[column], self.data.qvel[column] = place, speed
            self.columns.append(column)
        self.first = numpy.zeros(mujoco.mj_stateSize(self.model, STATE))
        mujoco.mj_getState(self.model, self.data, self.first, STATE)

    def turn(self):
        """A revolution: from the start, COUNT steps."""
        self.states, self.sensors = rollout.rollout(self.model, self.data, self.first[None, :], nstep=COUNT)

    def answers(self):
        """Forces of the pairs in the frame of the ground, and the torque. What sensors give belongs to the state before the step."""
        states = numpy.vstack([self.first, self.states[0, :-1]])
        turned = angles(self.name, states[:, 1:][:, self.columns])
        links = {pair: link for pair, (_, _, link) in TREES[self.name].items()}
        links |= {pair: cut[0] for pair, cut in CUTS[self.name].items()}
        forces = {}
        for i, (pair, link) in enumerate(links.items()):
            x, y = self.sensors[0, :, 3 * i], self.sensors[0, :, 3 * i + 1]
            c, s = numpy.cos(turned[link]), numpy.sin(turned[link])
            forces[pair] = numpy.stack([c * x - s * y, s * x + c * y], axis=1)
        return forces, self.sensors[0, :, -1]
