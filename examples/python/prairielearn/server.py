"""A PrairieLearn question: a crank-slider with a radius and a speed of its own for every student."""

import random

import assur


def generate(data):
    """Fills the data of a variant and its answers."""
    r, n = random.randrange(80, 125, 5), random.randrange(1200, 1850, 50)
    problem = assur.load("engine.mech", set={"r": f"{r} mm", "n": f"{n} rpm"})
    answers = problem.solve().to(units="file")
    data["params"] = {"r": r, "n": n, "scheme": str(problem.draw())}
    data["correct_answers"] = {"Mb": answers["Mb"][0], "v": answers["v"][0]}
