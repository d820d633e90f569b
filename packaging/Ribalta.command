#!/bin/sh
# Double-click (macOS, Linux): opens the window of Ribalta. The first time it installs what it needs, some minutes.
cd "$(dirname "$0")/.." && exec python3 run.py "$@"
