#!/usr/bin/env python3
"""Breaks a copy of the program in one place after the other and expects a test to notice (README.md).

    tests/mutants/run.py [--jobs N] [--work FOLDER] [NAME ...]

Exit code 0: every mutant is caught. 1: one is not, or its patch no longer applies, or a test fails without it."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LONGEST_TEST = 900  # seconds; a mutant that never ends is caught


class Mutant:
    """A patch, and the tests that should notice it: a program below tests/ and a filter of GoogleTest."""

    def __init__(self, path):
        self.name = path.stem
        self.patch = path.read_text()
        self.sentence = re.search(r"^Mutant: (.+)$", self.patch, re.M).group(1)
        self.program, self.tests = re.search(r"^Tests: (\S+) (\S+)$", self.patch, re.M).groups()
        self.files = re.findall(r"^\+\+\+ b/(\S+)$", self.patch, re.M)


class Copy:
    """A copy of the files that git tracks, and its build. Both stay between runs, so that the next one is quick."""

    def __init__(self, folder, jobs, flags):
        self.tree = folder
        self.build_folder = folder / "build" / "release"  # at the usual place below it, for ccache
        self.jobs = jobs
        self.flags = flags

    def update(self):
        names = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                               check=True, capture_output=True, text=True).stdout.split("\0")
        names = {name for name in names if name and (ROOT / name).is_file()}
        for name in names:
            self.restore(name)
        for folder in (entry for entry in self.tree.iterdir() if entry.is_dir() and entry != self.tree / "build"):
            for path in folder.rglob("*"):
                if path.is_file() and str(path.relative_to(self.tree)) not in names:
                    path.unlink()

    def restore(self, name):
        """Makes a file what it is in the project, and leaves its time alone if it is that already."""
        ours, theirs = ROOT / name, self.tree / name
        if theirs.is_file() and theirs.read_bytes() == ours.read_bytes():
            return
        theirs.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ours, theirs)

    def configure(self):
        return run(["cmake", "-G", "Ninja", "-S", self.tree, "-B", self.build_folder, "-DCMAKE_BUILD_TYPE=Release",
                    "-DPENUMBRA_ISAS=avx2", "-DPENUMBRA_TESTS=ON", "-DPENUMBRA_WINDOW=OFF",
                    f"-DCMAKE_PROJECT_penumbra_INCLUDE={self.tree}/tests/mutants/quick_kernels.cmake", *self.flags])

    def build(self, program):
        return run(["cmake", "--build", self.build_folder, "-j", str(self.jobs), "--target", program.split("/")[-1]])

    def test(self, mutant):
        """The tests that fail, and how many ran."""
        try:
            result = run([self.build_folder / "tests" / mutant.program, "--gtest_brief=1",
                          f"--gtest_filter={mutant.tests}"], timeout=LONGEST_TEST, cwd=self.build_folder)
        except subprocess.TimeoutExpired:
            return ["a test that never ends"], 1
        failed = re.findall(r"^\[  FAILED  \] ([\w/]+\.[\w/]+)(?:,| \()", result.stdout, re.M)
        if result.returncode != 0 and not failed:
            failed = [f"the program (code {result.returncode})"]
        ran = re.search(r"^\[==========\] (\d+) tests? ", result.stdout, re.M)
        return list(dict.fromkeys(failed)), int(ran.group(1)) if ran else 0

    def apply(self, mutant):
        return run(["patch", "-p1", "--forward", "--fuzz=2", "--no-backup-if-mismatch", "-r", "-", "-d", self.tree],
                   input=mutant.patch)


def run(command, **options):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", **options)


def tell(name, verdict, more, seconds=None):
    took = "" if seconds is None else f"{seconds:5.0f} s"
    print(f"{name:30} {verdict:12} {took:8} {more}", flush=True)


def check_without_mutants(copy, mutants):
    """Whether all tests pass, and there are some, as long as nothing is broken."""
    good = True
    for mutant in {(m.program, m.tests): m for m in mutants}.values():
        start = time.monotonic()
        if (built := copy.build(mutant.program)).returncode != 0:
            sys.exit(f"the copy does not build without a mutant:\n{built.stdout[-3000:]}")
        failed, ran = copy.test(mutant)
        if failed or ran == 0:
            good = False
            tell(mutant.program, "NO TEST" if ran == 0 else "FAILS", f"without a mutant: {mutant.tests} {failed}")
        else:
            tell(mutant.program, "passes", f"{ran} tests without a mutant: {mutant.tests}", time.monotonic() - start)
    return good


def check(copy, mutant):
    """Whether the mutant is caught."""
    start = time.monotonic()
    try:
        if copy.apply(mutant).returncode != 0:
            tell(mutant.name, "NO PATCH", f"the patch no longer applies; make it anew for {', '.join(mutant.files)}")
            return False
        if (built := copy.build(mutant.program)).returncode != 0:
            error = re.search(r"error: .*", built.stdout)
            tell(mutant.name, "NO BUILD", error.group(0) if error else built.stdout[-300:])
            return False
        failed, _ = copy.test(mutant)
        verdict = "caught" if failed else "NOT CAUGHT"
        seen = ", ".join(failed[:3]) + (f" and {len(failed) - 3} more" if len(failed) > 3 else "")
        tell(mutant.name, verdict, f"by {seen}" if failed else mutant.sentence, time.monotonic() - start)
        return bool(failed)
    finally:
        for name in mutant.files:
            copy.restore(name)


def main():
    parser = argparse.ArgumentParser(description="Breaks a copy of the program and expects a test to notice.")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutants", help="where the copy is")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the compiler")
    parser.add_argument("--cmake-flags", default="", help="more options of CMake")
    parser.add_argument("--trust-tests", action="store_true", help="do not run the tests without mutants first")
    parser.add_argument("names", nargs="*", metavar="NAME", help="mutants, such as sampling-disk [all]")
    arguments = parser.parse_args()
    mutants = [Mutant(path) for path in sorted(HERE.glob("*.patch"))]
    if unknown := set(arguments.names) - {mutant.name for mutant in mutants}:
        sys.exit(f"there is no mutant {', '.join(sorted(unknown))}; there are {', '.join(m.name for m in mutants)}")
    mutants = [m for m in mutants if not arguments.names or m.name in arguments.names]

    copy = Copy(arguments.work.resolve(), arguments.jobs, arguments.cmake_flags.split())
    copy.update()
    if (configured := copy.configure()).returncode != 0:
        sys.exit(configured.stdout[-3000:])
    good = arguments.trust_tests or check_without_mutants(copy, mutants)
    caught = [check(copy, mutant) for mutant in mutants]
    print(f"{sum(caught)} of {len(mutants)} mutants are caught")
    return 0 if good and all(caught) else 1


if __name__ == "__main__":
    sys.exit(main())
