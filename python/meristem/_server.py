# SPDX-License-Identifier: Apache-2.0
"""Python's server of worker processes imports this module before it forks workers.

The running server ignores Ctrl-C. It starts with Ctrl-C blocked, so that an interrupt during this import causes no
traceback. This module drops interrupts that came in the meantime, because the calling program has received them as
well.
"""

from __future__ import annotations

import signal
from contextlib import suppress

from . import __version__ as __version__  # the package, which workers then have

if hasattr(signal, "pthread_sigmask"):
    with suppress(KeyboardInterrupt):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
