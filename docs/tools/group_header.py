#!/usr/bin/env python3
"""Input filter of Doxygen: puts a contract header into the group of its lab.

The lab is the one that the header's @file comment names; headers that name none are given code. The two
empty lines around the contents of the namespace give their place, so that line numbers stay.
"""
import re
import sys

text = open(sys.argv[1], encoding="utf-8").read()
lab = re.search(r"^/// \*\*Lab (\d+):", text, re.M)
group = f"apilab{lab.group(1)}" if lab else "apigiven"
text = re.sub(r"^namespace (cs550\S*) \{\n\n", rf"namespace \1 {{ /** @addtogroup {group}\n@{{ */\n", text, count=1, flags=re.M)
text = re.sub(r"\n\n\}  // namespace (cs550\S*)", r"\n/** @} */\n}  // namespace \1", text, count=1)
text = text.replace("**–**", "–")  # Doxygen ends bold text at a space only
sys.stdout.write(text)
