"""Builds mutants into one program and wakes them one by one, each for the tests that are asked about it.

The tool that changes the source lets all tests of a program judge; a survivor would cost minutes. Here each test is asked
of which the table says that it is about the file, until one fails.
"""

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

# A change may allocate without an end.
MEMORY = 8 << 30
ENVIRONMENT = {
    # The numbers that property tests draw, as .cargo/config.toml has them; failures leave no file.
    "PROPTEST_RNG_SEED": "1980",
    "PROPTEST_DISABLE_FAILURE_PERSISTENCE": "1",
    "INSTA_UPDATE": "no",
    "CARGO_INCREMENTAL": "0",
    "RAYON_NUM_THREADS": "1",
    "RUST_MIN_STACK": str(16 << 20),
    # What is inlined is compiled again and again, with all its mutants.
    "RUSTFLAGS": "-Cllvm-args=-inline-threshold=5",
}


def built(root, work, selected, package, names, targets):
    """Builds mutants and tests: the plan, and the programs by the names of their targets."""
    options = ["--profile=mutants", f"--package={package}", "--all-features", "--memory=off", "--no-relaunch", "--progress=never"]
    only = [f"--include-test={target}" for target in targets]
    which = [f"--artifact-dir={work}", *(f"--mutant={name}" for name in names)]
    # Asked are no tests: what is wanted is what has been built by the time that they would be.
    command = ["cargo", "gamma", "run", *selected, *options, *only, *which, "--", "no test has this name"]
    began = time.time()

    def sessions():
        found = (root / "target/cargo-gamma/cache").glob("*/testing-session.json")
        return [session for session in found if session.stat().st_mtime > began]

    print(f"building {len(names)} mutants of {package} ...", flush=True)
    tool = subprocess.Popen(command, cwd=root, env=os.environ | ENVIRONMENT, start_new_session=True)
    while tool.poll() is None:
        if sessions():
            os.killpg(tool.pid, signal.SIGINT)
            tool.wait()
        time.sleep(0.2)
    fresh = sessions()
    if not fresh:
        sys.exit(f"cargo gamma ended with {tool.returncode} and has built nothing")
    session = json.loads(fresh[0].read_text())
    programs = {}
    for binary in session["session"]["binaries"]:
        target = "unit" if binary["target_kind"] == "lib" else binary["target"]
        programs[target] = (binary["path"], binary["manifest_dir"])
    return session["plan"]["mutants"], programs


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


class Question:
    """Some tests of a program."""

    def __init__(self, programs, words):
        target, *filters = words.split()
        program, self.folder = programs[target]
        self.command = [program, "--test-threads=1", *filters]
        self.limit = 600
        began = time.time()
        if self.end({}) != "passed":
            sys.exit(f"`{' '.join(self.command)}` fails or does not end without any change")
        # Beside another one, and a change may be slower without being endless.
        self.limit = 5 + 5 * (time.time() - began)

    def end(self, extra):
        process = subprocess.Popen(
            self.command,
            cwd=self.folder,
            env=os.environ | ENVIRONMENT | extra,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            preexec_fn=limited,
        )

        def kill():
            # And what it has started, in whatever group.
            subprocess.run(["pkill", "-KILL", "-s", str(process.pid)], check=False)

        is_late = threading.Event()
        timer = threading.Timer(self.limit, lambda: (is_late.set(), kill()))
        timer.start()
        # The first test that fails is enough.
        has_failed = any(line.startswith(b"test ") and line.endswith(b"FAILED\n") for line in process.stdout)
        is_over = not has_failed and process.wait() == 0
        timer.cancel()
        kill()
        process.wait()
        if has_failed or is_over:
            return "caught" if has_failed else "passed"
        return "out of time" if is_late.is_set() else "caught"


def woken(mutants, programs, questions_of, tell):
    """Wakes mutants, and tells what comes of each."""
    known, noticed = {}, {}
    asked = {mutant["file"]: questions_of(mutant["file"]) for mutant in mutants}
    # The measure of time is taken before anything else runs.
    for words in sorted({words for of_file in asked.values() for words in of_file}):
        known[words] = Question(programs, words)
        print(f"  {words}: at most {known[words].limit:.0f} s", flush=True)

    scratch = Path(tempfile.mkdtemp())

    def end(mutant):
        if mutant["outcome"] == "CompileError":
            return "not compiled"
        reach = scratch / mutant["id"]
        extra = {"GAMMA_ACTIVE": str(mutant["ordinal"]), "GAMMA_REACH": str(reach)}
        is_reached = False
        # What has noticed the one before often notices this.
        first = noticed.get(mutant["file"])
        for words in sorted(asked[mutant["file"]], key=lambda words: words != first):
            end = known[words].end(extra)
            if end != "passed":
                noticed[mutant["file"]] = words
                return end
            seen = reach.read_bytes() if reach.exists() else b""
            is_reached |= mutant["ordinal"].to_bytes(4, sys.byteorder) in (seen[k : k + 4] for k in range(0, len(seen), 4))
        return "survived" if is_reached else "not reached"

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        # What is of another feature or platform is not built, and has no end.
        is_there = [mutant for mutant in mutants if mutant["outcome"] != "NotBuilt"]
        ends = {pool.submit(end, mutant): mutant for mutant in is_there}
        for future in as_completed(ends):
            tell(ends[future], future.result())
    shutil.rmtree(scratch)
