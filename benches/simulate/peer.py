"""What every peer prints: the least time of its runs alone, on the processor, and the angles at the end."""
import json
import math
import sys
import time

BUDGET = 20.0  # s


def report(run, ready=lambda: None):
    """`ready` is not timed. The last word of the command line says how often."""
    times, spent = [], time.process_time()
    for _ in range(int(sys.argv[-1])):
        ready()
        begin = time.process_time()
        angles, evaluations = run()
        times.append(time.process_time() - begin)
        if time.process_time() - spent > BUDGET:
            break
    angles = {name: float(angle) for name, angle in angles.items()}
    known = {name: angle if math.isfinite(angle) else None for name, angle in angles.items()}
    print(json.dumps({"seconds": min(times), "angles": known, "evaluations": evaluations}))
