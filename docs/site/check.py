#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks a built site as readers see it: every link and picture of every page, and in headless
Chromium the search, the gallery's handles, both themes, the values under the cursor of
relievo.show(), and that no page is wider than a telephone.

    check.py SITE [PICTURES]     SITE: the folder that tools/site made; PICTURES: for screenshots

Exit status: 0, or 1 with a line for each fault.
"""

import functools
import html.parser
import http.server
import inspect
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import urllib.parse

import numpy
import relievo

TELEPHONE = (390, 844)
SCREEN = (1280, 900)
LONGEST = 200_000  # bytes of a page of the reference
# Words that users search for, and the page that the search lists first.
FIRST = {"shadow map": "shadows.html", "K matrix": "cameras.html", "depth buffer": "layers.html",
         "tone mapping": "passes/Tone.html", "install": "install.html"}


class Page(html.parser.HTMLParser):
    """The links, the pictures without words, and the places of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.places, self.wordless = [], set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if values.get("id"):
            self.places.add(values["id"])
        for name in ("href", "src"):
            if values.get(name):
                self.links.append(values[name])
        if tag == "img" and not (values.get("alt") or "").strip():
            self.wordless.append(values.get("src"))


def links(site):
    """What is wrong with the links and pictures of all pages."""
    paths = [path for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    pages = {path: Page(path) for path in paths}
    for path, page in pages.items():
        name = path.relative_to(site)
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https", "mailto", "data", "javascript"):
                continue
            target = path
            if parts.path:
                target = (path.parent / urllib.parse.unquote(parts.path)).resolve()
                if target.is_dir():
                    target /= "index.html"
                if not target.is_file():
                    yield f"{name}: {link} leads nowhere"
                    continue
            place = urllib.parse.unquote(parts.fragment)
            if place and target in pages and place not in pages[target].places:
                yield f"{name}: {link}: there is no such place"
        for source in page.wordless:
            if "notebooks" not in name.parts:
                yield f"{name}: the picture {source} has no words"
        if name.parts[0] == "api" and path.stat().st_size > LONGEST:
            yield f"{name} has {path.stat().st_size} bytes, more than {LONGEST}"
    if len(pages) < 20:
        yield f"{site} has {len(pages)} pages"


class Browser:
    """Headless Chromium on a server of the folder."""

    def __init__(self, site, scratch):
        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

        self.scratch = scratch
        self.asked = 0
        handler = functools.partial(Handler, directory=site)
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def run(self, path, *words, size=SCREEN):
        address = f"http://127.0.0.1:{self.server.server_address[1]}/{path}"
        return subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--force-device-scale-factor=1", f"--user-data-dir={self.scratch}",
             f"--window-size={size[0]},{size[1]}", "--virtual-time-budget=15000", *words, address],
            capture_output=True, text=True, timeout=120, check=True).stdout

    def found(self, path, script, size=SCREEN):
        """What a script of JavaScript says of a page: it runs in a frame around it."""
        frame = f"""<!doctype html><meta charset=utf-8><body style="margin:0">
<iframe src="/{path}" style="border:0;width:{size[0]}px;height:{size[1]}px"></iframe><script>
const frame = document.querySelector("iframe");
const later = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
frame.addEventListener("load", async () => {{
  await later(3000);
  const page = frame.contentDocument, view = frame.contentWindow;
  document.body.dataset.found = JSON.stringify(await (async () => {{ {script} }})());
}});</script>"""
        self.probe.write_text(frame, encoding="utf-8")
        self.asked += 1  # an address of its own: one that was written in this second may be kept
        text = self.run(f"{self.probe.name}?{self.asked}", "--dump-dom", size=size)
        body = text[text.index("<body"):]

        class Found(html.parser.HTMLParser):
            value = None

            def handle_starttag(self, tag, attributes):
                if tag == "body":
                    Found.value = dict(attributes).get("data-found")

        Found().feed(body[:body.index(">") + 1])
        return json.loads(Found.value) if Found.value else None


def in_browser(site, browser, pictures):
    browser.probe, browser.shown = site / "_probe.html", site / "_shown.html"
    try:
        count = browser.found(
            "search.html?q=penumbra", "return page.querySelectorAll('ul.search li').length")
        if not count:
            yield f"search.html: 'penumbra' finds {count}"
        none = browser.found(
            "search.html?q=xyzzyplugh", "return page.querySelectorAll('ul.search li').length")
        if none != 0:
            yield f"search.html: 'xyzzyplugh' finds {none}"
        for query, page in FIRST.items():
            first, words = browser.found(f"search.html?q={urllib.parse.quote(query)}", """
                const found = page.querySelector("ul.search li");
                return [found?.querySelector("a")?.getAttribute("href"),
                        found?.querySelector("p.context")?.textContent];""") or (None, None)
            if not first or not first.startswith(page):
                yield f"search.html: '{query}' finds {first} first, and not {page}"
            if not words:
                yield f"search.html: '{query}' shows nothing of {page}"
        listed = set(browser.found("python.html", """
            return [...page.querySelectorAll(".page-toc a")].flatMap(
              (link) => link.textContent.trim().split(", "));""") or ())
        functions = {name for name in relievo.__all__ if inspect.isfunction(getattr(relievo, name))}
        if functions - listed:
            yield f"python.html: 'On this page' lacks {', '.join(sorted(functions - listed))}"
        cut = browser.found("api/Shadows.html", """
            const shown = page.querySelector(".page-toc").getBoundingClientRect();
            return [...page.querySelectorAll(".page-toc a code, .page-toc a .pre")]
              .filter((name) => name.getBoundingClientRect().right > shown.right)
              .map((name) => name.textContent);""")
        if cut != []:
            yield f"api/Shadows.html: 'On this page' cuts off {cut}"
        prose = browser.found("gallery.html", """
            return [...page.querySelectorAll("pre")].map((block) => block.textContent)
              .filter((text) => text.includes("]("));""")
        if prose != []:
            yield f"gallery.html: blocks of lines hold prose: {prose}"
        cut = browser.found("gallery.html", """
            const pair = page.querySelector(".pair"), handle = pair.querySelector("input");
            const at = () => view.getComputedStyle(pair.querySelectorAll("img")[1]).clipPath;
            const before = at();
            handle.value = 20; handle.dispatchEvent(new view.Event("input"));
            return [before, at()];""")
        if not cut or cut[0] == cut[1]:
            yield f"gallery.html: the handle of a pair moves nothing: {cut}"
        colors = browser.found("index.html", """
            const color = () => view.getComputedStyle(page.body).backgroundColor;
            return ["light", "dark"].map((theme) => {
              page.documentElement.dataset.theme = theme; return color(); });""")
        if not colors or colors[0] == colors[1]:
            yield f"index.html: light and dark have one background: {colors}"
        for page in ("index.html", "gallery.html", "which-shadows.html", "charts/README.html",
                     "python.html", "api/functions.html", "api/Shadows.html"):
            wide = browser.found(page, """
                const texts = page.querySelectorAll("article :is(h1, h2, h3, p, dt)");
                const ends = [...texts].filter((text) => !text.closest("table")).map(
                  (text) => Math.round(text.getBoundingClientRect().left + text.scrollWidth));
                return Math.max(page.documentElement.scrollWidth, ...ends);""", size=TELEPHONE)
            if wide is None or wide > TELEPHONE[0]:
                yield f"{page}: {wide} pixels wide on a telephone of {TELEPHONE[0]}"
        broken = browser.found("index.html", """
            for (const image of page.images) image.loading = "eager";
            await later(1000);
            return [...page.images].filter((image) => !image.naturalWidth).map((i) => i.src);""")
        if broken != []:
            yield f"index.html: pictures that are not shown: {broken}"
        numbers = numpy.arange(12000, dtype=numpy.float32).reshape(100, 120)
        relievo.show(relievo.to_image({"first": -numbers, "second": numbers}), path=browser.shown)
        told = browser.found(browser.shown.name, """
            page.querySelectorAll("button")[1].click();
            await later(200);
            const image = page.querySelector("img"), box = image.getBoundingClientRect();
            const at = { clientX: box.left + 0.625 * box.width,
                         clientY: box.top + 0.305 * box.height };
            image.dispatchEvent(new view.PointerEvent("pointermove", at));
            await later(500);
            return page.querySelector("output").value;""")
        if told != f"row 30, column 75\nsecond: {numbers[30, 75]:.0f}":
            yield f"relievo.show: the value under the cursor: {told!r}"
        schemes = browser.found(browser.shown.name, """
            const found = [];
            for (const light of ["true", "false"]) {
              document.body.dataset.jpThemeLight = light;
              const other = document.createElement("iframe");
              other.src = frame.src;
              document.body.append(other);
              await new Promise((done) => other.addEventListener("load", done));
              const root = other.contentDocument.documentElement;
              found.push(other.contentWindow.getComputedStyle(root).colorScheme);
            }
            return found;""")
        if schemes != ["light", "dark"]:
            yield f"relievo.show: in JupyterLab's themes, light and dark, it is {schemes}"
    finally:
        browser.probe.unlink(missing_ok=True)
        browser.shown.unlink(missing_ok=True)
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
        for page in ("index", "guide", "gallery", "install", "python", "shadows", "api/Shadows"):
            for name, size in (("screen", SCREEN), ("telephone", TELEPHONE)):
                file = pictures / f"{page.replace('/', '-')}-{name}.png"
                browser.run(f"{page}.html", f"--screenshot={file}", size=size)


def main():
    if not 2 <= len(sys.argv) <= 3:
        raise SystemExit(__doc__)
    site = pathlib.Path(sys.argv[1]).resolve()
    pictures = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) == 3 else None
    faults = list(links(site))
    with tempfile.TemporaryDirectory() as scratch:
        faults += in_browser(site, Browser(site, scratch), pictures)
    for fault in faults:
        print(fault)
    if faults:
        raise SystemExit(1)
    print(f"{site.name}: links, pictures, search and pairs are right")


main()
