#!/usr/bin/env python3
"""Compares the grammars of editors with the tokens of `assur` in every example.

`cargo test --test repository editors` writes those to target/tmp/tokens.txt. Every word, number, unit, text and comment has to
have the same place and kind in tree-sitter, TextMate and Pygments; and what is a word of the language for tree-sitter, which reads
whole statements, has to be one for the others, which read words.
"""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

EDITORS = Path(__file__).resolve().parent
ROOT = EDITORS.parent
sys.path[:0] = [str(EDITORS / "pygments"), str(EDITORS / "tree-sitter-mech")]

from pygments.token import Comment, Keyword, Name, Number, String, Whitespace  # noqa: E402
from pygments_mech import MechLexer  # noqa: E402
from pygments_mech import words  # noqa: E402
from corpus import tree_sitter_parser  # noqa: E402

SHOWN = 12


def read_tokens(lines, kind_of):
    """Tokens per file: {start: (end, kind, class)}."""
    files, tokens = {}, {}
    for line in lines:
        if line.startswith("\t"):
            start, end, name = line.split()
            kind, word = kind_of(name)
            if kind:
                tokens[int(start)] = (int(end), kind, word)
        elif line:
            tokens = files.setdefault(line, {})
    return files


def of_assur(name):
    return name, None


def of_textmate(scope):
    if scope.startswith(("keyword.operator", "punctuation")):
        return None, None
    for head, kind in (("comment", "Comment"), ("string", "Text"), ("constant.numeric", "Number"), ("keyword.other.unit", "Unit")):
        if scope.startswith(head):
            return kind, None
    classes = (("keyword", "word"), ("constant.language", "word"), ("support.type", "property"), ("support.function", "function"))
    return "Word", next((word for head, word in classes if scope.startswith(head)), "name")


def of_tree_sitter(parser, text):
    """Tokens of a text, and whether it has an error."""
    tree, tokens = parser.parse(text), {}
    kinds = {"comment": "Comment", "string": "Text", "number": "Number", "unit": "Unit"}
    names = {"identifier", "name", "pose_name", "row_name"}
    waiting = [tree.root_node]
    while waiting:
        node = waiting.pop()
        waiting += node.children
        if node.children and node.type != "name":
            continue
        kind, word = kinds.get(node.type), None
        if node.type in names:
            kind, word = "Word", class_of(node)
        elif not node.is_named and node.type[0].isalpha():
            kind, word = "Word", "property" if node.parent.type == "property" else "word"
        if kind:
            tokens[node.start_byte] = (node.end_byte, kind, word)
    return tokens, tree.root_node.has_error


def class_of(node):
    parent, text = node.parent, node.text.decode()
    if parent.type == "property" and parent.child_by_field_name("name") == node and text in words.PROPERTIES:
        return "property"
    if parent.type == "property" and text in words.VALUES:
        return "word"
    if parent.type == "call" and parent.child_by_field_name("function") == node and text in words.FUNCTIONS:
        return "function"
    if node.type == "name" and text in words.COLLECTIONS:
        return "function"
    return "name"


def of_pygments(lexer, text):
    tokens, at = {}, 0
    for _, token, value in lexer.get_tokens_unprocessed(text):
        start, at = at, at + len(value.encode())
        if token in Comment:
            kind, word = "Comment", None
        elif token in String:
            kind, word = "Text", None
        elif token in Number:
            kind, word = "Number", None
        elif token in Keyword.Type:
            kind, word = "Unit", None
        elif token in Keyword or (token in Name.Constant and value != "pi"):
            kind, word = "Word", "word"
        elif token in Name.Attribute:
            kind, word = "Word", "property"
        elif token in Name.Builtin:
            kind, word = "Word", "function"
        elif token in Name:
            kind, word = "Word", "name"
        else:
            continue
        if value.strip():
            tokens[start] = (at, kind, word)
    return tokens


def joined(tokens):
    """A number and its unit as one token."""
    found, last = {}, None
    for start in sorted(tokens):
        end, kind, word = tokens[start]
        if kind == "Unit" and last is not None and tokens[last][1] == "Number" and start - tokens[last][0] <= 2:
            found[last] = (end, "Number", None)
        else:
            found[start] = (end, kind, word)
        last = start
    return found


def compare(who, name, text, wanted, found, differences):
    for start in sorted(wanted.keys() | found.keys()):
        a, b = wanted.get(start), found.get(start)
        if a and b and a[:2] == b[:2]:
            continue
        end = (a or b)[0]
        piece = text[start:end].decode(errors="replace")
        differences.append(f"{who}: {name}: {piece!r} at byte {start} is {b and b[1]}, not {a and a[1]}")


def main():
    file = ROOT / "target" / "tmp" / "tokens.txt"
    assur = read_tokens(file.read_text().splitlines(), of_assur)
    names = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "examples").rglob("*.mech"))
    if names != sorted(assur):
        sys.exit(f"{file} is of other examples: cargo test --test repository editors")
    node = ["node", str(EDITORS / "vscode" / "test" / "tokens.mjs"), str(ROOT), *names]
    printed = subprocess.run(node, check=True, capture_output=True, text=True).stdout
    textmate = read_tokens(printed.splitlines(), of_textmate)
    parser, lexer = tree_sitter_parser(), MechLexer()
    differences, count, errors = [], Counter(), []
    for name in names:
        text = (ROOT / name).read_bytes()
        tree, has_error = of_tree_sitter(parser, text)
        if has_error:
            errors.append(name)
        pygments = of_pygments(lexer, text.decode())
        compare("tree-sitter", name, text, assur[name], tree, differences)
        compare("TextMate", name, text, assur[name], textmate[name], differences)
        compare("Pygments", name, text, joined(assur[name]), joined(pygments), differences)
        for who, tokens in (("TextMate", textmate[name]), ("Pygments", pygments)):
            for start, (end, kind, word) in tree.items():
                other = tokens.get(start)
                if kind == "Word" and other and other[:2] == (end, kind) and other[2] != word:
                    piece = text[start:end].decode()
                    line = text[:start].count(b"\n") + 1
                    differences.append(f"{who}: {name}:{line}: `{piece}` is a {other[2]}, not a {word}")
        count.update(kind for _, kind, _ in assur[name].values())
    blocks = 0
    for page in sorted((ROOT / "docs").glob("*.md")):
        for block in re.findall(r"^```mech.*?\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL):
            blocks += 1
            if of_tree_sitter(parser, block.encode())[1]:
                errors.append(f"{page.name}: {block[:400]}")
    for line in errors:
        print(f"tree-sitter: {line}: an ERROR node", file=sys.stderr)
    for line in differences[:SHOWN]:
        print(line, file=sys.stderr)
    kinds = ", ".join(f"{n} {kind.lower()}s" for kind, n in count.most_common())
    print(f"{len(names)} examples, {blocks} blocks of docs: {kinds}; {len(differences)} differences, {len(errors)} with errors")
    sys.exit(1 if differences or errors else 0)


main()
