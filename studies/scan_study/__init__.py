# SPDX-License-Identifier: Apache-2.0
"""Compares scans of a digitised walnut with the true plant."""
