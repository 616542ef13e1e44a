# SPDX-License-Identifier: Apache-2.0
"""What studies share: tables, expectations, the look of figures."""
