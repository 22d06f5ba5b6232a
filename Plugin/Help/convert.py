"""The pages in this folder as HTML for ParaView's Help.

    convert.py contents                  prints Qt Help's table of contents
    convert.py pages CMARK FOLDER        writes all pages, and the pictures they show, into FOLDER

CMARK is cmark-gfm, GitHub's own converter. A page that is called as a proxy in XML, group.name.md, ends with
its properties: what they are, defaults, ranges and units. README.md becomes index.html. ParaView shows the
HTML in a QTextBrowser, which knows little CSS.
"""

import pathlib
import re
import shutil
import struct
import subprocess
import sys
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "Properties"))
from reference import panel, proxies  # noqa: E402
WIDEST = 700  # of a picture, in pixels

PAGE = """<!DOCTYPE html>
<html><head><meta charset="utf-8"/><title>{title}</title>
<style>pre, code {{ font-family: "DejaVu Sans Mono", "Consolas", "Menlo", monospace; white-space: pre }}</style></head>
<body>
{body}</body></html>
"""


def slug(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def title(text):
    return re.match(r"# (.+)", text)[1]


def html_name(markdown_name):
    stem = markdown_name.removesuffix(".md")
    return ("index" if stem == "README" else stem) + ".html"


def contents():
    """Headings and links of README.md as Qt Help's sections."""
    lines = []
    for heading, name, page in re.findall(r"^## (.+)$|^- \[(.+?)\]\((.+?\.md)\)",
                                          (HERE / "README.md").read_text(), re.M):
        if heading:
            lines += ["</section>"] * bool(lines) + [f'<section title={quoteattr(heading)} ref="index.html">']
        else:
            lines.append(f'<section title={quoteattr(name)} ref="{html_name(page)}"/>')
    return "\n".join(['<toc><section title="CartesianMesher" ref="index.html">', *lines, "</section></section></toc>"])


NOUNS = {int: ("whole number", "whole numbers"), float: ("number", "numbers"), str: ("text", "texts"),
    bool: ("switch", "switches"), "choice": ("choice", "choices")}


def written(value):
    """A value as the panel shows it."""
    if isinstance(value, list):
        return ", ".join(map(written, value)) or "none"
    if isinstance(value, bool):
        return "on" if value else "off"
    return re.sub("e-0", "e-", f"{value:g}") if isinstance(value, float) else str(value) or "none"


def paragraph(property):
    choices = [False, True] if property.kind is bool else None
    facts = " ".join(f"{what}: {text}." for what, text in property.facts(NOUNS, written, choices).items())
    advanced = " (advanced)" if property.is_advanced else ""
    return f"**{property.label}**{advanced}: {property.documentation()}\\\n*{facts}*"


def properties(proxy, known):
    """The panel of a proxy, group by group, as Markdown."""
    lines = []
    for label, members in panel(proxy, known).items():
        lines += [f"### {label}"] * bool(label and members)
        lines += map(paragraph, members)
    return "\n\n".join(["## Properties", *lines] if lines else [])


def png_width(path):
    return struct.unpack(">I", path.read_bytes()[16:20])[0]


def for_help(html, folder):
    """Links between pages lead to HTML; what lies elsewhere in the repository is named only. Pictures come along."""
    def link(match):
        target, text = match.groups()
        page, _, anchor = target.partition("#")
        if not page or re.match(r"https?:", target):
            return match[0]
        if "/" in page or not page.endswith(".md"):
            return text
        return f'<a href="{html_name(page)}{"#" + anchor if anchor else ""}">{text}</a>'

    def picture(match):
        source = HERE / match[1]
        shutil.copy(source, folder)
        wide = png_width(source) > WIDEST and "width=" not in match[0]
        return match[0].replace(match[1], source.name).replace("<img", f'<img width="{WIDEST}"' if wide else "<img")

    html = re.sub(r'<a href="([^"]*)">(.*?)</a>', link, html, flags=re.S)
    html = re.sub(r'<img [^>]*?src="([^"]+)"[^>]*>', picture, html)
    html = re.sub(r"<(h\d)>(.*?)</h\d>", lambda match: f'<{match[1]}><a name="{slug(re.sub("<.*?>", "", match[2]))}"></a>'
        f"{match[2]}</{match[1]}>", html)
    return html.replace("<table>", '<table border="1" cellspacing="0" cellpadding="4">')


def convert(cmark, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    known = proxies()
    for page in sorted(HERE.glob("*.md")):
        text = page.read_text()
        if page.stem in known:
            text += "\n" + properties(known[page.stem], known)
        html = subprocess.run([cmark, "--unsafe", "-e", "table"], input=text, check=True, capture_output=True, text=True).stdout
        (folder / html_name(page.name)).write_text(PAGE.format(title=title(text), body=for_help(html, folder)))


if __name__ == "__main__":
    if sys.argv[1] == "contents":
        print(contents())
    else:
        convert(sys.argv[2], pathlib.Path(sys.argv[3]))
