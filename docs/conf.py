"""Sphinx: the handbook, made by scripts/handbook."""

import os

project = "Toolpace"
extensions = ["myst_parser"]
exclude_patterns = ["README.md", "FORMATS.md", "SOURCES.md"]  # the latter two are included by pages
version = release = os.environ.get("TOOLPACE_VERSION", "")
html_theme = "alabaster"
html_theme_options = {"page_width": "1100px", "description": "Plans the motion of CNC machines"}
html_show_copyright = False
html_copy_source = False
highlight_language = "none"
myst_heading_anchors = 3
suppress_warnings = ["myst.header", "misc.highlighting_failure", "ref.myst"]
