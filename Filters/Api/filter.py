"""A public header as Doxygen is to read it: on stdout.

    filter.py HEADER

The properties that classes share, macros of vtkCartesianProperties.h, stand in the classes that have them, each with its
paragraph of the macro's comment. Comments behind the values of enumerations are theirs. What all VTK classes have is left
out.
"""

import pathlib
import re
import sys

SHARED = pathlib.Path(__file__).resolve().parents[1] / "vtkCartesianProperties.h"
MACRO = re.compile(r"/\*\*\n((?: \*.*\n)+?) \*/\n#define (vtk\w+Macro)\(\)\s*\\\n((?:.*\\\n)+.*\n)")
EVERYWHERE = re.compile(r"^ *(static \w+\* New\(\);|void PrintSelf\(.*\n)", re.M)


def commented(text, member):
    return f"///@{{\n/**\n{text}\n */\n{member}\n///@}}\n"


def documented(comment, body):
    """The members of a macro with the paragraphs of its comment. A paragraph begins with the name of a property, or is
    of all."""
    paragraphs = re.split(r"\n *\n", "\n".join(line[3:] for line in comment.splitlines()))
    of = {match[1]: text for text in paragraphs if (match := re.match(r"(\w+), ", text))}
    of |= {match[1]: text for text in of.values() if (match := re.search(r"one of (\w+)", text))}
    public = re.sub(r"\s*\\\n", "\n", body.partition("protected:")[0])
    members = re.findall(r"^  (?:enum.*\n  \{(?:.*\n)*?  \};|vtk\w+Macro\(.*|void .*\n(?=  \{))", public, re.M)
    return "public:\n" + "".join(commented(_paragraph(of, member, comment), member.strip().removesuffix(";") + ";")
        for member in members)


def _paragraph(of, member, comment):
    name = re.match(r"\s*(?:enum (\w+)|vtk\w+Macro\((\w+)|void Set(\w+?)To)", member)
    return of.get(name and next(filter(None, name.groups())), comment)


def filtered(text, shared):
    for comment, macro, body in MACRO.findall(shared):
        text = text.replace(f"  {macro}();\n", documented(comment, body))
    text = EVERYWHERE.sub("", text)
    return re.sub(r"(^ +\w+ =\s+\w+,?) +// ", r"\1 ///< ", text, flags=re.M)


if __name__ == "__main__":
    print(filtered(pathlib.Path(sys.argv[1]).read_text(), SHARED.read_text()))
