"""In all Markdown of the project: links lead to files that exist, anchors to headings, pictures are there. The help
pages are all in their list of contents; files of the project that pages name exist, and the page that maps the
paper to the kernel names all of the kernel."""

import re
import sys

from pages import HELP, PAGES, REPOSITORY

sys.path.insert(0, str(HELP))
from convert import slug  # noqa: E402

CODE = re.compile(r"```.*?```", re.S)


def anchors(page):
    return [slug(heading) for heading in re.findall(r"^#+ (.+)$", CODE.sub("", page.read_text()), re.M)]


def check_links(page):
    faults = []
    for match in re.findall(r"\]\(([^)\s]+)\)|<img [^>]*src=\"([^\"]+)\"", CODE.sub("", page.read_text())):
        target = "".join(match)
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = page.parent / path if path else page
        if not file.exists():
            faults.append(f"{page}: {target} does not exist")
        elif anchor and anchor not in anchors(file):
            faults.append(f"{page}: {target}: no such heading")
    return faults


def check_names(page):
    """What looks like a path from the project's folder."""
    return [f"{page}: {name} does not exist"
        for name in re.findall(r"(?<![\w./])(?:Data|Filters|Plugin|Testing)/[\w./-]*\w", page.read_text())
        if not (REPOSITORY / name).exists()]


def check_kernel():
    """Every header of the kernel, as Room/Name, and nothing else."""
    page = REPOSITORY / "Filters" / "Kernel" / "README.md"
    named = set(re.findall(r"`(\w+/\w+)`", page.read_text()))
    there = {f"{header.parent.name}/{header.stem}" for header in page.parent.glob("*/*.h")}
    return [f"{page} does not name {name}" for name in sorted(there - named)] + \
        [f"{page} names {name}, which is not there" for name in sorted(named - there)]


def markdown():
    for page in REPOSITORY.rglob("*.md"):
        folders = page.relative_to(REPOSITORY).parts[:-1]
        if "build" not in folders and not any(folder.startswith(".") for folder in folders):
            yield page


listed = re.findall(r"\]\((\S+\.md)\)", (HELP / "README.md").read_text())
faults = [f"{page.name} is not in the contents" for page in HELP.glob("*.md")
    if page.name not in listed + ["README.md"]] + check_kernel()
for page in markdown():
    faults += check_links(page)
for page in PAGES:
    faults += check_names(page)
assert not faults, "\n".join(faults)
