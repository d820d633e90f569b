"""Entry of the frozen program, and of its trial after a build (packaging/smoke.py)."""

import os
import sys

import no_opengl

if getattr(sys, "frozen", False):
    no_opengl.stand_in()
if sys.platform.startswith("linux"):  # plugins of the desktop's own Qt are of another build
    os.environ.pop("QT_PLUGIN_PATH", None)
    # of the platforms only these two are packed
    if os.environ.get("QT_QPA_PLATFORM") != "offscreen":
        os.environ["QT_QPA_PLATFORM"] = "xcb"
if "RIBALTA_CHILD" in os.environ:
    from core import child

    child.main()
elif "RIBALTA_SMOKE" in os.environ:
    import window_smoke

    sys.exit(window_smoke.main(os.environ["RIBALTA_SMOKE"]))
else:
    from app.__main__ import main

    sys.exit(main())
