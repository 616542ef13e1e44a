# SPDX-License-Identifier: Apache-2.0
"""Tests that run a whole study, even a quick one, have the mark `slow`; `-m "not slow"` skips them."""

from __future__ import annotations

import pytest


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if "quick" in getattr(item, "fixturenames", ()) or "quick_study" in item.name:
            item.add_marker(pytest.mark.slow)
