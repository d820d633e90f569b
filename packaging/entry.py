"""Entry of the frozen program, and of its second process in a cold start (core.compile_beside)."""

import os
import sys

if "RIBALTA_KERNELS_BESIDE" in os.environ:
    from core import compile_beside

    compile_beside.main()
else:
    from app.__main__ import main

    sys.exit(main())
