"""A cell of nbgrader: the student's `Mb` is marked by the problem itself."""

import assur

# the student's answers, from the cell above
Mb = 472.5  # N*m
v = -13.4  # m/s

### BEGIN HIDDEN TESTS
problem = assur.load("engine.mech")
key = problem.batch({"r [mm]": [100]}, key=True).read()
graded = assur.grade(key, {"row": [1], "Mb [N*m]": [Mb], "v [m/s]": [v]}, within=0.01)
assert graded["right"] == graded["total"], graded
### END HIDDEN TESTS
