"""The program without its window."""

import os

# openpyxl would read and write by lxml where that is installed, past defusedxml: one way, the safe one, everywhere
os.environ["OPENPYXL_LXML"] = "False"
