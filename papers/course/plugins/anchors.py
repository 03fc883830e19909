"""The anchors of headings, as GitHub makes them."""

import re


def github_anchor(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
