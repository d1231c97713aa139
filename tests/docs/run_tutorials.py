"""run_tutorials.py BUILD SOURCE: runs the sh and python blocks of docs/tutorials, a page in an empty folder each, as a reader
would from the repository's folder. Blocks marked `console` are not run: they take long or change the machine."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BUILD, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
# Left out where the build, or the machine, has none.
HAS_BLENDER = shutil.which("blender") is not None
HAS_PYTHON = (BUILD / "python" / "foamsim" / "__init__.py").exists()


def run_page(page, folder):
    """The blocks' commands, in order; the first that fails ends it."""
    (folder / "build").symlink_to(BUILD)
    for name in ("plots", "assets", "examples"):
        (folder / name).symlink_to(SOURCE / name)
    blocks = re.findall(r"^```(\w+)\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert blocks, f"{page.name} has no blocks"
    python = "".join(text for kind, text in blocks if kind == "python")
    programs = [["bash", "-euc", text] for kind, text in blocks
                if kind == "sh" and (HAS_BLENDER or not text.startswith("blender "))]
    if python and HAS_PYTHON:
        programs.append(["/usr/bin/python3", "-B", "-c", python])
    for program in programs:
        environment = {**os.environ, "PYTHONPATH": str(BUILD / "python"), "NO_COLOR": "1"}
        done = subprocess.run(program, cwd=folder, env=environment, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{page.name}: exit {done.returncode} of\n{program[-1]}\n{done.stdout}{done.stderr}")


pages = sorted((SOURCE / "docs" / "tutorials").glob("*.md"))
assert pages, "no tutorials"
for tutorial in pages:
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        run_page(tutorial, Path(scratch))
    print(f"{tutorial.name} runs, {time.monotonic() - start:.1f} s")
