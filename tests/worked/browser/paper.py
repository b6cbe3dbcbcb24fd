"""What a printed page shows, read from the PDF that Chromium writes: segments of lines, and how far down its marks go."""

import re
import zlib

TOKEN = re.compile(rb"\((?:\\.|[^\\)])*\)|<[0-9A-Fa-f\s]*>|[^\s\[\]()<>]+|[\[\]]")


def product(a, b):
    """First a, then b."""
    return [a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3],
            a[4] * b[0] + a[5] * b[2] + b[4], a[4] * b[1] + a[5] * b[3] + b[5]]


def moved(m, x, y):
    return (m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5])


def pages(pdf):
    """The contents of the pages, in order."""
    objects = {int(m[1]): m.end() for m in re.finditer(rb"(?:^|\n)(\d+) 0 obj", pdf)}
    found = []
    for start in objects.values():
        head = pdf[start:pdf.index(b"endobj", start)]
        if not re.search(rb"/Type\s*/Page\b", head):
            continue
        at = objects[int(re.search(rb"/Contents (\d+) 0 R", head)[1])]
        begin = pdf.index(b"stream", at)
        begin += 8 if pdf[begin + 6:begin + 8] == b"\r\n" else 7
        # what follows the compressed bytes is left over
        found.append(zlib.decompressobj().decompress(pdf[begin:]))
    return found


class Page:
    """The segments of a page in points, and where its lowest mark is."""

    def __init__(self, contents):
        self.segments, self.lowest = [], 842.0
        at, text, stack, numbers, point = [1, 0, 0, 1, 0, 0], None, [], [], (0, 0)
        for token in TOKEN.findall(contents):
            try:
                numbers.append(float(token))
                continue
            except ValueError:
                pass
            if token == b"q":
                stack.append(at)
            elif token == b"Q" and stack:
                at = stack.pop()
            elif token == b"cm":
                at = product(numbers[-6:], at)
            elif token == b"Tm":
                text = product(numbers[-6:], at)
                self.lowest = min(self.lowest, text[5])
            elif token in (b"m", b"l"):
                to = moved(at, *numbers[-2:])
                if token == b"l":
                    self.segments.append((point, to))
                    self.lowest = min(self.lowest, to[1])
                point = to
            numbers = []

    def bars(self, tick=2.0):
        """Lengths in mm of what is drawn as a scale bar is: a line, and a tick of 2 mm at both its ends."""
        mm = lambda s: (abs(s[1][0] - s[0][0]) * 25.4 / 72, abs(s[1][1] - s[0][1]) * 25.4 / 72)
        sizes = [mm(s) for s in self.segments]
        upright = lambda s: s[0] < 0.02 and abs(s[1] - tick) < 0.1 * tick
        return [a[0] for a, b, c in zip(sizes, sizes[1:], sizes[2:]) if a[1] < 0.02 and a[0] > 1.0 and upright(b) and upright(c)]
