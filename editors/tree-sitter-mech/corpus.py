#!/usr/bin/env python3
"""What `tree-sitter test` does, with the committed parser and without its program: the corpus, and that grammar.js has not changed
since the parser was made of it."""

import ctypes
import hashlib
import re
import subprocess
import sys
from pathlib import Path

import tree_sitter

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def tree_sitter_parser():
    """The committed parser, compiled with the system's compiler."""
    source = HERE / "src"
    library = ROOT / "target" / "tmp" / "mech.so"
    library.parent.mkdir(parents=True, exist_ok=True)
    files = [source / "parser.c", source / "scanner.c"]
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-I", source, *files, "-o", library], check=True)
    function = ctypes.CDLL(str(library)).tree_sitter_mech
    function.restype = ctypes.c_void_p
    capsule = ctypes.pythonapi.PyCapsule_New
    capsule.restype, capsule.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return tree_sitter.Parser(tree_sitter.Language(capsule(function(), b"tree_sitter.Language", None)))


def cases():
    """Name, text and tree of every case."""
    line = "=" * 80
    for file in sorted((HERE / "test" / "corpus").glob("*.txt")):
        parts = re.split(rf"^{line}\n(.*)\n{line}\n", file.read_text(), flags=re.MULTILINE)
        for name, case in zip(parts[1::2], parts[2::2]):
            text, tree = case.split("-" * 80)
            yield f"{file.stem}: {name}", text.removeprefix("\n").removesuffix("\n"), " ".join(tree.split())


def main():
    grammar = hashlib.sha256((HERE / "grammar.js").read_bytes()).hexdigest()
    wrong = []
    if (HERE / "src" / "grammar.sha256").read_text().strip() != grammar:
        wrong.append("grammar.js has changed: run editors/tree-sitter-mech/generate.sh")
    parser, count = tree_sitter_parser(), 0
    for name, text, wanted in cases():
        count += 1
        tree = re.sub(r"\w+: ", "", str(parser.parse(text.encode()).root_node)).replace(" )", ")")
        if tree != wanted.replace(" )", ")"):
            wrong.append(f"{name}\n  {tree}\n  {wanted}")
    print(f"tree-sitter: {count} cases", *wrong, sep="\n")
    sys.exit(1 if wrong or count == 0 else 0)


if __name__ == "__main__":
    main()
