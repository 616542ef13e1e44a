# SPDX-License-Identifier: Apache-2.0
"""Planted values, and fits that must recover them."""
