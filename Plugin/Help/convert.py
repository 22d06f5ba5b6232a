"""The pages in this folder as HTML for ParaView's Help.

    convert.py contents                  prints Qt Help's table of contents
    convert.py pages CMARK XML FOLDER    writes all pages, and the pictures they show, into FOLDER

CMARK is cmark-gfm, GitHub's own converter. A page that is called as a proxy in XML, group.name.md, ends with
the documentation of its properties. README.md becomes index.html. ParaView shows the
HTML in a QTextBrowser, which knows little CSS.
"""

import pathlib
import re
import shutil
import struct
import subprocess
import sys
import textwrap
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
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


def paragraphs(element):
    """The text of an element's Documentation, as Markdown."""
    return textwrap.dedent(element.findtext("Documentation", "").strip("\n")).strip()


def properties(proxy):
    """The panel of a proxy, group by group, as Markdown."""
    groups = {}  # the properties' names by the groups' labels
    for group in proxy.iter("PropertyGroup"):
        groups.setdefault(group.get("label"), []).extend(part.get("name") for part in group.iter("Property"))
    shown = {child.get("name"): child for child in proxy
        if child.tag.endswith("Property") and child.find("Documentation") is not None
        and child.get("panel_visibility") != "never"}
    grouped = {name for names in groups.values() for name in names}
    parts = [("", [name for name in shown if name not in grouped]), *groups.items()]
    lines = ["## Properties"] if shown else []
    for label, names in parts:
        lines += [f"### {label}"] * bool(label)
        for name in names:
            if name in shown:
                advanced = " (advanced)" if shown[name].get("panel_visibility") == "advanced" else ""
                lines.append(f"**{shown[name].get('label', name)}**{advanced}: {paragraphs(shown[name])}")
    return "\n\n".join(lines)


def proxies(xml):
    """{group.name: its element}"""
    return {f"{group.get('name')}.{proxy.get('name')}": proxy
        for group in ElementTree.parse(xml).getroot() for proxy in group}


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


def convert(cmark, xml, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    known = proxies(xml)
    for page in sorted(HERE.glob("*.md")):
        text = page.read_text()
        if page.stem in known:
            text += "\n" + properties(known[page.stem])
        html = subprocess.run([cmark, "--unsafe", "-e", "table"], input=text, check=True, capture_output=True, text=True).stdout
        (folder / html_name(page.name)).write_text(PAGE.format(title=title(text), body=for_help(html, folder)))


if __name__ == "__main__":
    if sys.argv[1] == "contents":
        print(contents())
    else:
        convert(*sys.argv[2:4], pathlib.Path(sys.argv[4]))
