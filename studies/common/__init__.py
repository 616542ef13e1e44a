# SPDX-License-Identifier: Apache-2.0
"""Common parts of the studies: tables, expectations, and the style of figures."""
