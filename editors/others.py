#!/usr/bin/env python3
"""What is given to editors that no package index of this system has: Helix and Zed. Their configuration is read by their own rules, as
their manuals have them, the shell lines of the pages are run, and the queries are compiled against the grammar."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import tree_sitter

EDITORS = Path(__file__).resolve().parent
ROOT = EDITORS.parent
sys.path.insert(0, str(EDITORS / "tree-sitter-mech"))

from corpus import tree_sitter_parser  # noqa: E402

# Keys of a language in languages.toml, and the first parts of scopes: docs.helix-editor.com, Languages and Themes.
HELIX_KEYS = {"name", "language-id", "scope", "injection-regex", "file-types", "shebangs", "roots", "auto-format", "comment-token"}
HELIX_KEYS |= {"comment-tokens", "block-comment-tokens", "indent", "language-servers", "grammar", "formatter", "soft-wrap", "text-width"}
HELIX_SCOPES = {"attribute", "type", "constructor", "constant", "string", "comment", "variable", "label", "punctuation", "keyword"}
HELIX_SCOPES |= {"operator", "function", "tag", "namespace", "special", "markup", "diff"}
# Parts of a scope that have a name of their own there: another name has no colour.
HELIX_MEMBERS = {"constant.numeric", "variable.other.member", "variable.parameter", "type.builtin", "constant.builtin"}
# Keys of config.toml and of extension.toml, and captures of highlights.scm: zed.dev, Language Extensions.
ZED_KEYS = {"name", "grammar", "path_suffixes", "line_comments", "tab_size", "hard_tabs", "first_line_pattern", "brackets"}
ZED_BRACKETS = {"start", "end", "close", "newline", "surround", "not_in"}
ZED_EXTENSION = {"id", "name", "description", "version", "schema_version", "authors", "repository", "language_servers", "grammars"}
ZED_CAPTURES = {"attribute", "boolean", "comment", "constant", "constructor", "embedded", "emphasis", "enum", "function", "hint"}
ZED_CAPTURES |= {"keyword", "label", "link_text", "link_uri", "number", "operator", "predictive", "preproc", "primary", "property"}
ZED_CAPTURES |= {"punctuation", "string", "tag", "text", "title", "type", "variable", "variant"}


def check(holds, what):
    if not holds:
        sys.exit(f"others.py: {what}")


def blocks(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", page, flags=re.MULTILINE | re.DOTALL)


def run(lines, folder, home):
    """Runs lines of a page in a shell, as an author does."""
    environment = {**os.environ, "HOME": str(home), "PATH": f"{home}/bin:{os.environ['PATH']}"}
    subprocess.run(["bash", "-euo", "pipefail", "-c", lines], cwd=folder, env=environment, check=True)


def colours(query, scopes):
    """Compiles a query and counts what it colours in an example; every colour has to be known."""
    parser = tree_sitter_parser()
    compiled = tree_sitter.Query(parser.language, query)
    text = (ROOT / "examples" / "crank-slider.mech").read_bytes()
    found = tree_sitter.QueryCursor(compiled).captures(parser.parse(text).root_node)
    names = set(re.findall(r"@([a-z_.]+)", re.sub(r";.*", "", query)))
    unknown = {name for name in names if name.split(".")[0] not in scopes}
    check(not unknown, f"unknown colours {unknown}")
    check({"keyword", "comment", "type"} <= found.keys(), f"colours of the example: {sorted(found)}")
    return names, sum(map(len, found.values()))


def helix(home):
    page = (EDITORS / "helix" / "README.md").read_text()
    (settings,) = blocks(page, "toml")
    settings = tomllib.loads(settings.replace("/path/to/assur", str(ROOT)))
    (language,), (grammar,) = settings["language"], settings["grammar"]
    check(language.keys() <= HELIX_KEYS, f"unknown keys {language.keys() - HELIX_KEYS}")
    check(set(language["language-servers"]) <= settings["language-server"].keys(), "a server that is not defined")
    check(settings["language-server"]["assur"] == {"command": "assur", "args": ["lsp"]}, "the server")
    check(language["name"] == grammar["name"] and re.fullmatch(language["injection-regex"], "mech"), "the names")
    check((Path(grammar["source"]["path"]) / "src" / "parser.c").is_file(), "no parser at the path of the grammar")
    (home / "bin").mkdir()
    (home / "bin" / "hx").write_text("#!/bin/sh\n[ \"$*\" = '--grammar build' ]\n")
    (home / "bin" / "hx").chmod(0o755)
    for lines in blocks(page, "sh"):
        run(lines, ROOT, home)
    query = (home / ".config" / "helix" / "runtime" / "queries" / "mech" / "highlights.scm").read_text()
    names, count = colours(query, HELIX_SCOPES)
    check(HELIX_MEMBERS <= names and not names & {"number", "property", "variable.member"}, f"names of Helix: {names}")
    return count


def zed(home):
    # a copy of what Zed compiles, which it takes from a repository
    for folder in ("zed", "tree-sitter-mech"):
        shutil.copytree(EDITORS / folder, home / "editors" / folder, ignore=shutil.ignore_patterns("target"))
    git = ["git", "-c", "user.name=a", "-c", "user.email=a@b", "-c", "init.defaultBranch=trunk"]
    for words in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "all"]):
        subprocess.run([*git, *words], cwd=home, check=True)
    page = (EDITORS / "zed" / "README.md").read_text()
    for lines in blocks(page, "sh"):
        run(lines, home, home)
    extension = tomllib.loads((home / "editors" / "zed" / "extension.toml").read_text())
    language = tomllib.loads((home / "editors" / "zed" / "languages" / "mech" / "config.toml").read_text())
    check(extension.keys() <= ZED_EXTENSION, f"unknown keys {extension.keys() - ZED_EXTENSION}")
    check(language.keys() <= ZED_KEYS, f"unknown keys {language.keys() - ZED_KEYS}")
    check(all(pair.keys() <= ZED_BRACKETS for pair in language["brackets"]), "unknown keys of brackets")
    check(extension["language_servers"]["assur"]["languages"] == [language["name"]], "the language of the server")
    grammar = extension["grammars"][language["grammar"]]
    # what Zed does with it
    clone = home / "grammars"
    for words in (["init", "-q", clone], ["-C", clone, "remote", "add", "origin", grammar["repository"]]):
        subprocess.run(["git", *words], check=True)
    subprocess.run(["git", "-C", clone, "fetch", "-q", "--depth", "1", "origin", grammar["rev"]], check=True)
    subprocess.run(["git", "-C", clone, "checkout", "-q", grammar["rev"]], check=True)
    check((clone / grammar["path"] / "src" / "parser.c").is_file(), "no parser in the repository")
    return colours((home / "editors" / "zed" / "languages" / "mech" / "highlights.scm").read_text(), ZED_CAPTURES)[1]


def main():
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
        counts = helix(Path(one)), zed(Path(other))
    print(f"Helix, Zed: configuration, lines of the pages, {counts[0]} and {counts[1]} colours in an example")


if __name__ == "__main__":
    main()
