#!/usr/bin/env python3
"""Static analysis of the files of a compilation database: clang-tidy for each whose preprocessed text it has not found
good before. What was good is remembered in ~/.cache/penumbra-lint by a hash of that text, of the command, of .clang-tidy
and of the version of the tool, so that only what changed takes time, whatever the folder of the checkout.

usage: lint_files.py BUILD_FOLDER FOLDER...      (the files of the database in these folders)
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

DAYS_KEPT = 30


def output_of(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, **options).stdout


def main():
    build, *folders = sys.argv[1:]
    root = os.getcwd()
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "penumbra-lint"
    cache.mkdir(parents=True, exist_ok=True)
    for known in cache.iterdir():
        if known.stat().st_mtime < time.time() - DAYS_KEPT * 86400:
            known.unlink()
    rules = output_of("clang-tidy", "--version") + pathlib.Path(".clang-tidy").read_bytes()

    def complaints_about(entry):
        file, folder = entry["file"], entry["directory"]
        words = shlex.split(entry["command"])
        compiler = [word for word in words if os.path.basename(word) != "ccache"][0]
        options = words[words.index(compiler) + 1:words.index("-o")]
        text = output_of(compiler, *options, "-E", "-C", file, cwd=folder)
        hashed = b"\0".join([rules, text] + [os.fsencode(option) for option in options])
        known = cache / hashlib.sha256(hashed.replace(os.fsencode(root), b"")).hexdigest()
        if not known.exists():
            run = subprocess.run(["clang-tidy", "-quiet", file, "--", *options], cwd=folder, capture_output=True, text=True)
            if run.returncode != 0:
                return run.stdout + run.stderr
        known.touch()
        return ""

    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        # Each file once, though the fuzzers compile some of them again with other options.
        entries = {entry["file"]: entry for entry in reversed(json.load(file))
                   if entry["file"].endswith(".cpp")
                   and any(entry["file"].startswith(os.path.join(root, folder, "")) for folder in folders)}
    good = True
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for complaints in pool.map(complaints_about, entries.values()):
            if complaints:
                good = False
                print(complaints, flush=True)
    return 0 if good and entries else 1


if __name__ == "__main__":
    sys.exit(main())
