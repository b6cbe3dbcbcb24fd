"""Writes a question of Moodle per row: numerical answers with the picture of their own values.

    python moodle.py engine.mech rows.csv > questions.xml
"""

import csv
import sys
from html import escape

import assur

QUESTION = """<question type="numerical">
<name><text>{name}</text></name>
<questiontext format="html"><text><![CDATA[{text}]]></text></questiontext>
<answer fraction="100"><text>{answer}</text><tolerance>{tolerance}</tolerance></answer>
</question>"""


def questions(path, rows, within=0.02):
    """A question per row and answer."""
    for number, row in enumerate(rows, 1):
        values = {head.split(" [")[0]: f"{cell} {head.partition('[')[2].rstrip(']')}" for head, cell in row.items()}
        problem = assur.load(path, set=values)
        solution = problem.solve().to(units="file")
        given = ", ".join(f"{name} = {value}" for name, value in values.items())
        for name in [name for name in solution if name not in problem.drives]:
            answer = solution[name][0]
            asked = f"<p>{escape(given)}. Find {escape(name)} in {escape(solution.units[name])}.</p>{problem.draw()}"
            yield QUESTION.format(
                name=escape(f"{number}: {name}"), text=asked, answer=answer, tolerance=abs(answer) * within
            )


if __name__ == "__main__":
    with open(sys.argv[2], newline="", encoding="utf-8") as table:
        found = "\n".join(questions(sys.argv[1], csv.DictReader(table)))
    print(f'<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n{found}\n</quiz>')
