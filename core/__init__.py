"""The program without its window."""

import os

# openpyxl would write by lxml where that is installed: one way everywhere
os.environ["OPENPYXL_LXML"] = "False"
