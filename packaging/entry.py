"""Entry of the frozen program, and of its second process in a cold start (core.study.precompile)."""

import os
import sys

if "RIBALTA_SECOND_PROCESS" in os.environ:
    from core.study import precompile

    precompile.main()
else:
    from app.__main__ import main

    sys.exit(main())
