# SPDX-License-Identifier: Apache-2.0
"""What Python's server of worker processes imports before it forks workers.

It ignores Ctrl-C once it serves, and is started with it blocked, so that while it imports this it does not end with a
traceback. What has come in the meantime is dropped here: the program that asks for workers has received it as well.
"""

from __future__ import annotations

import signal
from contextlib import suppress

from . import __version__ as __version__  # the package, which workers then have

if hasattr(signal, "pthread_sigmask"):
    with suppress(KeyboardInterrupt):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
