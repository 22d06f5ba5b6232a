"""README.md and the pages in Plugin/Help, and the scripts and tasks in them."""

import pathlib
import re
import sys

REPOSITORY = pathlib.Path(sys.argv[1])
HELP = REPOSITORY / "Plugin" / "Help"
PAGES = [REPOSITORY / "README.md", *sorted(HELP.glob("*.md"))]


def reads_cad(program):
    """Whether the program that reads CAD files was built, or installed, with cartesian-mesher."""
    return any(pathlib.Path(program).parents[1].glob("libexec/*/read-cad"))


def blocks(page, language):
    """The blocks of code in that language, in order."""
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(), re.S)


def block(language, part):
    """The block of code in that language that has `part` in it."""
    found = [text for page in PAGES for text in blocks(page, language) if part in text]
    assert len(found) == 1, f"{len(found)} blocks of {language} with {part}"
    return found[0]
