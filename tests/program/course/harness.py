"""Runs a question as PrairieLearn would, without its elements: `server.py` of this folder, and requests on standard input."""

import json
import sys

server = {}
with open("server.py", encoding="utf-8") as file:
    exec(compile(file.read(), "server.py", "exec"), server)


def data(seed, submitted):
    return {
        "variant_seed": seed,
        "params": {},
        "correct_answers": {},
        "submitted_answers": submitted,
        "partial_scores": {},
        "options": {"question_path": "."},
    }


def said(seed, name, submitted):
    one = data(seed, {name: submitted})
    server["grade"](one)
    score = one["partial_scores"].get(name)
    return score and [score["score"], score.get("feedback", "")]


def verdict(seed, name, x, own, size, other):
    """What is said of a number, which may have another unit; nothing near a border."""
    text = lambda number, unit: f"{number!r} {unit}" if own else number
    near = [said(seed, name, text(x * part, own)) for part in (1.0, 1 - 1e-5, 1 + 1e-5)]
    if near.count(near[0]) < 3:
        return None
    assert not own or said(seed, name, text(x / size, other)) == near[0], (name, x, own, other)
    return near[0]


def variant(seed):
    one = data(seed, {})
    server["generate"](one)
    return [one["params"], one["correct_answers"]]


request = json.load(sys.stdin)
if request == "rows":
    print(json.dumps([server["ROWS"], server["ANSWERS"], server["WORDS"]]))
elif isinstance(request, int):
    print(json.dumps([variant(seed) for seed in range(request)]))
else:
    print(json.dumps([verdict(*one) for one in request]))
