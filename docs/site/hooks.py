"""Pages of the site that are made and not written: the front page from README.md, contributing.md and changelog.md from
their files, and the reference from what the programs say of themselves (build/bin, or the folder FOAMSIM_BIN)."""
import os
import re
import subprocess
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
FROM_ROOT = {"index.md": "README.md", "contributing.md": "CONTRIBUTING.md", "changelog.md": "CHANGELOG.md"}
COMMANDS = {
    "foamsim": ["run", "compare", "render", "inspect", "convert", "reproduce", "study", "sweep", "stats",
                "movie", "export-web", "view", "generate"],
    "multitracker": ["run", "study"],
}


def output_of(program, *arguments):
    binary = Path(os.environ.get("FOAMSIM_BIN", ROOT / "build" / "bin")) / program
    result = subprocess.run([binary, *arguments], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"{binary} {' '.join(arguments)} failed: {result.stderr.strip()}")
    return result.stdout


def page_from_root(name):
    """A page of the repository's root, its links as seen from docs/; those to sources are left as names."""
    text = (ROOT / FROM_ROOT[name]).read_text(encoding="utf-8")
    text = text.replace("](docs/", "](").replace('src="docs/', 'src="')
    for page, source in FROM_ROOT.items():
        text = text.replace(f"]({source})", f"]({page})")
    return re.sub(r"\[([^\]]+)\]\((?:LICENSE|examples/[^)]*|\.ci/[^)]*)\)", r"\1", text)


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def listing_as_tables(text):
    """`name: what` with indented lines `option  what (default x)` below, as headings and tables."""
    lines = []
    in_table = False
    for line in text.splitlines():
        option = re.match(r"^  (\S+) {2,}(.+?)(?: \(default (.*)\))?$", line)
        if option:
            if not in_table:
                lines += ["", "| option | what | default |", "|---|---|---|"]
            in_table = True
            default = option.group(3)
            lines.append(f"| `{option.group(1)}` | {cell(option.group(2))} | {f'`{cell(default)}`' if default else ''} |")
            continue
        in_table = False
        entry = re.match(r"^(\w[\w.-]*): (.+)$", line)
        if entry:
            lines += ["", f"### {entry.group(1)}", "", cell(entry.group(2))]
        elif line.endswith(":"):
            lines += ["", f"## {line[:-1].strip().capitalize()}", ""]
        elif line.strip():
            lines += ["", cell(line.strip())]
    return "\n".join(lines)


def reference():
    parts = ["# Scenes, effects, options", "", "What `foamsim scenes`, `foamsim effects` and `multitracker scenes` say.",
             'Classes and functions: <a href="api/index.html">reference of the C++ libraries</a>.', "",
             listing_as_tables(output_of("foamsim", "scenes")), "", listing_as_tables(output_of("foamsim", "effects")),
             "", "# The tracker's scenes", "", listing_as_tables(output_of("multitracker", "scenes"))]
    return "\n".join(parts)


def commands():
    parts = ["# Commands"]
    for program, names in COMMANDS.items():
        for name in names:
            parts += ["", f"## {program} {name}", "", "```text", output_of(program, name, "--help").strip(), "```"]
    return "\n".join(parts)


GENERATED = {"reference.md": reference, "commands.md": commands, **{n: None for n in FROM_ROOT}}


def on_files(files, config):
    for file in [f for f in files if f.src_path.startswith("site/")]:
        files.remove(file)
    for name in GENERATED:
        files.append(File(name, config["docs_dir"], config["site_dir"], config["use_directory_urls"]))
    return files


def on_page_read_source(page, config):
    name = page.file.src_path
    if name in FROM_ROOT:
        return page_from_root(name)
    if name in GENERATED:
        return GENERATED[name]()
    return None
