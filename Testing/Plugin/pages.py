"""README.md and the pages in Plugin/Help, and the scripts and tasks in them."""

import pathlib
import re
import sys

REPOSITORY = pathlib.Path(sys.argv[1])
HELP = REPOSITORY / "Plugin" / "Help"
PAGES = [REPOSITORY / "README.md", *sorted(HELP.glob("*.md"))]


def blocks(page, language):
    """The blocks of code in that language, in order."""
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(), re.S)


def block(language, part):
    """The block of code in that language that has `part` in it."""
    found = [text for page in PAGES for text in blocks(page, language) if part in text]
    assert len(found) == 1, f"{len(found)} blocks of {language} with {part}"
    return found[0]
