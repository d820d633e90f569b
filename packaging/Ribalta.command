#!/bin/sh
# Double-click (macOS, Linux): opens the window of Ribalta. The first time it installs what it needs, some minutes.
cd "$(dirname "$0")/.." || exit 1
for version in 3.14 3.13 3.12 3.11; do
    "python$version" -c "" 2>/dev/null && exec "python$version" run.py "$@"
done
exec python3 run.py "$@"
