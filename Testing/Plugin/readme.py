"""What README.md has in it to be run."""

import pathlib
import re
import sys

README = (pathlib.Path(sys.argv[1]) / "README.md").read_text()


def block(language, part):
    """The block of code in that language that has `part` in it."""
    found = [text for text in re.findall(rf"```{language}\n(.*?)```", README, re.S) if part in text]
    assert len(found) == 1, f"{len(found)} blocks of {language} with {part}"
    return found[0]
