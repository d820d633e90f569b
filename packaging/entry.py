"""Entry of the frozen program, and of its second process in a cold start."""

import os
import sys

from core import compile_beside
from core.kernel_cache import BESIDE

if BESIDE in os.environ:
    compile_beside.main()
else:
    from app.__main__ import main

    sys.exit(main())
