"""The program and the files that its answers are compared with."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session", autouse=True)
def in_the_repository() -> None:
    """Files are named from the top of the repository, as in the program's messages."""
    import os

    os.chdir(ROOT)


def program(*args: str) -> subprocess.CompletedProcess[str]:
    """Runs the program of the package."""
    command = [sys.executable, "-m", "assur", *args]
    return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False, encoding="utf-8")


def documents(files: list[str]) -> dict[str, list[dict]]:
    """The program's JSON about files, by file; a file with variants has several."""
    found: dict[str, list[dict]] = {}
    for line in program("solve", "--format", "json", *files).stdout.splitlines():
        document = json.loads(line)
        found.setdefault(document["file"], []).append(document)
    return found


def files(folder: str) -> list[str]:
    """The problems below a folder."""
    return sorted(str(path.relative_to(ROOT)) for path in (ROOT / folder).rglob("*.mech"))


@pytest.fixture(scope="session")
def engine() -> str:
    """A crank-slider with all reactions."""
    return (ROOT / "examples/variants/crank-slider.mech").read_text(encoding="utf-8")
