"""A question for PrairieLearn, written by `assur course`: its rows, their answers, and what other answers mean."""

import math
import os

# what is said of an answer
WORDS = @WORDS@

# of each answer: its unit as pint writes it, empty where a plain number is asked for, and its weight
ANSWERS = @ANSWERS@

# of each row: what the page shows, the worked solution, and of each answer the right one and intervals, of which the
# first that contains a number counts: middle, half the width, part of the mark, place in WORDS
ROWS = [
@ROWS@]

PREFIXES = {"": 1.0, "kilo": 1e3, "milli": 1e-3, "centi": 1e-2, "deci": 0.1, "deca": 10.0, "hecto": 100.0}
PREFIXES |= {"mega": 1e6, "micro": 1e-6, "giga": 1e9, "nano": 1e-9}
POUND, FOOT, G = 0.45359237, 0.3048, 9.80665
# size in SI units; powers of metre, kilogram and second
UNITS = {
    "meter": (1.0, 1, 0, 0),
    "inch": (FOOT / 12, 1, 0, 0),
    "foot": (FOOT, 1, 0, 0),
    "gram": (1e-3, 0, 1, 0),
    "metric_ton": (1e3, 0, 1, 0),
    "pound": (POUND, 0, 1, 0),
    "slug": (POUND * G / FOOT, 0, 1, 0),
    "second": (1.0, 0, 0, 1),
    "minute": (60.0, 0, 0, 1),
    "hour": (3600.0, 0, 0, 1),
    "radian": (1.0, 0, 0, 0),
    "degree": (math.pi / 180, 0, 0, 0),
    "turn": (2 * math.pi, 0, 0, 0),
    "revolutions_per_minute": (math.pi / 30, 0, 0, -1),
    "revolutions_per_second": (2 * math.pi, 0, 0, -1),
    "hertz": (1.0, 0, 0, -1),
    "newton": (1.0, 1, 1, -2),
    "force_kilogram": (G, 1, 1, -2),
    "force_pound": (POUND * G, 1, 1, -2),
    "joule": (1.0, 2, 1, -2),
    "watt": (1.0, 2, 1, -3),
    "horsepower": (550 * FOOT * POUND * G, 2, 1, -3),
    "metric_horsepower": (75 * G, 2, 1, -3),
    "pascal": (1.0, -1, 1, -2),
    "bar": (1e5, -1, 1, -2),
}


def row_of(data):
    """The row of a student: a seed always has the same one."""
    return ROWS[int(data["variant_seed"]) % len(ROWS)]


def generate(data):
    """Fills the page of a variant, and its answers."""
    row = row_of(data)
    data["params"].update(row["params"])
    for name, (right, _) in row["answers"].items():
        data["correct_answers"][name] = right
    if row["solution"]:
        folder = data.get("options", {}).get("question_path", ".")
        with open(os.path.join(folder, row["solution"]), encoding="utf-8") as file:
            data["params"]["solution"] = file.read()


def size_of(unit):
    """The size of a unit in SI units, and its dimension."""
    size, powers, sign = 1.0, [0.0, 0.0, 0.0], 1
    for word in unit.replace(" ** ", "^").split():
        if word in ("*", "/"):
            sign = 1 if word == "*" else -1
            continue
        name, _, power = word.partition("^")
        power = sign * float(power or 1)
        prefix = next(p for p in PREFIXES if name.startswith(p) and name[len(p) :] in UNITS)
        one, *its = UNITS[name[len(prefix) :]]
        size *= (PREFIXES[prefix] * one) ** power
        powers = [old + power * new for old, new in zip(powers, its)]
    return size, powers


def number_of(text, unit):
    """An answer in the unit of the right one; None where its own unit is not among UNITS, or is of another dimension."""
    try:
        if not unit:
            return float(text)
        number, _, its = text.partition(" ")
        (size, powers), (wanted, same) = size_of(its), size_of(unit)
        return float(number) * (size / wanted) if powers == same else None
    except (AttributeError, ArithmeticError, StopIteration, TypeError, ValueError):
        return None


def grade(data):
    """Names the mistake of every answer, and gives it its part of the mark."""
    scores = data["partial_scores"]
    for name, (_, intervals) in row_of(data)["answers"].items():
        unit, weight = ANSWERS[name]
        x = number_of(data["submitted_answers"].get(name), unit)
        if x is None:
            # the element knows more units, and its mark stays
            continue
        hit = next((one for one in intervals if abs(x - one[0]) <= one[1]), None)
        scores[name] = {"score": hit[2] if hit else 0.0, "weight": weight}
        if hit:
            scores[name]["feedback"] = WORDS[hit[3]]
    weights = sum(one.get("weight", 1) for one in scores.values())
    marks = sum(one.get("weight", 1) * (one.get("score") or 0.0) for one in scores.values())
    data["score"] = marks / weights if weights else 0.0
